// SPDX-License-Identifier: BSD-3-Clause
#include "WrappedAngle.h"

#include <offmap/rawlog/VelodyneColumns.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace offmap::rawlog {

namespace {

double stepBetween(const VelodyneFiring& a, const VelodyneFiring& b) {
    return wrapped(b.azimuth - a.azimuth);
}

/// Whether two firings are neighbours: no packet is missing between them.
bool follows(double step, double usual) { return std::abs(step - usual) <= 0.5 * std::abs(usual); }

/// [rad] Mean azimuth from firing to firing, gaps left out: whole hundredths of degrees, as a
/// median would give, add up to too much over the firings that a correction spans.
double usualStep(const std::vector<VelodyneFiring>& firings) {
    std::vector<double> steps;
    for (size_t f = 1; f < firings.size(); ++f) {
        steps.push_back(stepBetween(firings[f - 1], firings[f]));
    }
    if (steps.empty()) return 0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    const double median = *middle;
    double sum = 0, count = 0;
    for (const double step : steps) {
        if (!follows(step, median)) continue;
        sum += step;
        ++count;
    }
    return sum / count;
}

/// Half-open, of its first returns or its second ones.
std::pair<uint32_t, uint32_t> rangeOf(const VelodyneFiring& firing, bool second) {
    return second ? std::pair(firing.second, firing.end) : std::pair(firing.begin, firing.second);
}

class Gathering {
 public:
    explicit Gathering(const VelodyneReturns& in) : in_(in) {
        if (in.azimuthCorrections.empty()) return;
        step_ = usualStep(in.firings);
        // A head that hardly turns takes longer to look there than a scan lasts.
        constexpr double slowest = mrpt::DEG2RAD(0.01);
        if (std::abs(step_) < slowest) return;
        for (const double correction : in.azimuthCorrections) {
            shifts_.push_back(std::lround(-correction / step_));
            widest_ = std::max(widest_, std::abs(shifts_.back()));
        }
    }

    /// Of firings [begin, end): the first returns, or the second ones.
    void gather(size_t begin, size_t end, bool second) {
        if (shifts_.empty()) {
            for (size_t f = begin; f < end; ++f) gatherFiring(in_.firings[f], second);
            return;
        }
        for (size_t f = begin + 1; f <= end; ++f) {
            if (f < end && !endsRun(f)) continue;
            gatherRun(static_cast<long>(begin), static_cast<long>(f), second);
            begin = f;
        }
    }

    VelodyneColumns columns() && { return std::move(out_); }

 private:
    bool endsRun(size_t f) const {
        return !follows(stepBetween(in_.firings[f - 1], in_.firings[f]), step_);
    }

    /// All lasers look where the head does: the firing is a column.
    void gatherFiring(const VelodyneFiring& firing, bool second) {
        const auto first = static_cast<uint32_t>(out_.returns.size());
        const auto [begin, end] = rangeOf(firing, second);
        if (second && begin == end) return;
        out_.returns.resize(first + (end - begin));
        std::iota(out_.returns.begin() + first, out_.returns.end(), begin);
        out_.columns.push_back({firing.azimuth, firing.time, first, first + (end - begin)});
    }

    template <class Use>
    void forEachReturn(long firing, bool second, const Use& use) const {
        const auto [begin, end] = rangeOf(in_.firings[static_cast<size_t>(firing)], second);
        for (uint32_t i = begin; i < end; ++i) {
            use(i, firing - shifts_[in_.lasers[i]]);
        }
    }

    /// Firings [begin, end) without a gap. Column c of the run is that of firing begin + c -
    /// widest_.
    void gatherRun(long begin, long end, bool second) {
        const long first = begin - widest_;
        const auto size = static_cast<size_t>(end + widest_ - first);
        ends_.assign(size + 1, static_cast<uint32_t>(out_.returns.size()));
        const auto place = [&](long column) { return static_cast<size_t>(column - first); };
        for (long f = begin; f < end; ++f) {
            forEachReturn(f, second, [&](uint32_t, long column) { ++ends_[place(column) + 1]; });
        }
        const uint32_t before = ends_[0];
        for (size_t c = 1; c <= size; ++c) ends_[c] += ends_[c - 1] - before;
        // Now ends_[c] is where column c begins, and moves to its end as it is filled.
        const std::vector<uint32_t> begins = ends_;
        out_.returns.resize(ends_[size]);
        for (long f = begin; f < end; ++f) {
            forEachReturn(f, second, [&](uint32_t i, long column) {
                out_.returns[ends_[place(column)]++] = i;
            });
        }
        for (size_t c = 0; c < size; ++c) {
            const long firing = first + static_cast<long>(c);
            const bool ofFiring = !second && firing >= begin && firing < end;
            if (begins[c] == ends_[c] && !ofFiring) continue;
            addColumn(firing, std::clamp(firing, begin, end - 1), begins[c], ends_[c]);
        }
    }

    /// \param firing that would look there \param nearest one that was fired
    void addColumn(long firing, long nearest, uint32_t begin, uint32_t end) {
        const VelodyneFiring& fired = in_.firings[static_cast<size_t>(nearest)];
        const double azimuth = fired.azimuth + static_cast<double>(firing - nearest) * step_;
        out_.columns.push_back({azimuth, fired.time, begin, end});
    }

    const VelodyneReturns& in_;
    double step_ = 0;           ///< [rad] from firing to firing
    std::vector<long> shifts_;  ///< per laser: firings that it is ahead
    long widest_ = 0;
    std::vector<uint32_t> ends_;
    VelodyneColumns out_;
};

}  // namespace

VelodyneColumns gatherColumns(const VelodyneReturns& returns, size_t firstFiring) {
    Gathering gathering(returns);
    gathering.gather(firstFiring, returns.firings.size(), false);
    gathering.gather(0, returns.firings.size(), true);
    return std::move(gathering).columns();
}

VelodyneColumns gatherFirstReturns(const VelodyneReturns& returns, size_t begin, size_t end) {
    Gathering gathering(returns);
    gathering.gather(begin, end, false);
    return std::move(gathering).columns();
}

}  // namespace offmap::rawlog
