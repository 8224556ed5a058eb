// SPDX-License-Identifier: BSD-3-Clause
#include "../support/TemporaryFolder.h"

#include <offmap/maps/TextMap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <unistd.h>

namespace offmap::maps {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// A folder of its own for each test, gone afterwards.
class TextMapFile : public testing::Test {
 protected:
    TextMapFile() { fs::permissions(folder_, fs::perms::owner_all | fs::perms::others_exec); }

    fs::path written(const std::string& name, const std::string& text) const {
        test::writeFile(folder_ / name, text);
        return folder_ / name;
    }

    const test::TemporaryFolder temporary_;
    const fs::path& folder_ = temporary_.path();
};

std::string errorOf(const fs::path& file) {
    try {
        readTextMap(file, 0.03);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

TEST_F(TextMapFile, anyExtensionIsRead) {
    EXPECT_EQ(readTextMap(written("plan.dxf", "0 0 1 0\n"), 0.03).size(), 1U);
    EXPECT_EQ(readTextMap(written("plan", "0 0 1 0\n"), 0.03).size(), 1U);
}

TEST_F(TextMapFile, errorsNameFileAndLine) {
    const fs::path file = written("office plan.lines", "0 0 1 0\n0 0\n");
    EXPECT_THAT(errorOf(file), HasSubstr(file.string() + ":2: 2 fields"));
}

TEST_F(TextMapFile, missingFileIsNamed) {
    EXPECT_THAT(errorOf(folder_ / "nothing.lines"),
                AllOf(HasSubstr("nothing.lines"), HasSubstr("No such file")));
}

TEST_F(TextMapFile, folderIsNamed) {
    EXPECT_THAT(errorOf(folder_), AllOf(HasSubstr(folder_.string()), HasSubstr("is a folder")));
}

TEST_F(TextMapFile, emptyFileHoldsNoWall) {
    EXPECT_THAT(errorOf(written("empty.lines", "")), HasSubstr("holds no wall"));
}

TEST_F(TextMapFile, fileWithoutPermissionIsNamed) {
    const fs::path file = written("secret.lines", "0 0 1 0\n");
    fs::permissions(file, fs::perms::none);
    constexpr uid_t nobody = 65534;
    const bool privileged = geteuid() == 0;  // root may read anything
    ASSERT_TRUE(!privileged || seteuid(nobody) == 0);
    const std::string error = errorOf(file);
    ASSERT_TRUE(!privileged || seteuid(0) == 0);
    EXPECT_THAT(error, AllOf(HasSubstr("secret.lines"), HasSubstr("Permission denied")));
}

TEST_F(TextMapFile, failingReadIsAnErrorNotAnEmptyMap) {
    // The first page of a process is never mapped: opening works, reading does not.
    EXPECT_THAT(errorOf("/proc/self/mem"), HasSubstr("cannot read the map: Input/output error"));
}

TEST_F(TextMapFile, aMillionWallsCanBeRead) {
    constexpr size_t count = 1'000'000;
    std::string text;
    for (size_t i = 0; i < count; ++i)
        text += std::to_string(0.001 * static_cast<double>(i)) + " 0 -12.345 67.89 0.02\n";
    const auto walls = readTextMap(written("city.lines", text), 0.03);
    ASSERT_EQ(walls.size(), count);
    EXPECT_EQ(walls.back().line.point1.x, 999.999);
}

}  // namespace
}  // namespace offmap::maps
