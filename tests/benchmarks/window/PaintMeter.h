// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MainFrame.h"

#include <chrono>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

namespace offmap::test {

/// What a window did for a while.
struct PaintTally {
    double seconds = 0;
    size_t paints = 0;
    size_t scans = 0;             ///< that were shown
    size_t returns = 0;           ///< of these scans
    std::vector<double> handled;  ///< [ms] from movements of the pointer to their handling
    std::vector<double> painted;  ///< [ms] from the same to the picture on the screen
};

/// Listens to what a window paints, and to the movements of the pointer that it paints for.
class PaintMeter {
 public:
    /// The window must live as long as it is used.
    explicit PaintMeter(window::MainFrame& frame);

    /// Any thread: the pointer is about to be moved there. [px] on the screen
    void expect(const wxPoint& place);
    /// Any thread: what happened since the last call.
    PaintTally take();
    /// Of OpenGL; empty before the first paint.
    std::string renderer();

 private:
    using Clock = std::chrono::steady_clock;
    struct Movement {
        Clock::time_point begun;
        wxPoint place;  // [px] on the screen
        Clock::time_point handled = {};
    };

    void onMotion(const wxPoint& place);
    void onPainted();

    window::ScanStage& stage_;
    std::mutex mutex_;  // of what follows
    std::deque<Movement> expected_;
    size_t handled_ = 0;  // of expected_, from its beginning
    PaintTally tally_;
    window::ComposedPtr shown_;  // last
    std::string renderer_;
    Clock::time_point since_ = Clock::now();
};

}  // namespace offmap::test
