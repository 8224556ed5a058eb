// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Health.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace offmap::rawlog {

/// How well scans, poses and map of a whole log, or of several, go together.
struct HealthTotals {
    uint64_t corrected = 0;                                 ///< scans with a pose fit, reduced
    double squaredShift = 0, squaredTurn = 0;               ///< [m^2], [rad^2] sums over these
    std::array<uint64_t, core::suspicionCount> suspects{};  ///< scans, by reason
    /// Numbers of the first suspect scans; of one log: those of several tell nothing.
    std::vector<uint64_t> firstSuspects;
    static constexpr size_t mostListed = 10;

    /// \param scan its number, from 0 \param reduced false if it was kept whole
    void add(uint64_t scan, const core::Health& health, bool reduced);
    void merge(const HealthTotals& other);

    uint64_t suspectFor(core::Suspicion reason) const {
        return suspects[static_cast<size_t>(reason)];
    }
    uint64_t suspectScans() const;
    std::optional<double> shiftRms() const;  ///< [m] none without a corrected scan
    std::optional<double> turnRms() const;   ///< [rad]
};

}  // namespace offmap::rawlog
