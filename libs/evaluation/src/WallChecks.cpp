// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/core/WallGeometry.h>
#include <offmap/evaluation/PlanCheck.h>

#include <algorithm>
#include <cmath>

namespace offmap::evaluation {

std::string_view toString(BinState state) {
    switch (state) {
        case BinState::Seen:
            return "seen";
        case BinState::Missing:
            return "missing";
        case BinState::Hidden:
            return "hidden";
        case BinState::OutOfView:
            break;
    }
    return "out_of_view";
}

BinCheck PlanCheck::checkOf(const Bin& bin) const {
    // [m] of the window about a surface: a segment's own tolerance to either side.
    constexpr double width = 0.1;
    BinCheck check{};
    check.through = bin.through;
    check.inFront = bin.inFront;
    check.clearance = bin.clearance;
    const Spread left = bin.left.densest(width), right = bin.right.densest(width);
    check.offset = left;
    check.offset.add(right);
    if (check.offset.segments >= config_.minSegments) {
        check.state = BinState::Seen;
        if (left.weight > 0) check.leftFace = -left.mean();
        if (right.weight > 0) check.rightFace = right.mean();
    } else if (bin.through >= config_.minSegments) {
        check.state = BinState::Missing;
    } else if (bin.inFront > 0) {
        check.state = BinState::Hidden;
    }
    return check;
}

namespace {

/// The mean of those bins that have one.
class FaceMean {
 public:
    void add(const std::optional<double>& face) {
        if (!face) return;
        sum_ += *face;
        ++count_;
    }
    std::optional<double> mean() const {
        return count_ > 0 ? std::optional(sum_ / count_) : std::nullopt;
    }

 private:
    double sum_ = 0;
    int count_ = 0;
};

/// A surface that is much nearer than the rest of its wall is a thing that hides it.
void demoteThings(WallCheck& check) {
    constexpr double nearer = 0.15;  // [m]
    constexpr size_t few = 3;        // bins, of which none is the rest
    std::vector<double> means;
    for (const BinCheck& bin : check.bins) {
        if (bin.state == BinState::Seen) means.push_back(bin.offset.mean());
    }
    if (means.size() < few) return;
    const auto middle = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2);
    std::nth_element(means.begin(), middle, means.end());
    for (BinCheck& bin : check.bins) {
        if (bin.state != BinState::Seen || bin.offset.mean() > *middle - nearer) continue;
        bin.state = BinState::Hidden;
        bin.inFront += bin.offset.segments;
        bin.clearance -= bin.offset.mean() * static_cast<double>(bin.offset.segments);
        bin.offset = {};
        bin.leftFace.reset();
        bin.rightFace.reset();
    }
}

/// Of the bins that are seen.
void sumUpOffsets(WallCheck& check) {
    FaceMean left, right;
    double squares = 0;  // [m^2] of the bins' own spreads
    for (const BinCheck& bin : check.bins) {
        if (bin.state != BinState::Seen) continue;
        const double mean = bin.offset.mean();
        check.offset.weight += 1;
        check.offset.sum += mean;
        check.offset.squares += mean * mean;
        check.offset.segments += bin.offset.segments;
        check.offset.returns += bin.offset.returns;
        squares += bin.offset.deviation() * bin.offset.deviation();
        if (std::abs(mean) > std::abs(check.largest)) {
            check.largest = mean;
            check.largestAt = 0.5 * (bin.from + bin.to);
        }
        left.add(bin.leftFace);
        right.add(bin.rightFace);
    }
    check.leftFace = left.mean();
    check.rightFace = right.mean();
    if (!(check.offset.weight > 0)) return;
    check.rms = std::sqrt(check.offset.squares / check.offset.weight);
    check.spread = std::hypot(check.offset.deviation(), std::sqrt(squares / check.offset.weight));
}

void countStates(WallCheck& check) {
    const double each = 1.0 / static_cast<double>(check.bins.size());
    for (const BinCheck& bin : check.bins) {
        if (bin.state == BinState::Seen) check.seen += each;
        if (bin.state == BinState::Missing) check.missing += each;
        if (bin.state == BinState::Hidden) check.hidden += each;
        check.through += bin.through;
        check.inFront += bin.inFront;
        check.clearance += bin.clearance;
    }
    if (check.inFront > 0) check.clearance /= static_cast<double>(check.inFront);
}

}  // namespace

std::vector<WallCheck> PlanCheck::walls() const {
    std::vector<WallCheck> checks;
    for (uint32_t wall = 0; wall < bins_.size(); ++wall) {
        WallCheck& check = checks.emplace_back();
        check.wall = wall;
        check.length = lengthOf(map_.walls()[wall]);
        const size_t bins = binsOf(wall);
        for (size_t b = 0; b < bins; ++b) {
            BinCheck bin = bins_[wall].empty() ? BinCheck{} : checkOf(bins_[wall][b]);
            bin.from = check.length * static_cast<double>(b) / static_cast<double>(bins);
            bin.to = check.length * static_cast<double>(b + 1) / static_cast<double>(bins);
            check.bins.push_back(bin);
        }
        demoteThings(check);
        sumUpOffsets(check);
        countStates(check);
    }
    return checks;
}

}  // namespace offmap::evaluation
