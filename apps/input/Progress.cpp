// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Console.h"

#include <offmap/rawlog/GroupedDigits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace offmap::app {

namespace {

constexpr std::chrono::milliseconds betweenDrawings{100};
constexpr std::chrono::seconds betweenLines{10};

std::string minutes(double seconds) {
    const auto whole = std::lround(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string bar(double share) {
    constexpr int width = 32;
    const int done = std::clamp(static_cast<int>(share * width), 0, width);
    return std::string(static_cast<size_t>(done), '=') + (done < width ? ">" : "") +
           std::string(static_cast<size_t>(std::max(width - done - 1, 0)), ' ');
}

}  // namespace

Progress::Progress(bool quiet, const std::string& title)
    : title_(title.empty() ? "" : title + "  "),
      terminal_(isatty(STDERR_FILENO) == 1),
      quiet_(quiet),
      next_(Clock::now() + std::chrono::milliseconds(betweenLines)) {
    // One of many short tasks shows at once; one by itself may be done before it could be read.
    constexpr std::chrono::milliseconds patience{300};
    if (terminal_) next_ = Clock::now() + (title.empty() ? patience : patience * 0);
}

void Progress::tellSurvey(double share) {
    if (due()) draw(share, "read for poses and sensors");
}

void Progress::tell(double share, uint64_t scans, double logSeconds) {
    if (!due()) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const double left = share > 0 ? seconds * (1 - share) / share : 0;
    const std::string realTime =
        logSeconds > 0 ? fmt::format("  {:.0f}x real time", logSeconds / seconds) : "";
    draw(share, fmt::format("{} scans  {:.0f} scans/s{}  ETA {}", rawlog::grouped(scans),
                            static_cast<double>(scans) / seconds, realTime, minutes(left)));
}

bool Progress::due() {
    const auto now = Clock::now();
    if (quiet_ || now < next_) return false;
    next_ = now + (terminal_ ? betweenDrawings : std::chrono::milliseconds(betweenLines));
    return true;
}

void Progress::draw(double share, const std::string& figures) {
    if (terminal_) {
        say(stderr, "\r[{}] {:3.0f} %  {}{}\x1b[K", bar(share), 100 * share, title_, figures);
    } else {
        say(stderr, "{:.0f} %  {}{}\n", 100 * share, title_, figures);
    }
    drawn_ = terminal_;
}

void Progress::clear() {
    if (drawn_) clearLeftover();
    drawn_ = false;
}

void Progress::clearLeftover() {
    if (isatty(STDERR_FILENO) == 1) say(stderr, "\r\x1b[K");
}

}  // namespace offmap::app
