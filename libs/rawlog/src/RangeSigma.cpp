// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Intensities.h>
#include <offmap/rawlog/RangeSigma.h>

#include <cmath>

namespace offmap::rawlog {

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
    const size_t known = out.scan.rangeSigma.size();
    if (config.rangeSigmaByIntensity.empty() || known == out.scan.points.size()) return;
    const std::vector<float> intensities = slotIntensitiesOf(turn, scanClass);
    if (intensities.empty()) return;
    out.scan.rangeSigma.reserve(out.scan.points.size());
    for (const uint32_t slot : std::span(out.scan.sourceIndex).subspan(known)) {
        const double intensity = intensities.at(slot);
        const double sigma =
            std::isnan(intensity) ? unknown : rangeSigmaAt(config.rangeSigmaByIntensity, intensity);
        out.scan.rangeSigma.push_back(static_cast<float>(sigma));
    }
}

}  // namespace offmap::rawlog
