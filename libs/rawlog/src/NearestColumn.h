// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace offmap::rawlog {

/// Finds the column nearest to an azimuth, around the circle. Quick where the next one asked for
/// is near the last.
class NearestColumn {
 public:
    /// \param sorted [rad] azimuths of the columns, at least one; they outlive this
    explicit NearestColumn(std::span<const double> sorted) : sorted_(sorted) {}

    /// Index of the column nearest to an azimuth [rad].
    uint32_t of(double azimuth);

    /// [rad] What is less far from the azimuth of this column is clearly nearest to it.
    double reach(uint32_t column) const;

 private:
    uint32_t search(double azimuth) const;

    std::span<const double> sorted_;
    uint32_t last_ = 0;  // what was asked for
};

}  // namespace offmap::rawlog
