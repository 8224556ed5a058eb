// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/RangeSigma.h>

#include <cmath>
#include <limits>

namespace offmap::rawlog {

namespace {

/// Of all slots of a turn; empty if no observation tells any.
std::vector<float> intensitiesOf(const Turn& turn, const ScanClass& scanClass) {
    std::vector<float> all;
    bool any = false;
    for (const auto& obs : turn) {
        const std::vector<float> own = scanClass.intensities(*obs);
        any = any || !own.empty();
        all.insert(all.end(), own.begin(), own.end());
        if (own.empty()) {
            all.insert(all.end(), scanClass.slotCount(*obs),
                       std::numeric_limits<float>::quiet_NaN());
        }
    }
    return any ? all : std::vector<float>();
}

}  // namespace

double rangeSigmaAt(std::span<const double> table, double intensity) {
    size_t above = 0;  // the first pair that is brighter
    while (above < table.size() && table[above] <= intensity) above += 2;
    if (above == 0) return table[1];
    if (above == table.size()) return table[above - 1];
    const double low = table[above - 2], high = table[above];
    const double share = (intensity - low) / (high - low);
    return table[above - 1] + share * (table[above + 1] - table[above - 1]);
}

void findRangeSigmas(TurnScan& out, const Turn& turn, const ScanClass& scanClass,
                     const SensorConfig& config, double unknown) {
    out.scan.rangeSigma.clear();
    if (config.rangeSigmaByIntensity.empty()) return;
    const std::vector<float> intensities = intensitiesOf(turn, scanClass);
    if (intensities.empty()) return;
    out.scan.rangeSigma.reserve(out.scan.points.size());
    for (const uint32_t slot : out.scan.sourceIndex) {
        const double intensity = intensities.at(slot);
        const double sigma =
            std::isnan(intensity) ? unknown : rangeSigmaAt(config.rangeSigmaByIntensity, intensity);
        out.scan.rangeSigma.push_back(static_cast<float>(sigma));
    }
}

}  // namespace offmap::rawlog
