// SPDX-License-Identifier: BSD-3-Clause
#include "LogScore.h"

#include "PlainText.h"

#include <offmap/evaluation/TruthFile.h>
#include <offmap/evaluation/TruthMatch.h>
#include <offmap/rawlog/DecodedPoints.h>
#include <offmap/rawlog/Observations.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/ScanClasses.h>
#include <offmap/rawlog/SensorConfigs.h>

#include <fmt/format.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace offmap::app {

namespace {

using evaluation::ObservationTruth;
using mrpt::obs::CObservation;

/// What an observation is recognised by, in both files.
using Key = std::pair<mrpt::Clock::time_point, std::string>;

Key keyOf(const CObservation& obs) { return {obs.timestamp, obs.sensorLabel}; }
Key keyOf(const ObservationTruth& truth) { return {truth.time, truth.sensor}; }

std::string nameOf(const Key& key) {
    return fmt::format("'{}' at {:.6f} s", printable(key.second), mrpt::Clock::toDouble(key.first));
}

void count(Unmatched& unmatched, const Key& key, uint64_t points) {
    if (unmatched.observations++ == 0) unmatched.first = nameOf(key);
    unmatched.points += points;
}

class Comparison {
 public:
    Comparison(std::filesystem::path truth, std::filesystem::path log, const rawlog::Config& config,
               rawlog::GuardedStatus& status)
        : truthFile_(std::move(truth)),
          logFile_(std::move(log)),
          sensors_(config),
          status_(status),
          truth_(truthFile_) {}

    LogScore run() {
        forEachScan([&](const CObservation::Ptr& obs, const rawlog::ScanClass&) {
            if (places_.emplace(keyOf(*obs), places_.size()).second) return;
            throw std::runtime_error(
                fmt::format("{} holds two 3D observations {}; no truth could tell them apart",
                            logFile_.string(), nameOf(keyOf(*obs))));
        });
        next_ = truth_.next();
        size_t place = 0;
        forEachScan([&](const CObservation::Ptr& obs, const rawlog::ScanClass& scanClass) {
            compare(obs, scanClass, place++);
        });
        skipMissing();
        if (next_) failAtOrder();
        for (const auto& [number, score] : scans_) out_.score.add(score);
        return std::move(out_);
    }

 private:
    template <class Visit>
    void forEachScan(Visit&& visit) {
        rawlog::RawlogReader reader(logFile_);
        status_.atEntry(reader.place());
        while (const auto entry = reader.next()) {
            rawlog::forEachObservation(entry->object, [&](const CObservation::Ptr& obs, size_t) {
                const rawlog::SensorConfig& config = sensors_.of(obs->sensorLabel);
                if (const auto* scanClass = rawlog::scanClassOf(*obs, config)) {
                    visit(obs, *scanClass);
                } else if (const auto reason = rawlog::unsupportedReason(*obs, config)) {
                    out_.cannotBeRead =
                        fmt::format("'{}': {}", printable(obs->sensorLabel), *reason);
                }
            });
            status_.atEntry(reader.place());
        }
    }

    /// Passes over truth of observations that are nowhere in the log.
    void skipMissing() {
        for (; next_ && !places_.contains(keyOf(*next_)); next_ = truth_.next()) {
            count(out_.missing, keyOf(*next_), next_->points.size());
        }
    }

    void compare(const CObservation::Ptr& obs, const rawlog::ScanClass& scanClass, size_t place) {
        scanClass.loadExternal(*obs, logFile_);
        const auto left = rawlog::decodedPoints(*obs, scanClass, sensors_.of(obs->sensorLabel));
        skipMissing();
        if (next_ && places_.at(keyOf(*next_)) < place) failAtOrder();
        if (!next_ || keyOf(*next_) != keyOf(*obs)) {
            if (!left.empty()) count(out_.unknown, keyOf(*obs), left.size());
            return;
        }
        const evaluation::TruthMatch match = evaluation::matchTruth(next_->points, left);
        if (match.unknown > 0) count(out_.foreign, keyOf(*obs), match.unknown);
        scans_[next_->scan].add(evaluation::scoreOf(match.points));
        ++out_.observations;
        next_ = truth_.next();
    }

    [[noreturn]] void failAtOrder() const {
        throw std::runtime_error(
            fmt::format("{} tells of {} too late or twice: its observations must stand in the "
                        "order of {}",
                        truthFile_.string(), nameOf(keyOf(*next_)), logFile_.string()));
    }

    std::filesystem::path truthFile_, logFile_;
    rawlog::SensorConfigs sensors_;
    rawlog::GuardedStatus& status_;
    evaluation::TruthReader truth_;
    const ObservationTruth* next_ = nullptr;       // of the truth; null: none is left
    std::map<Key, size_t> places_;                 // of the log's 3D observations
    std::map<uint64_t, evaluation::Score> scans_;  // by number
    LogScore out_;
};

}  // namespace

LogScore scoreLog(const std::filesystem::path& truth, const std::filesystem::path& log,
                  const rawlog::Config& config, rawlog::GuardedStatus& status) {
    return Comparison(truth, log, config, status).run();
}

}  // namespace offmap::app
