// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileReader.h"
#include "SceneChoices.h"
#include "Session.h"
#include "Theme.h"

#include <filesystem>
#include <functional>
#include <string>
#include <thread>

namespace offmap::window {

/// Turns of a log, from 0.
struct TurnRange {
    uint64_t first = 0, last = 0;
};

/// Writes files from what is open, one after the other, on a thread of its own.
class Exports {
 public:
    /// Called by that thread.
    struct Events {
        std::function<void(const std::string&)> onDone;     ///< what was written
        std::function<void(const std::string&)> onFailure;  ///< with file and cause
    };

    Exports(FileReader reader, Events events);

    /// The scan as the command `offmap render` draws it. \param file PNG
    void writeFigure(const live::LiveFramePtr& frame,
                     const std::shared_ptr<const core::LineMap>& map, const SceneChoices& choices,
                     const Theme& theme, const std::filesystem::path& file);
    /// Reduces these turns of the log anew and writes them. \param request of the log
    void writeTurns(const SessionRequest& request, const std::shared_ptr<const core::LineMap>& map,
                    const TurnRange& range, const std::filesystem::path& file);
    /// Ends what is going on; no file is left unfinished.
    void close();

 private:
    void begin(const std::filesystem::path& file, std::function<void(const std::stop_token&)> work);

    const FileReader reader_;
    const Events events_;
    std::jthread worker_;  // last: it ends before the rest does
};

}  // namespace offmap::window
