// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/GrabberFile.h>
#include <offmap/live/LivePoses.h>
#include <offmap/live/ScanSource.h>
#include <offmap/rawlog/Config.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace offmap::live {

class GrabberIntake;

/// The turns of the sensors that an INI file of rawlog-grabber names, each read by a thread of its
/// own with MRPT's driver for it. A driver that fails is made anew until it works again.
class GrabberSource : public ScanSource {
 public:
    struct Options {
        std::string poseLabel{};  ///< of the robot poses to use; empty: any
        std::chrono::milliseconds stallsAfter{2000};
        std::chrono::milliseconds triesAgainAfter{1000};
        /// At its end, for drivers that are busy. Threads of those that stay so are left alone.
        std::chrono::milliseconds waitsForDrivers{1000};
    };

    /// Starts at once. \param poses that robot poses are added to; may be null
    /// \throw std::runtime_error as GrabberFile
    GrabberSource(const std::filesystem::path& ini, const rawlog::Config& config,
                  std::shared_ptr<LivePoses> poses, const Options& options);
    ~GrabberSource() override;
    GrabberSource(const GrabberSource&) = delete;
    GrabberSource& operator=(const GrabberSource&) = delete;

    std::optional<ArrivedTurn> next(const std::stop_token& stop) override;
    /// Stalled as long as no driver works, or no scan comes.
    SourceHealth health() const override;

    size_t sensors() const { return workers_.size(); }

 private:
    struct Worker {
        std::future<void> end;
        std::thread thread;
    };
    GrabberSource(const std::shared_ptr<const GrabberFile>& file, const rawlog::Config& config,
                  std::shared_ptr<LivePoses> poses, const Options& options);

    const std::chrono::milliseconds waitsForDrivers_;
    const std::shared_ptr<GrabberIntake> intake_;  // with the threads, which may outlive this
    std::stop_source stop_;
    std::vector<Worker> workers_;
};

}  // namespace offmap::live
