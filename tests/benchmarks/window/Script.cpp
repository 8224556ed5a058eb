// SPDX-License-Identifier: BSD-3-Clause
#include "Script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <malloc.h>
#include <numeric>
#include <thread>
#include <unistd.h>

namespace offmap::test {

namespace {

struct Ended {};

/// \pre not empty
double quantile(std::vector<double> values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<size_t>(place)];
}

void printQuantiles(const char* name, const std::vector<double>& values) {
    if (values.empty()) throw std::runtime_error("no movement of the pointer came to the picture");
    fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {} |\n", name, quantile(values, 0.5),
               quantile(values, 0.95), quantile(values, 1), values.size());
}

/// [MiB] of this program in memory.
double residentMemory() {
    size_t all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// [B] of all arenas, as malloc_info() tells at its end.
size_t heapInUse() {
    char* text = nullptr;
    size_t length = 0;
    FILE* const stream = open_memstream(&text, &length);
    malloc_info(0, stream);
    std::fclose(stream);
    const std::string all(text, length);
    std::free(text);
    const auto sizeOf = [&](const char* key) {
        const size_t place = all.rfind(key);
        const size_t size = place == std::string::npos ? place : all.find("size=\"", place);
        return size == std::string::npos ? 0 : std::stoull(all.substr(size + 6));
    };
    return sizeOf("<system type=\"current\"") + sizeOf("<total type=\"mmap\"") -
           sizeOf("<total type=\"fast\"") - sizeOf("<total type=\"rest\"");
}

std::string load() {
    std::string now;
    std::ifstream("/proc/loadavg") >> now;
    return now;
}

}  // namespace

Script::Script(window::MainFrame& frame, PaintMeter& meter, const ScriptOptions& options)
    : frame_(frame),
      meter_(meter),
      options_(options),
      random_(options.seed),
      canvas_(frame.workspace().stage->canvas().GetScreenRect()) {}

void Script::run(const std::stop_token& stop) try {
    stop_ = stop;
    const std::jthread repeat([this](const std::stop_token& ended) {
        for (; !ended.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(5))) {
            const auto playback = frame_.session().playback();
            if (playback && again_ && !playback->playing()) playback->play();
        }
    });
    waitForScans();
    describe();
    fmt::print("| | pictures/s | scans shown/s | turns reduced/s |\n|---|---|---|---|\n");
    measureRates("playing", false);
    measureRates("playing, camera turned", true);
    play(false);
    measureRates("paused, camera turned", true);
    play(true);
    measureAnswers();
    if (options_.soak > 0) soak();
} catch (const Ended&) {
}

void Script::waitForScans() {
    constexpr int longest = 120;  // [s] until the log has been looked through
    for (int waited = 0; meter_.renderer().empty() || meter_.take().scans == 0; ++waited) {
        if (waited == longest) throw std::runtime_error("the window shows no scan");
        sleepFor(1);
    }
    sleepFor(3);  // until all that is set up once is
}

void Script::describe() {
    meter_.take();
    sleepFor(1);
    const PaintTally tally = meter_.take();
    fmt::print("{} returns shown a scan; OpenGL: {}; picture {} x {} px; load {} on {} cores\n\n",
               tally.returns / std::max<size_t>(tally.scans, 1), meter_.renderer(), canvas_.width,
               canvas_.height, load(), std::thread::hardware_concurrency());
}

uint64_t Script::turnsReduced() {
    const auto playback = frame_.session().playback();
    return playback ? playback->figures().totals.scans : 0;
}

void Script::measureRates(const char* name, bool drag) {
    constexpr double steady = 0.01;  // [s] more often than pictures can be painted
    const auto end = Clock::now() + std::chrono::duration<double>(options_.seconds);
    meter_.take();
    const uint64_t before = turnsReduced();
    if (drag) {
        dragWhile([&] { return Clock::now() < end; }, [] { return steady; });
    } else {
        sleepFor(options_.seconds);
    }
    const PaintTally tally = meter_.take();
    const auto perSecond = [&](auto count) { return static_cast<double>(count) / tally.seconds; };
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} |\n", name, perSecond(tally.paints),
               perSecond(tally.scans), perSecond(turnsReduced() - before));
    std::fflush(stdout);
}

/// About 20 movements a second, in no step with anything that the window does by the clock.
void Script::measureAnswers() {
    std::uniform_real_distribution<double> gap(0.01, 0.09);  // [s]
    size_t moves = 0;
    meter_.take();
    dragWhile([&] { return moves++ < options_.moves; }, [&] { return gap(random_); });
    const PaintTally tally = meter_.take();
    fmt::print(
        "\n| from a movement | median [ms] | 95 % [ms] | maximum [ms] | n |\n"
        "|---|---|---|---|---|\n");
    printQuantiles("to its handling", tally.handled);
    printQuantiles("to its picture", tally.painted);
    std::fflush(stdout);
}

/// While the first turn is shown, and nothing is on its way.
double Script::memoryAtRest() {
    play(false);
    frame_.session().playback()->jumpTo(0);
    sleepFor(3);
    const double mebibytes = static_cast<double>(heapInUse()) / (1 << 20);
    play(true);
    return mebibytes;
}

void Script::soak() {
    constexpr double step = 10;  // [s]
    sleepFor(step);
    const double before = memoryAtRest();
    const uint64_t first = turnsReduced();
    fmt::print("\n| s | memory [MiB] |\n|---|---|\n");
    for (double passed = 0; passed <= options_.soak; passed += step) {
        fmt::print("| {:.0f} | {:.1f} |\n", passed, residentMemory());
        std::fflush(stdout);
        sleepFor(step);
    }
    const uint64_t turns = turnsReduced() - first;
    fmt::print("\nheap in use at the first turn, paused: {:.3f} MiB, {:.3f} MiB {} turns later\n",
               before, memoryAtRest(), turns);
}

void Script::dragWhile(const std::function<bool()>& more, const std::function<double()>& gap) {
    size_t step = 0;
    moveTo(step++);
    sleepFor(0.5);
    pointer_.press();
    while (more()) {
        moveTo(step++);
        sleepFor(gap());
    }
    sleepFor(0.5);  // for the last picture
    pointer_.release();
}

/// Round the middle of the picture; the place before is always another one.
void Script::moveTo(size_t step) {
    constexpr double turn = 0.13;  // [rad]
    const double radius = 0.3 * std::min(canvas_.width, canvas_.height);
    const double angle = turn * static_cast<double>(step);
    const wxPoint middle = canvas_.GetPosition() + canvas_.GetSize() / 2;
    const wxPoint place = middle + wxPoint(static_cast<int>(radius * std::cos(angle)),
                                           static_cast<int>(radius * std::sin(angle)));
    meter_.expect(place);
    pointer_.moveTo(place.x, place.y);
}

void Script::play(bool play) {
    again_ = play;
    const auto playback = frame_.session().playback();
    if (!playback) throw Ended();
    play ? playback->play() : playback->pause();
}

void Script::sleepFor(double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    constexpr std::chrono::duration<double> shortly{0.1};  // between looks at the window
    while (!stop_.stop_requested()) {
        const std::chrono::duration<double> left = end - Clock::now();
        if (left.count() <= 0) return;
        std::this_thread::sleep_for(std::min(left, shortly));
    }
    throw Ended();
}

}  // namespace offmap::test
