// SPDX-License-Identifier: BSD-3-Clause
#include "Exports.h"

#include "FrameIntensities.h"
#include "input/LiveRecorder.h"
#include "input/NamedFiles.h"

#include <offmap/live/LiveReduction.h>
#include <offmap/view/Figure.h>
#include <offmap/view/Render.h>

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace offmap::window {

namespace {

using namespace std::chrono_literals;

app::LiveInput openAtOnce(const SessionRequest& request, const FileReader& reader,
                          const std::stop_token& stop) {
    app::LiveRequest live = request.live;
    live.forWindow = false;  // it is to end
    live.from.speed = "max";
    live.onEntry = [&stop] {
        if (stop.stop_requested()) throw Stopped();
    };
    live.checkLog = [&](const std::filesystem::path& log, const rawlog::Config& config) {
        reader.checkLog(log, config, stop);
    };
    return app::openLiveInput(live, request.config);
}

/// Which numbers have come, and whether that is all.
class RangeWatch {
 public:
    explicit RangeWatch(const TurnRange& range) : range_(range) {}

    bool holds(uint64_t number) const { return number >= range_.first && number <= range_.last; }
    void see(uint64_t number) {
        if (number >= range_.first) begun_ = true;
        if (number >= range_.last) complete_ = true;
    }
    bool begun() const { return begun_; }
    bool complete() const { return complete_; }

 private:
    TurnRange range_;
    std::atomic<bool> begun_ = false, complete_ = false;
};

void reduceTurns(const SessionRequest& request, std::shared_ptr<const core::LineMap> map,
                 const TurnRange& range, app::LiveRecorder& recorder, const FileReader& reader,
                 const std::stop_token& stop) {
    app::LiveInput input = openAtOnce(request, reader, stop);
    RangeWatch watch(range);
    live::LiveOptions options;
    options.onFrame = [&](const live::LiveFramePtr& frame) {
        if (input.tracked && frame->reduced.vehicleInMap) {
            input.tracked->correct(*frame->reduced.vehicleInMap, frame->reduced.record.time);
        }
        if (watch.holds(frame->arrived.number)) recorder.add(*frame);
        watch.see(frame->arrived.number);
    };
    // Tracked poses need all turns before the first.
    if (!input.tracked) input.replay->jumpTo(range.first);
    live::LiveReduction reduction(
        std::move(input.source), {std::move(map), input.poses, request.config}, std::move(options));
    while (!reduction.waitUntilFinished(20ms) && !watch.complete()) {
        if (stop.stop_requested()) throw Stopped();
    }
    reduction.stop();
    if (!reduction.failure().empty()) throw std::runtime_error(reduction.failure());
    const live::SourceHealth health = reduction.source().health();
    if (health.state == live::SourceState::Failed) throw std::runtime_error(health.message);
    if (!watch.begun()) {
        throw std::runtime_error(fmt::format("{}: it has no turn {}; it ends before",
                                             request.live.from.source, range.first + 1));
    }
}

}  // namespace

Exports::Exports(FileReader reader, Events events)
    : reader_(std::move(reader)), events_(std::move(events)) {}

void Exports::close() {
    if (!worker_.joinable()) return;
    worker_.request_stop();
    worker_.join();
}

void Exports::begin(const std::filesystem::path& file,
                    std::function<void(const std::stop_token&)> work) {
    worker_ = std::jthread([this, file, work = std::move(work),
                            before = std::move(worker_)](const std::stop_token& stop) mutable {
        {
            const std::stop_callback both(stop, [&before] { before.request_stop(); });
            if (before.joinable()) before.join();
        }
        if (stop.stop_requested()) return;
        try {
            work(stop);
            events_.onDone("wrote " + file.string());
        } catch (const Stopped&) {
            return;
        } catch (const std::exception& error) {
            events_.onFailure(error.what());
        }
    });
}

void Exports::writeFigure(const live::LiveFramePtr& frame,
                          const std::shared_ptr<const core::LineMap>& map,
                          const SceneChoices& choices, const Theme& theme,
                          const std::filesystem::path& file) {
    view::FigureOptions options;
    options.intensities = intensitiesOf(*frame);
    options.title = fmt::format("turn {}", frame->arrived.number + 1);
    options.colourBy = choices.colourBy;
    options.scene = sceneOptionsOf(choices, theme.palette);
    options.fallbackSensorInMap = mrpt::poses::CPose3D();
    begin(file, [=](const std::stop_token&) {
        view::writePng(view::figureOf(frame->reduced.organized.scan, frame->result, *map, options),
                       file);
    });
}

void Exports::writeTurns(const SessionRequest& request,
                         const std::shared_ptr<const core::LineMap>& map, const TurnRange& range,
                         const std::filesystem::path& file) {
    begin(file, [=, this](const std::stop_token& stop) {
        app::requireDistinct({{"the export", file}}, {{"the log", request.live.from.source},
                                                      {"the map", request.live.shared.map}});
        app::LiveRecorder recorder(file, true);
        reduceTurns(request, map, range, recorder, reader_, stop);
        recorder.publish();
    });
}

}  // namespace offmap::window
