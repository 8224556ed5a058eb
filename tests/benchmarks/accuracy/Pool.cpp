// SPDX-License-Identifier: BSD-3-Clause
#include "Pool.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace offmap::accuracy {

namespace {

double share(size_t part, size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// Calls work(0) ... work(count - 1), on so many threads.
/// \throw what a call throws
void inParallel(size_t count, unsigned threads, const std::function<void(size_t)>& work) {
    std::atomic<size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failing;
    const auto worker = [&] {
        try {
            for (size_t i = next++; i < count; i = next++) work(i);
        } catch (...) {
            const std::lock_guard lock(failing);
            failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> workers;
        for (unsigned t = 1; t < threads; ++t) workers.emplace_back(worker);
        worker();
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace

void PosePool::add(const RefinedPose& pose) {
    constexpr double rarely = 7.815;  // chi-square of 3 degrees exceeds it once in 20
    ++scans;
    squaresBefore += pose.errorBefore.cwiseAbs2();
    squaresAfter += pose.errorAfter.cwiseAbs2();
    statedVariances += pose.statedVariance;
    variances += pose.variance;
    squaredErrors += pose.squaredError;
    if (pose.squaredError > rarely) ++beyond95;
}

void PosePool::add(const PosePool& more) {
    scans += more.scans;
    squaresBefore += more.squaresBefore;
    squaresAfter += more.squaresAfter;
    statedVariances += more.statedVariances;
    variances += more.variances;
    squaredErrors += more.squaredErrors;
    beyond95 += more.beyond95;
}

double PosePool::meanSquaredError() const {
    return scans == 0 ? 0 : squaredErrors / static_cast<double>(scans);
}

void Pool::add(const Outcome& outcome, const std::string& condition) {
    scans.push_back({condition, outcome.seed,
                     outcome.score.mappedOnSegments.removedShare().value_or(1),
                     outcome.score.unmapped.removedShare().value_or(0),
                     outcome.pose ? outcome.pose->squaredError : 0, outcome.flagged});
    score.add(outcome.score);
    points += outcome.score.mapped.points + outcome.score.unmapped.points;
    onSegments += outcome.onSegments;
    removedOnSegments += outcome.removedOnSegments;
    flagged += outcome.flagged;
    keptWhole += outcome.keptWhole;
    if (outcome.pose) pose.add(*outcome.pose);
}

void Pool::add(const Pool& more) {
    scans.insert(scans.end(), more.scans.begin(), more.scans.end());
    score.add(more.score);
    points += more.points;
    onSegments += more.onSegments;
    removedOnSegments += more.removedOnSegments;
    flagged += more.flagged;
    keptWhole += more.keptWhole;
    pose.add(more.pose);
}

double Pool::flaggedShare() const { return share(flagged, score.scans()); }
double Pool::keptWholeShare() const { return share(keptWhole, score.scans()); }

std::vector<Pools> run(std::span<const Condition* const> conditions, size_t scans, uint64_t seed,
                       unsigned threads) {
    std::vector<Outcomes> outcomes(conditions.size() * scans);
    // A seed of its own for every scan: no scene stands in two conditions.
    inParallel(outcomes.size(), threads, [&](size_t i) {
        outcomes[i] = runTrial(*conditions[i / scans], i % scans,
                               seed * 10'000'019 + static_cast<uint64_t>(i));
    });
    std::vector<Pools> pools(conditions.size());
    for (size_t i = 0; i < outcomes.size(); ++i) {
        for (size_t m = 0; m < methodCount; ++m)
            pools[i / scans][m].add(outcomes[i][m], conditions[i / scans]->name);
    }
    return pools;
}

Pools poolOf(std::span<const Pools> parts) {
    Pools whole;
    for (const Pools& part : parts) {
        for (size_t m = 0; m < methodCount; ++m) whole[m].add(part[m]);
    }
    return whole;
}

}  // namespace offmap::accuracy
