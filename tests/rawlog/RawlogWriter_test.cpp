// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/RawlogReader.h>
#include <offmap/rawlog/RawlogWriter.h>

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationOdometry.h>

namespace {

using namespace offmap::rawlog;

const std::filesystem::path log = "/usr/share/mrpt/datasets/localization_demo.rawlog";

TEST(RawlogWriter, copiedEntriesAreIdentical) {
    const offmap::test::TemporaryFolder folder;
    RawlogReader reader(log);
    RawlogWriter writer(folder / "copy.rawlog");
    while (const auto entry = reader.next()) writer.writeBytes(entry->bytes);
    writer.publish();
    EXPECT_EQ(offmap::test::gunzippedFile(folder / "copy.rawlog"),
              offmap::test::gunzippedFile(log));
}

TEST(RawlogWriter, mrptReadsWhatWasWritten) {
    const offmap::test::TemporaryFolder folder;
    mrpt::obs::CObservationOdometry odometry;
    odometry.sensorLabel = "ODOMETRY";
    odometry.odometry = {1, 2, 0.5};
    RawlogWriter writer(folder / "x.rawlog");
    writer.write(odometry);
    odometry.odometry = {3, 4, -0.5};
    writer.write(odometry);
    const uint64_t size = writer.finish();
    writer.publish();
    EXPECT_EQ(std::filesystem::file_size(folder / "x.rawlog"), size);

    mrpt::io::CFileGZInputStream file((folder / "x.rawlog").string());
    auto archive = mrpt::serialization::archiveFrom(file);
    const auto first = archive.ReadObject<mrpt::obs::CObservationOdometry>();
    const auto second = archive.ReadObject<mrpt::obs::CObservationOdometry>();
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->odometry, mrpt::poses::CPose2D(1, 2, 0.5));
    EXPECT_EQ(second->odometry, mrpt::poses::CPose2D(3, 4, -0.5));
    EXPECT_EQ(second->sensorLabel, "ODOMETRY");
    EXPECT_THROW(archive.ReadObject(), mrpt::serialization::CExceptionEOF);
}

}  // namespace
