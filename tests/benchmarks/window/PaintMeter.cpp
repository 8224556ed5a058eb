// SPDX-License-Identifier: BSD-3-Clause
#include "PaintMeter.h"

#include <GL/gl.h>
#include <algorithm>
#include <utility>

namespace offmap::test {

namespace {

double milliseconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

PaintMeter::PaintMeter(window::MainFrame& frame) : stage_(*frame.workspace().stage) {
    stage_.canvas().onPainted = [this, before = stage_.canvas().onPainted] {
        before();
        onPainted();
    };
    stage_.canvas().Bind(wxEVT_MOTION, [this](wxMouseEvent& event) {
        onMotion(stage_.canvas().ClientToScreen(event.GetPosition()));
        event.Skip();  // the canvas turns the camera
    });
}

void PaintMeter::expect(const wxPoint& place) {
    const std::lock_guard lock(mutex_);
    expected_.push_back({Clock::now(), place});
}

/// The toolkit may leave out all but the last of many movements: those before are done with it.
void PaintMeter::onMotion(const wxPoint& place) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(expected_.rbegin(), expected_.rend(),
                                    [&](const Movement& m) { return m.place == place; });
    const auto upTo = static_cast<size_t>(expected_.rend() - found);
    for (; handled_ < upTo; ++handled_) expected_[handled_].handled = Clock::now();
}

/// Movements are handled by the thread that paints, so all that were handled are in the picture.
void PaintMeter::onPainted() {
    glFinish();
    const auto now = Clock::now();
    const std::lock_guard lock(mutex_);
    ++tally_.paints;
    if (const auto shown = stage_.shown(); shown && shown != shown_) {
        shown_ = shown;
        ++tally_.scans;
        tally_.returns += shown->returns.points.size();
    }
    if (renderer_.empty()) renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    for (; handled_ > 0; --handled_) {
        const Movement movement = expected_.front();
        expected_.pop_front();
        tally_.handled.push_back(milliseconds(movement.handled - movement.begun));
        tally_.painted.push_back(milliseconds(now - movement.begun));
    }
}

PaintTally PaintMeter::take() {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    PaintTally taken = std::exchange(tally_, PaintTally());
    taken.seconds = std::chrono::duration<double>(now - std::exchange(since_, now)).count();
    expected_.clear();
    handled_ = 0;
    return taken;
}

std::string PaintMeter::renderer() {
    const std::lock_guard lock(mutex_);
    return renderer_;
}

}  // namespace offmap::test
