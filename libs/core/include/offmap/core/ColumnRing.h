// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/OrganizedScan.h>

#include <cstdint>
#include <optional>

namespace offmap::core {

/// How the columns of a scan follow each other around the sensor. The scan must outlive it.
class ColumnRing {
 public:
    explicit ColumnRing(const OrganizedScan& scan);

    /// The next column in the order of rotation (step +1) or against it (step -1), round the end of
    /// the turn if the turn is closed there. None across a sector that no column looks into.
    std::optional<uint32_t> neighbour(uint32_t column, int step) const;

    /// Columns from one to the other in the order of rotation.
    uint32_t stepsBetween(uint32_t from, uint32_t to) const {
        return to >= from ? to - from : to + size_ - from;
    }

 private:
    const OrganizedScan& scan_;
    uint32_t size_;
    double widestStep_ = 0;  ///< [rad] of azimuth between columns that still are neighbours
};

}  // namespace offmap::core
