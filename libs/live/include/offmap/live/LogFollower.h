// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LivePoses.h>
#include <offmap/live/ScanSource.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/TurnAssembler.h>

#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace offmap::live {

/// The turns of a rawlog that another program is still writing, as they come; poses go to
/// LivePoses.
class LogFollower : public ScanSource {
 public:
    struct Options {
        std::string poseLabel{};  ///< of the robot poses to use; empty: any
        std::chrono::milliseconds stallsAfter{2000};
    };

    /// \param poses to add to; may be null
    LogFollower(std::filesystem::path log, const rawlog::Config& config,
                std::shared_ptr<LivePoses> poses, Options options);

    std::optional<ArrivedTurn> next(const std::stop_token& stop) override;
    SourceHealth health() const override;

 private:
    bool waitForMore();
    bool readEntry();
    void take(const mrpt::obs::CObservation::Ptr& obs, uint64_t entry);

    const std::filesystem::path log_;
    const rawlog::Config config_;
    const Options options_;
    std::shared_ptr<LivePoses> poses_;
    rawlog::TurnAssembler assembler_;
    std::unique_ptr<rawlog::RawlogReader> reader_;
    std::deque<rawlog::PlacedTurn> ready_;
    const std::stop_token* stop_ = nullptr;  // of the call of next() that is going on
    SteadyTime lastBytes_;

    mutable std::mutex mutex_;
    SourceHealth health_;
};

}  // namespace offmap::live
