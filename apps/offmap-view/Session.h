// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileReader.h"
#include "Playback.h"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace offmap::window {

/// What is to be looked at, and with which parameters.
struct SessionRequest {
    app::LiveRequest live;  ///< its source may be empty, and its map
    rawlog::Config config;
    bool play = false;     ///< else a log waits at its first turn
    uint64_t startAt = 0;  ///< turn of a log
};

/// What is being looked at.
struct Opened {
    std::shared_ptr<const core::LineMap> map;                         ///< never null
    std::string mapDescription, sourceDescription, posesDescription;  ///< empty: there is none
    std::vector<std::string> warnings;
    uint64_t turns = 0;  ///< of the log; 0 of what has no known end
};

/// Why nothing is.
struct Failure {
    std::string message;
    bool isOfMap = false;  ///< the map cannot be read; else the source
};

/// Opens maps and sources on a thread of its own; the functions return at once.
class Session {
 public:
    /// Called by threads of the session.
    struct Events {
        /// What was open is not any more: no more turns of it come.
        std::function<void()> onClosed;
        std::function<void(const Opened&)> onOpened;
        std::function<void(const Failure&)> onFailure;
        PlaybackEvents playback;
    };

    Session(FileReader reader, Events events);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// What is open, or just being opened, is closed before.
    void open(SessionRequest request);
    bool opening() const;
    /// Null while nothing is open.
    std::shared_ptr<Playback> playback() const;
    /// Ends all threads and waits for them.
    void close();

 private:
    void load(const SessionRequest& request, const std::stop_token& stop);
    std::shared_ptr<const core::LineMap> readMap(const SessionRequest& request, Opened& opened,
                                                 const std::stop_token& stop);
    std::shared_ptr<Playback> openSource(const SessionRequest& request, Opened& opened,
                                         const std::stop_token& stop);

    const FileReader reader_;
    const Events events_;
    mutable std::mutex mutex_;  // of what follows
    std::shared_ptr<Playback> playback_;
    bool opening_ = false;

    std::jthread loader_;  // last: it ends before the rest does
};

}  // namespace offmap::window
