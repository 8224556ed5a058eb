// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "Priority.h"
#include "TurnCount.h"
#include "input/LoadedMap.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace offmap::window {

namespace {

/// Why a log has nothing to show.
std::string nothingToShow(const std::string& log, const rawlog::LogSurvey& survey) {
    if (survey.damage) return survey.damage->what();
    std::vector<std::string> classes;
    for (const auto& [label, sensor] : survey.sensors) {
        classes.push_back(sensor.unsupported.value_or(sensor.className));
    }
    return fmt::format("{}: no 3D scans in {} entries ({}); `offmap info` tells what it holds", log,
                       survey.entries, fmt::join(classes, ", "));
}

}  // namespace

Session::Session(FileReader reader, Events events)
    : reader_(std::move(reader)), events_(std::move(events)) {}

Session::~Session() { close(); }

void Session::close() {
    if (loader_.joinable()) {
        loader_.request_stop();
        loader_.join();
    }
    std::shared_ptr<Playback> ending;
    {
        const std::lock_guard lock(mutex_);
        ending = std::move(playback_);
        opening_ = false;
    }
}

bool Session::opening() const {
    const std::lock_guard lock(mutex_);
    return opening_;
}

std::shared_ptr<Playback> Session::playback() const {
    const std::lock_guard lock(mutex_);
    return playback_;
}

void Session::open(SessionRequest request) {
    {
        const std::lock_guard lock(mutex_);
        opening_ = true;
    }
    loader_.request_stop();
    // The one before is waited for by the new thread, not by whoever calls.
    loader_ = std::jthread([this, before = std::move(loader_),
                            request = std::move(request)](const std::stop_token& stop) mutable {
        if (before.joinable()) before.join();
        standBack();
        load(request, stop);
    });
}

void Session::load(const SessionRequest& request, const std::stop_token& stop) {
    std::shared_ptr<Playback> playback;
    {
        const std::lock_guard lock(mutex_);
        playback = std::exchange(playback_, nullptr);
    }
    playback.reset();  // its threads end here
    events_.onClosed();
    Opened opened;
    bool readsMap = true;
    try {
        opened.map = readMap(request, opened, stop);
        readsMap = false;
        if (!request.live.from.source.empty()) playback = openSource(request, opened, stop);
    } catch (const Stopped&) {
        return;  // the next thread is at work
    } catch (const std::exception& error) {
        {
            const std::lock_guard lock(mutex_);
            opening_ = false;
        }
        events_.onFailure({error.what(), readsMap});
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        if (stop.stop_requested()) return;
        playback_ = std::move(playback);
        opening_ = false;
    }
    events_.onOpened(opened);
}

std::shared_ptr<const core::LineMap> Session::readMap(const SessionRequest& request, Opened& opened,
                                                      const std::stop_token& stop) {
    const std::string file = request.live.shared.map.string();
    if (file.empty()) return std::make_shared<core::LineMap>(std::vector<core::Wall>());
    app::LoadedMap loaded = app::loadedMapOf(reader_.readMap(file, request.config, stop), file);
    opened.warnings = std::move(loaded.warnings);
    opened.mapDescription = std::move(loaded.description);
    return std::make_shared<core::LineMap>(std::move(loaded.lines));
}

std::shared_ptr<Playback> Session::openSource(const SessionRequest& request, Opened& opened,
                                              const std::stop_token& stop) {
    app::LiveRequest live = request.live;
    live.onEntry = [&stop] {
        if (stop.stop_requested()) throw Stopped();
    };
    live.checkLog = [&](const std::filesystem::path& log, const rawlog::Config& config) {
        reader_.checkLog(log, config, stop);
    };
    app::LiveInput input = app::openLiveInput(live, request.config);
    if (input.survey && !input.survey->holdsScans()) {
        throw std::runtime_error(nothingToShow(live.from.source, *input.survey));
    }
    opened.sourceDescription = input.description;
    opened.posesDescription = input.posesDescription;
    if (opened.map->walls().empty()) {
        opened.warnings.emplace_back("no map: nothing can be removed; open one (Ctrl+M)");
    } else if (!input.warning.empty())
        opened.warnings.push_back(input.warning);
    if (input.survey && input.survey->damage) {
        opened.warnings.emplace_back(input.survey->damage->what());
    }
    if (input.replay) {
        opened.turns = turnsIn(live.from.source, *input.survey, request.config, live.onEntry);
    }
    live::LiveSetup setup{opened.map, input.poses, request.config};
    return std::make_shared<Playback>(std::move(input), std::move(setup), events_.playback,
                                      request.play, request.startAt);
}

}  // namespace offmap::window
