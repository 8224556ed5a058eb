// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace offmap::app {

/// Tells on stderr how far a long task is: one line that is drawn anew on a terminal, now and then
/// a line of its own where the output is piped.
class Progress {
 public:
    /// \param quiet tells nothing \param title what the task is: "2/7 run2.rawlog"; may be empty
    explicit Progress(bool quiet, const std::string& title = "");
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// \param share [0, 1] of the log that has been read to find its poses
    void tellSurvey(double share);
    /// \param share [0, 1] of the task that is done \param logSeconds [s] of the log that is done
    void tell(double share, uint64_t scans, double logSeconds);
    /// Takes the line off the terminal.
    void clear();
    /// The same for a line that another process has drawn.
    static void clearLeftover();

 private:
    void draw(double share, const std::string& figures);
    bool due();

    using Clock = std::chrono::steady_clock;

    std::string title_;
    bool terminal_, quiet_, drawn_ = false;
    Clock::time_point start_ = Clock::now(), next_;
};

}  // namespace offmap::app
