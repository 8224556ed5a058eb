// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/ReplayClock.h>
#include <offmap/live/ScanSource.h>
#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/LogSurvey.h>
#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/TurnAssembler.h>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>

namespace offmap::live {

/// The turns of a rawlog, at the times that they were taken at or faster or slower. The controls
/// may be called by any thread.
class RawlogReplay : public ScanSource {
 public:
    enum class AtEnd : uint8_t {
        Stop,
        Wait,  ///< for a jump
    };

    /// The survey must outlive it. \param speed as of ReplayClock; 1: as it was recorded
    /// \throw rawlog::RawlogError if the log cannot be opened
    RawlogReplay(std::filesystem::path log, const rawlog::LogSurvey& survey,
                 const rawlog::Config& config, double speed, AtEnd atEnd = AtEnd::Stop);

    std::optional<ArrivedTurn> next(const std::stop_token& stop) override;
    SourceHealth health() const override;
    bool waits() const override;

    void setSpeed(double speed);
    void pause();
    void resume();
    /// While it is paused: one more turn.
    void step();
    /// Goes on with the turn of that number; the log is read from its beginning if it lies behind.
    /// While it is paused, that turn comes and no more.
    void jumpTo(uint64_t number);

 private:
    void open();
    bool readTurns();
    bool waitUntilDue(const rawlog::Turn& turn, const std::stop_token& stop);
    bool waitForJump(const std::stop_token& stop);
    void obeyJump(const std::stop_token& stop);
    bool jumpWaits() const;

    const std::filesystem::path log_;
    const rawlog::LogSurvey& survey_;
    const rawlog::Config config_;
    const AtEnd atEnd_;

    // Of the thread that calls next().
    std::unique_ptr<rawlog::RawlogReader> reader_;
    std::unique_ptr<rawlog::TurnAssembler> assembler_;
    std::deque<rawlog::PlacedTurn> ready_;
    uint64_t nextNumber_ = 0;  // of ready_.front(), or of what comes next
    uint64_t entries_ = 0;     // that were read
    bool ended_ = false;

    mutable std::mutex mutex_;  // of what follows
    std::condition_variable_any changed_;
    ReplayClock clock_;
    uint64_t steps_ = 0;
    std::optional<uint64_t> jump_;
    SourceHealth health_;
};

}  // namespace offmap::live
