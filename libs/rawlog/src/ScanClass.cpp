// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ScanClass.h>

#include <fmt/format.h>

#include <stdexcept>

namespace offmap::rawlog {

void ScanClass::checkMask(const mrpt::obs::CObservation& obs, SlotMask keep) const {
    if (keep.size() == slotCount(obs)) return;
    throw std::invalid_argument(fmt::format("a mask of {} entries for the {} slots of '{}'",
                                            keep.size(), slotCount(obs), obs.sensorLabel));
}

}  // namespace offmap::rawlog
