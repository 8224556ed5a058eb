// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/ReplayClock.h>
#include <offmap/live/ScanSource.h>
#include <offmap/live/VelodyneTurns.h>

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>

namespace offmap::live {

/// The turns of a Velodyne whose packets were captured to a file, with the times they came at. A
/// turn is due when its last packet came.
class VelodynePcap : public ScanSource {
 public:
    /// \param speed as of ReplayClock; 1: as they came
    /// \throw std::runtime_error naming the file, if it is no capture of a network
    VelodynePcap(const std::filesystem::path& file, std::string label, double speed);
    ~VelodynePcap() override;

    std::optional<ArrivedTurn> next(const std::stop_token& stop) override;
    SourceHealth health() const override;
    bool waits() const override { return waits_; }

 private:
    class Capture;

    VelodyneTurn readTurn(const std::stop_token& stop);
    bool handOverPiece(const std::stop_token& stop);
    bool waitUntilDue(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    void end(SourceState state, const std::string& message);

    std::unique_ptr<Capture> capture_;
    const bool waits_;
    VelodyneTurns turns_;
    ReplayClock clock_;
    mrpt::Clock::time_point lastPacket_;  // of the turn that is read

    mutable std::mutex mutex_;
    std::condition_variable_any never_;
    SourceHealth health_;
};

}  // namespace offmap::live
