// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LiveFrame.h>
#include <offmap/rawlog/RawlogWriter.h>

#include <filesystem>
#include <memory>

namespace offmap::app {

/// Writes the reduced scans of a live reduction to a rawlog, which appears at the end.
class LiveRecorder {
 public:
    /// \throw std::runtime_error naming the file, as all members do
    LiveRecorder(const std::filesystem::path& file, bool overwrite)
        : writer_(file, {1, overwrite}) {}

    void add(const live::LiveFrame& frame);
    void publish() { writer_.publish(); }

 private:
    rawlog::RawlogWriter writer_;
};

}  // namespace offmap::app
