// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Intensities.h>

#include <limits>

namespace offmap::rawlog {

std::vector<float> slotIntensitiesOf(const Turn& turn, const ScanClass& scanClass) {
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

std::vector<float> pointIntensitiesOf(const Turn& turn, const ScanClass& scanClass,
                                      const core::OrganizedScan& scan) {
    const std::vector<float> slots = slotIntensitiesOf(turn, scanClass);
    if (slots.empty()) return {};
    std::vector<float> points;
    points.reserve(scan.sourceIndex.size());
    for (const uint32_t slot : scan.sourceIndex) points.push_back(slots.at(slot));
    return points;
}

}  // namespace offmap::rawlog
