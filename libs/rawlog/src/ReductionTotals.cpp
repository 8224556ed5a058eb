// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ReductionTotals.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace offmap::rawlog {

namespace {

constexpr double shortest = 1e-4;  // [ms] lower end of the first bin
constexpr double binRatio = 1.01;
constexpr double leastShare = 0.3;  // of the points on vertical segments; less smells

uint64_t sum(const std::map<std::string, uint64_t>& counts) {
    uint64_t total = 0;
    for (const auto& [reason, count] : counts) total += count;
    return total;
}

template <class Figures>
void addCounts(const Figures& figures, ReductionTotals& totals) {
    forEachCount([](const char*, uint64_t& total, const auto& count) { total += count; }, totals,
                 figures);
    for (size_t r = 0; r < totals.keptByReason.size(); ++r) {
        totals.keptByReason[r] += figures.keptByReason[r];
    }
}

}  // namespace

DurationHistogram::DurationHistogram(std::vector<uint64_t> bins)
    : bins_(std::move(bins)), count_(std::accumulate(bins_.begin(), bins_.end(), uint64_t{0})) {
    if (bins_.size() != binCount) throw std::invalid_argument("not the bins of durations");
}

void DurationHistogram::add(double milliseconds) {
    const double bin = std::log(std::max(milliseconds, shortest) / shortest) / std::log(binRatio);
    ++bins_[std::min(static_cast<size_t>(bin), binCount - 1)];
    ++count_;
}

void DurationHistogram::merge(const DurationHistogram& other) {
    for (size_t bin = 0; bin < binCount; ++bin) bins_[bin] += other.bins_[bin];
    count_ += other.count_;
}

std::optional<double> DurationHistogram::quantile(double share) const {
    if (count_ == 0) return std::nullopt;
    const double rank = share * static_cast<double>(count_ - 1);
    uint64_t below = 0;
    for (size_t bin = 0; bin < binCount; ++bin) {
        below += bins_[bin];
        if (static_cast<double>(below) > rank) {
            return shortest * std::pow(binRatio, static_cast<double>(bin) + 0.5);
        }
    }
    return std::nullopt;
}

void ReductionTotals::add(const TurnRecord& turn) {
    ++scans;
    if (!turn.notReduced.empty()) ++notReduced[turn.notReduced];
    addCounts(turn, *this);
    milliseconds.add(turn.milliseconds);
    firstTime = firstTime ? std::min(*firstTime, turn.time) : turn.time;
    lastTime = lastTime ? std::max(*lastTime, turn.time) : turn.time;
}

void ReductionTotals::merge(const ReductionTotals& other) {
    scans += other.scans;
    for (const auto& [reason, count] : other.notReduced) notReduced[reason] += count;
    for (const auto& [reason, count] : other.notSupported) notSupported[reason] += count;
    addCounts(other, *this);
    milliseconds.merge(other.milliseconds);
    mergedLogSeconds += other.logSeconds();
}

uint64_t ReductionTotals::scansNotReduced() const { return sum(notReduced); }
uint64_t ReductionTotals::observationsNotSupported() const { return sum(notSupported); }

double ReductionTotals::logSeconds() const {
    const auto own = firstTime ? *lastTime - *firstTime : mrpt::Clock::duration(0);
    return mergedLogSeconds + std::chrono::duration<double>(own).count();
}

std::vector<std::string> ReductionTotals::warnings() const {
    std::vector<std::string> out;
    for (const auto& [reason, count] : notSupported) {
        out.emplace_back(fmt::format("{} observations were copied unchanged: {}", count, reason));
    }
    if (const auto offMap = notReduced.find("no_wall_in_range"); offMap != notReduced.end()) {
        out.emplace_back(
            fmt::format("{} of {} scans have no wall within range: check --map-origin, the map's "
                        "units and the frame of the poses",
                        offMap->second, scans));
    }
    if (const uint64_t others = scansNotReduced(); scans > 0 && others == scans) {
        out.emplace_back("no scan could be reduced; all points were kept");
        return out;
    }
    if (scans == 0) {
        if (notSupported.empty()) {
            out.emplace_back("the log holds no 3D scan that could be reduced; it was copied");
        }
        return out;
    }
    if (counts.returns == 0) {
        out.emplace_back("the scans hold no return at all; check how the log was recorded");
        return out;
    }
    const uint64_t withoutPose = keptByReason[static_cast<size_t>(core::KeepReason::NoPose)];
    const auto matchable = static_cast<double>(onVerticalSegments - withoutPose);
    if (columnsWithoutPose > 0) {
        out.emplace_back(fmt::format(
            "{} of {} columns have no pose that could be used; all of their points were kept",
            columnsWithoutPose, columns));
    }
    if (onVerticalSegments == 0) {
        out.emplace_back(
            "no vertical segment was found: for a scanner with few rings raise "
            "vertical.max_gap_m and lower vertical.min_points (a VLP-16: --config vlp16)");
    } else if (removed() == 0) {
        out.emplace_back("nothing was removed: check that the map and the poses share one frame");
    } else if (static_cast<double>(removed()) < leastShare * matchable) {
        out.emplace_back(
            fmt::format("only {:.1f} % of the points on vertical segments were removed: "
                        "check the poses against the map",
                        100 * static_cast<double>(removed()) / matchable));
    }
    return out;
}

}  // namespace offmap::rawlog
