// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RawlogWriter.h>

#include <gtest/gtest.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace offmap::rawlog {

inline const std::filesystem::path datasets = "/usr/share/mrpt/datasets";

struct ReadLog {
    std::string bytes;              ///< of all entries
    std::vector<uint64_t> offsets;  ///< of each entry
    std::string error;
    EntryPlace errorPlace;
    friend bool operator==(const ReadLog&, const ReadLog&) = default;
};

inline ReadLog readAll(const std::filesystem::path& file, Reading reading) {
    ReadLog log;
    try {
        RawlogReader reader(file, {}, reading);
        while (const auto entry = reader.next()) {
            EXPECT_EQ(entry->place, (EntryPlace{log.offsets.size(), log.bytes.size()}));
            log.offsets.push_back(entry->place.offset);
            log.bytes.append(reinterpret_cast<const char*>(entry->bytes.data()),
                             entry->bytes.size());
        }
        EXPECT_EQ(reader.compressedPosition(), reader.compressedSize());
    } catch (const RawlogError& e) {
        log.error = e.what();
        log.errorPlace = e.place;
    }
    return log;
}

/// It makes no difference who reads the file.
inline ReadLog readAll(const std::filesystem::path& file) {
    ReadLog log = readAll(file, Reading{});
    EXPECT_TRUE(log == readAll(file, Reading{.ahead = true}));
    return log;
}

// Three small entries: every place where it can break is tried.
inline std::string smallLog() {
    const test::TemporaryFolder folder;
    RawlogWriter writer(folder / "small.rawlog");
    mrpt::obs::CObservationComment comment;
    comment.text = "recorded by hand";
    mrpt::obs::CObservationOdometry odometry;
    odometry.sensorLabel = "ODOMETRY";
    writer.write(comment);
    writer.write(odometry);
    writer.write(comment);
    writer.publish();
    return test::gunzippedFile(writer.target());
}

class RawlogReaderOnFile : public testing::Test {
 protected:
    ReadLog readContent(const std::string& content) {
        test::writeFile(file_, content);
        return readAll(file_);
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "x.rawlog";
};

}  // namespace offmap::rawlog
