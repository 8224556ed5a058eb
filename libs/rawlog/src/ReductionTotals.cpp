// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/ReductionTotals.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace offmap::rawlog {

namespace {

constexpr double shortest = 1e-4;  // [ms] lower end of the first bin
constexpr double binRatio = 1.01;

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
    health.add(scans - 1, turn.health, turn.notReduced.empty());
    milliseconds.add(turn.milliseconds);
    firstTime = firstTime ? std::min(*firstTime, turn.time) : turn.time;
    lastTime = lastTime ? std::max(*lastTime, turn.time) : turn.time;
}

void ReductionTotals::merge(const ReductionTotals& other) {
    scans += other.scans;
    for (const auto& [reason, count] : other.notReduced) notReduced[reason] += count;
    for (const auto& [reason, count] : other.notSupported) notSupported[reason] += count;
    addCounts(other, *this);
    health.merge(other.health);
    milliseconds.merge(other.milliseconds);
    mergedLogSeconds += other.logSeconds();
}

uint64_t ReductionTotals::keptOnSegments() const {
    return std::accumulate(keptByReason.begin(), keptByReason.end(), keptOffWall);
}

uint64_t ReductionTotals::scansNotReduced() const { return sum(notReduced); }
uint64_t ReductionTotals::observationsNotSupported() const { return sum(notSupported); }

double ReductionTotals::logSeconds() const {
    const auto own = firstTime ? *lastTime - *firstTime : mrpt::Clock::duration(0);
    return mergedLogSeconds + std::chrono::duration<double>(own).count();
}

}  // namespace offmap::rawlog
