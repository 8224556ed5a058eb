// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace offmap::window {

/// What a curve shows in one column of pixels.
struct CurveColumn {
    size_t column;     ///< from the left, from 0
    double low, high;  ///< of the values there
    bool joined;       ///< to the column before it in the list: nothing is missing between them
};

/// Values over time or over the turns of a log, as many as fit; the one that is least in place is
/// forgotten first.
class Series {
 public:
    struct Sample {
        double place;
        double value;
    };

    /// \param capacity samples, at least 1
    explicit Series(size_t capacity) : capacity_(capacity) {}

    /// In any order; what has the place of another takes it over. What is not finite is left out.
    void add(double place, double value);
    void forgetBefore(double place);
    void clear() { samples_.clear(); }

    std::optional<double> at(double place) const;
    /// The one furthest on in place.
    std::optional<Sample> last() const;
    size_t size() const { return samples_.size(); }

    /// The columns that hold samples, of `count` between two places, the second of which is
    /// outside. \param gap samples further apart than this are not joined
    std::vector<CurveColumn> columns(double from, double to, size_t count, double gap) const;
    /// The greatest value from one place on.
    std::optional<double> greatest(double from) const;

 private:
    std::deque<Sample>::const_iterator firstFrom(double place) const;

    size_t capacity_;
    std::deque<Sample> samples_;  // by place
};

}  // namespace offmap::window
