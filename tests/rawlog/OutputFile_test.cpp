// SPDX-License-Identifier: BSD-3-Clause
#include "../support/ForkedChild.h"
#include "../support/Gzip.h"
#include "../support/TemporaryFolder.h"

#include <offmap/rawlog/OutputFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sys/resource.h>
#include <sys/stat.h>

namespace {

using namespace offmap::rawlog;
using offmap::test::inForkedChild;
using offmap::test::readFile;
using offmap::test::TemporaryFolder;
using offmap::test::writeFile;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;

std::string errorOf(const std::filesystem::path& target, const OutputOptions& options = {}) {
    try {
        const OutputFile file(target, options);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "no error";
}

// Incompressible and larger than any buffer on the way.
std::string noise(size_t size) {
    std::mt19937 random(1);
    std::string text(size, '\0');
    for (char& c : text) c = static_cast<char>(random());
    return text;
}

TEST(OutputFile, appearsOnlyWhenPublished) {
    const TemporaryFolder folder;
    OutputFile file(folder / "out.json");
    file.write("{}");
    EXPECT_THAT(folder.names(), ElementsAre(MatchesRegex("\\.out\\.json\\.[a-z0-9]{6}\\.part")));
    EXPECT_EQ(file.finish(), 2U);
    EXPECT_THAT(folder.names(), ElementsAre(testing::StartsWith(".out.json.")));
    file.publish();
    EXPECT_THAT(folder.names(), ElementsAre("out.json"));
    EXPECT_EQ(readFile(folder / "out.json"), "{}");
}

TEST(OutputFile, leavesNothingIfNotPublished) {
    const TemporaryFolder folder;
    {
        OutputFile open(folder / "open"), finished(folder / "finished");
        open.write("something");
        finished.finish();
        EXPECT_EQ(folder.names().size(), 2U);
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(OutputFile, gzipHoldsTheContentAtEveryLevel) {
    const std::string content = noise(3 << 20);
    for (int level : {0, 1, 9}) {
        const TemporaryFolder folder;
        OutputFile file(folder / "out.gz", {level});
        for (size_t at = 0; at < content.size(); at += 100'000) {
            file.write(std::string_view(content).substr(at, 100'000));
        }
        const uint64_t size = file.finish();
        file.publish();
        EXPECT_EQ(std::filesystem::file_size(folder / "out.gz"), size);
        EXPECT_EQ(offmap::test::gunzippedFile(folder / "out.gz"), content);
    }
}

TEST(OutputFile, inThreeStepsIsTheSame) {
    const TemporaryFolder folder;
    const std::string content = noise(3'300'000);
    OutputFile whole(folder / "whole", {1}), steps(folder / "steps", {1});
    whole.write(content);
    for (size_t at = 0; at < content.size(); at += 700'000) {
        const auto part = std::string_view(content).substr(at, 700'000);
        for (const auto& block : steps.cut(std::as_bytes(std::span(part)))) {
            steps.append(steps.packed(block));
        }
    }
    EXPECT_EQ(whole.finish(), steps.finish());
    whole.publish();
    steps.publish();
    EXPECT_TRUE(readFile(folder / "whole") == readFile(folder / "steps"));
    EXPECT_THROW(steps.cut({}), std::logic_error);
}

TEST(OutputFile, gzipOfNothingIsAnEmptyStream) {
    const TemporaryFolder folder;
    OutputFile(folder / "out.gz", {1}).publish();
    EXPECT_GT(std::filesystem::file_size(folder / "out.gz"), 0U);
    EXPECT_EQ(offmap::test::gunzippedFile(folder / "out.gz"), "");
}

TEST(OutputFile, bytesDependOnTheContentAlone) {
    const TemporaryFolder folder;
    for (const char* name : {"a", "b"}) {
        OutputFile file(folder / name, {1});
        file.write("the same");
        file.publish();
    }
    const std::string bytes = readFile(folder / "a");
    EXPECT_EQ(bytes, readFile(folder / "b"));
    EXPECT_EQ(bytes.substr(3, 5), std::string(5, '\0'));  // RFC 1952: no optional field, no time
}

TEST(OutputFile, modeFollowsTheUmask) {
    const TemporaryFolder folder;
    const mode_t before = umask(027);
    OutputFile(folder / "out").publish();
    umask(before);
    struct stat info {};
    ASSERT_EQ(stat((folder / "out").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0640U);
}

TEST(OutputFile, existingFileIsReplacedOnlyIfAllowed) {
    const TemporaryFolder folder;
    writeFile(folder / "out", "old");
    EXPECT_THAT(errorOf(folder / "out"),
                AllOf(HasSubstr("it exists already"), HasSubstr("--force")));
    OutputFile file(folder / "out", {.overwrite = true});
    file.write("new");
    EXPECT_EQ(readFile(folder / "out"), "old");
    file.publish();
    EXPECT_EQ(readFile(folder / "out"), "new");
}

TEST(OutputFile, linkIsReplacedNotFollowed) {
    const TemporaryFolder folder;
    writeFile(folder / "precious", "log");
    std::filesystem::create_symlink(folder / "precious", folder / "out");
    std::filesystem::create_symlink(folder / "nowhere", folder / "dangling");
    EXPECT_THAT(errorOf(folder / "out"), HasSubstr("it exists already"));
    EXPECT_THAT(errorOf(folder / "dangling"), HasSubstr("it exists already"));
    OutputFile(folder / "out", {.overwrite = true}).publish();
    EXPECT_EQ(readFile(folder / "out"), "");
    EXPECT_EQ(readFile(folder / "precious"), "log");
}

TEST(OutputFile, fileThatAppearedMeanwhileIsNotReplaced) {
    const TemporaryFolder folder;
    OutputFile file(folder / "out");
    writeFile(folder / "out", "somebody else's");
    EXPECT_THROW(file.publish(), std::runtime_error);
    EXPECT_EQ(readFile(folder / "out"), "somebody else's");
}

TEST(OutputFile, longestNameIsPossible) {
    const TemporaryFolder folder;
    const std::string longest(255, 'n');
    OutputFile(folder / longest).publish();
    EXPECT_THAT(folder.names(), ElementsAre(longest));
    EXPECT_THAT(errorOf(folder / (longest + "n")), HasSubstr("choose a shorter name"));
}

TEST(OutputFile, impossibleTargetsNameTheFix) {
    const TemporaryFolder folder;
    EXPECT_THAT(errorOf(folder / "no" / "out"),
                AllOf(HasSubstr("No such file"), HasSubstr("create its folder")));
    EXPECT_THAT(errorOf(folder.path()), HasSubstr("it is a folder"));
    EXPECT_THAT(errorOf(folder.path() / ""), HasSubstr("it is a folder"));
    EXPECT_THAT(errorOf("/dev/null", {.overwrite = true}), HasSubstr("not a regular file"));
    EXPECT_THROW(OutputFile(folder / "out", {10}), std::invalid_argument);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(OutputFile, readOnlyFolderNamesTheFix) {
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms{0555});
    const std::string error = inForkedChild([&] {
        offmap::test::dropRoot();
        return errorOf(folder / "out");
    });
    EXPECT_THAT(error, AllOf(HasSubstr("Permission denied"), HasSubstr("folder writable")));
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(OutputFile, fullDiskIsAnErrorAndLeavesNothing) {
    for (const std::optional<int> level : {std::optional<int>(), std::optional(1)}) {
        const TemporaryFolder folder;
        const std::string error = inForkedChild([&]() -> std::string {
            const rlimit limit{100'000, 100'000};
            setrlimit(RLIMIT_FSIZE, &limit);
            OutputFile file(folder / "out", {level});
            file.write(noise(150'000));  // less than the buffers: may show at the end only
            file.finish();
            return "no error";
        });
        EXPECT_THAT(error, AllOf(HasSubstr("File too large"), HasSubstr("ulimit -f")));
        EXPECT_THAT(folder.names(), IsEmpty());
    }
}

TEST(OutputFile, tellsOfItsTemporaryFile) {
    struct Told : TemporaryFiles {
        void add(const std::filesystem::path& file) override {
            EXPECT_FALSE(exists(file));
            present.push_back(file);
        }
        void remove(const std::filesystem::path& file) override {
            EXPECT_FALSE(exists(file));
            EXPECT_THAT(present, testing::Contains(file));
            std::erase(present, file);
        }
        std::vector<std::filesystem::path> present;
    } told;
    const TemporaryFolder folder;
    const OutputOptions options{.temporaries = &told};
    {
        OutputFile published(folder / "a", options), dropped(folder / "b", options);
        EXPECT_EQ(told.present.size(), 2U);
        published.publish();
        EXPECT_EQ(told.present.size(), 1U);
    }
    EXPECT_THAT(told.present, IsEmpty());
    EXPECT_THAT(errorOf(folder / "no" / "out", options), HasSubstr("No such file"));
    EXPECT_THAT(told.present, IsEmpty());
}

}  // namespace
