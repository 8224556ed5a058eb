// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PaintMeter.h"
#include "ScreenPointer.h"

#include <atomic>
#include <random>
#include <stop_token>

namespace offmap::test {

struct ScriptOptions {
    double seconds = 10;  ///< [s] each rate is measured for
    size_t moves = 400;   ///< of the pointer, whose way to the picture is measured
    double soak = 0;      ///< [s] to play on, looking at the memory
    uint32_t seed = 1;    ///< of the gaps between movements
};

/// What is done with the window while it is measured. Prints Markdown.
class Script {
 public:
    Script(window::MainFrame& frame, PaintMeter& meter, const ScriptOptions& options);

    /// On a thread of its own. \throw std::runtime_error if nothing comes to be shown
    void run(const std::stop_token& stop);

 private:
    using Clock = std::chrono::steady_clock;

    void waitForScans();
    void describe();
    void measureRates(const char* name, bool drag);
    void measureAnswers();
    void soak();
    double memoryAtRest();
    uint64_t turnsReduced();
    /// Moves the pointer with its button pressed until it is told that it is enough.
    void dragWhile(const std::function<bool()>& more, const std::function<double()>& gap);
    void moveTo(size_t step);
    void play(bool play);
    /// \throw Ended if the window is closed meanwhile
    void sleepFor(double seconds);

    window::MainFrame& frame_;
    PaintMeter& meter_;
    const ScriptOptions options_;
    ScreenPointer pointer_;
    std::mt19937 random_;
    wxRect canvas_;  // [px] on the screen
    std::stop_token stop_;
    std::atomic_bool again_ = true;  // from the beginning, at the end of the log
};

}  // namespace offmap::test
