// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/rawlog/HealthTotals.h>

#include <cmath>
#include <numeric>

namespace offmap::rawlog {

namespace {

std::optional<double> rms(double squares, uint64_t count) {
    if (count == 0) return std::nullopt;
    return std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

void HealthTotals::add(uint64_t scan, const core::Health& health, bool reduced) {
    if (health.fit && reduced) {
        ++corrected;
        squaredShift += health.fit->shift * health.fit->shift;
        squaredTurn += health.fit->turn * health.fit->turn;
    }
    if (!health.suspect) return;
    ++suspects[static_cast<size_t>(*health.suspect)];
    if (firstSuspects.size() < mostListed) firstSuspects.push_back(scan);
}

void HealthTotals::merge(const HealthTotals& other) {
    corrected += other.corrected;
    squaredShift += other.squaredShift;
    squaredTurn += other.squaredTurn;
    for (size_t r = 0; r < suspects.size(); ++r) suspects[r] += other.suspects[r];
    firstSuspects.clear();
}

uint64_t HealthTotals::suspectScans() const {
    return std::accumulate(suspects.begin(), suspects.end(), uint64_t{0});
}

std::optional<double> HealthTotals::shiftRms() const { return rms(squaredShift, corrected); }
std::optional<double> HealthTotals::turnRms() const { return rms(squaredTurn, corrected); }

}  // namespace offmap::rawlog
