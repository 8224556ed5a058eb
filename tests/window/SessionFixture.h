// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/Places.h"
#include "OfficeLogs.h"
#include "Session.h"
#include "WaitFor.h"

#include <gmock/gmock.h>

#include <mutex>

namespace offmap::test {

/// A session, and what it tells.
class SessionFixture : public testing::Test {
 protected:
    SessionFixture() : session_(window::FileReader({}, offmapBinary()), events()) {
        writeFile(map_, officeMap());
        writeLog(log_, officeDrive(turns));
    }

    window::Session::Events events() {
        window::Session::Events events;
        events.onClosed = [] {};
        events.onOpened = [this](const window::Opened& opened) {
            const std::lock_guard lock(mutex_);
            opened_.push_back(opened);
        };
        events.onFailure = [this](const window::Failure& failure) {
            const std::lock_guard lock(mutex_);
            failures_.push_back(failure.message);
            isOfMap_ = failure.isOfMap;
        };
        events.playback.onFrame = events.playback.onLatest = [](const auto&) {};
        return events;
    }

    void open(const std::filesystem::path& log, const std::filesystem::path& map,
              uint64_t startAt = 0) {
        window::SessionRequest request = requestOf(log, map);
        request.startAt = startAt;
        session_.open(request);
    }
    bool answers(size_t count = 1) {
        return waitFor([&] {
            const std::lock_guard lock(mutex_);
            return opened_.size() + failures_.size() >= count;
        });
    }
    /// What there is to be said about files that cannot be shown.
    std::string complaintAbout(const std::filesystem::path& log, const std::filesystem::path& map) {
        failures_.clear();
        open(log, map);
        if (!answers()) return "no answer";
        EXPECT_THAT(opened_, testing::IsEmpty());
        EXPECT_EQ(session_.playback(), nullptr);
        EXPECT_FALSE(session_.opening());
        return failures_.empty() ? "none" : failures_[0];
    }
    std::filesystem::path fileOf(const std::string& name, const std::string& content) {
        writeFile(folder_ / name, content);
        return folder_ / name;
    }
    /// The number of the turn that is looked at.
    uint64_t turnShown() {
        const auto playback = session_.playback();
        EXPECT_TRUE(waitFor([&] { return playback->latest() != nullptr; }));
        return playback->latest()->arrived.number;
    }

    static constexpr uint64_t turns = 8;  ///< of the log
    TemporaryFolder folder_;
    const std::filesystem::path log_ = folder_ / "drive.rawlog", map_ = folder_ / "office.txt";
    std::mutex mutex_;
    std::vector<window::Opened> opened_;
    std::vector<std::string> failures_;
    bool isOfMap_ = false;     ///< the last failure
    window::Session session_;  // last: its threads call what stands above
};

}  // namespace offmap::test
