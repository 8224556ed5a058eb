// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/Intensities.h>
#include <offmap/rawlog/RangeImageScan.h>

#include <limits>

namespace offmap::rawlog {

namespace {

/// Of all slots of a turn, whatever `of` tells of an observation; empty if it tells of none.
template <class OfObservation>
std::vector<float> gathered(const Turn& turn, const ScanClass& scanClass, const OfObservation& of) {
    std::vector<float> all;
    bool any = false;
    for (const auto& obs : turn) {
        const std::vector<float> own = of(*obs);
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

std::vector<float> slotIntensitiesOf(const Turn& turn, const ScanClass& scanClass) {
    return gathered(turn, scanClass,
                    [&](const mrpt::obs::CObservation& obs) { return scanClass.intensities(obs); });
}

std::vector<float> pointIntensitiesOf(const Turn& turn, const ScanClass& scanClass,
                                      const core::OrganizedScan& scan) {
    using Camera = mrpt::obs::CObservation3DRangeScan;
    const std::vector<float> slots =
        gathered(turn, scanClass, [&](const mrpt::obs::CObservation& obs) {
            const auto* camera = dynamic_cast<const Camera*>(&obs);
            return camera ? brightnessOf(*camera) : scanClass.intensities(obs);
        });
    if (slots.empty()) return {};
    std::vector<float> points;
    points.reserve(scan.sourceIndex.size());
    for (const uint32_t slot : scan.sourceIndex) points.push_back(slots.at(slot));
    return points;
}

}  // namespace offmap::rawlog
