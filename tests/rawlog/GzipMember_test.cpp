// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/GzipMember.h>

#include <gtest/gtest.h>

#include <random>
#include <thread>

namespace {

using offmap::rawlog::gzipMember;

std::string memberOf(std::string_view content, int level) {
    const auto member = gzipMember(std::as_bytes(std::span(content)), level);
    return {reinterpret_cast<const char*>(member.data()), member.size()};
}

/// Compressible, but not too well.
std::string digits(size_t size) {
    std::string text;
    for (uint64_t i = 1; text.size() < size; ++i) text += std::to_string(i * i);
    text.resize(size);
    return text;
}

TEST(GzipMember, zlibReadsWhatIsInIt) {
    const offmap::test::TemporaryFolder folder;
    for (const std::string& content : {std::string(), std::string("a"), digits(300'000)}) {
        for (int level = 0; level <= 9; ++level) {
            offmap::test::writeFile(folder / "member.gz", memberOf(content, level));
            EXPECT_TRUE(offmap::test::gunzippedFile(folder / "member.gz") == content) << level;
        }
    }
}

TEST(GzipMember, noiseGrowsByALittle) {
    std::mt19937 random(1);
    std::string noise(1'000'000, ' ');
    for (char& c : noise) c = static_cast<char>(random());
    const offmap::test::TemporaryFolder folder;
    for (const int level : {1, 6}) {
        const std::string member = memberOf(noise, level);
        EXPECT_LT(member.size(), noise.size() + 1'000) << level;
        offmap::test::writeFile(folder / "noise.gz", member);
        EXPECT_TRUE(offmap::test::gunzippedFile(folder / "noise.gz") == noise) << level;
    }
}

TEST(GzipMember, higherLevelIsSmaller) {
    const std::string content = digits(300'000);
    EXPECT_LT(memberOf(content, 1).size(), content.size());
    EXPECT_LT(memberOf(content, 9).size(), memberOf(content, 1).size());
}

TEST(GzipMember, isTheSameInAnotherThreadAndAfterOthers) {
    const std::string content = digits(300'000);
    const std::string first = memberOf(content, 1);
    memberOf("something else", 1);
    EXPECT_TRUE(memberOf(content, 1) == first);
    std::string elsewhere;
    std::thread([&] { elsewhere = memberOf(content, 1); }).join();
    EXPECT_TRUE(elsewhere == first);
}

TEST(GzipMember, levelsOutsideAreRefused) {
    EXPECT_THROW(memberOf("a", -1), std::invalid_argument);
    EXPECT_THROW(memberOf("a", 10), std::invalid_argument);
}

}  // namespace
