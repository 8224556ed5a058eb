// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../OfficeLogs.h"
#include "OpenedFrame.h"

#include <gmock/gmock.h>

#include <memory>

namespace offmap::test {

/// Files for a window to open, good and bad, and settings for it to keep.
class FrameFixture : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        writeLog(log(), officeDrive(turns));
        writeLog(*folder_ / "other.rawlog", officeDrive(3));
        writeFile(map(), officeMap());
        writeFile(*folder_ / "bad.rawlog", "no log");
        writeFile(*folder_ / "bad.txt", "1 2 3\n");
    }
    static void TearDownTestSuite() { folder_.reset(); }
    static std::filesystem::path log() { return *folder_ / "drive.rawlog"; }
    static std::filesystem::path map() { return *folder_ / "office.txt"; }

    /// As at the next start of the program.
    std::unique_ptr<OpenedFrame> opened(const window::SessionRequest& request) {
        return std::make_unique<OpenedFrame>(settings_ / "settings", request);
    }
    std::unique_ptr<OpenedFrame> opened(const std::filesystem::path& logFile,
                                        const std::filesystem::path& mapFile) {
        return opened(requestOf(logFile, mapFile));
    }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static constexpr uint64_t turns = 12;  ///< of the log
    TemporaryFolder settings_;
};

}  // namespace offmap::test
