// SPDX-License-Identifier: BSD-3-Clause
#include "ManyLogsFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
namespace fs = std::filesystem;

using ManyLogsFolders = ManyLogs;

TEST_F(ManyLogsFolders, ofOneNameAreRefused) {
    const Path log = writeGoodLog(1), other = folder_ / "run1.rawlog";
    fs::copy_file(log, other);
    expectRefusal(manyArguments({log, other}), 1,
                  AllOf(HasSubstr("would both become " + (reduced_ / "run1.rawlog").string()),
                        HasSubstr(other.string())));
    expectRefusal(manyArguments({log, log}), 1, HasSubstr("would both become"));
}

TEST_F(ManyLogsFolders, reportsThatWouldBeOneAreRefused) {
    const Path log = writeGoodLog(1), packed = logs_ / "run1.rawlog.gz";
    fs::copy_file(log, packed);
    expectRefusal(manyArguments({log, packed}, {"--report", folder_ / "reports"}), 1,
                  HasSubstr("run1.json; give each its own"));
    EXPECT_EQ(reduceMany({log, packed}).exitCode, 0);
    EXPECT_THAT(namesIn(reduced_), UnorderedElementsAre("run1.rawlog", "run1.rawlog.gz"));
}

TEST_F(ManyLogsFolders, needAFolder) {
    const Path log = writeGoodLog(1), other = writeGoodLog(2), file = folder_ / "file";
    writeFile(file, "");
    Arguments arguments{"reduce", log, other, "--map", map_, "-o", file, "--force"};
    expectRefusal(arguments, 1, HasSubstr("OUT " + file.string() + " is a file"));
    arguments[6] = folder_ / "all.rawlog";
    expectRefusal(arguments, 1, HasSubstr("would be a folder"));
    expectRefusal(manyArguments({log, other}, {"--report", file}), 1,
                  HasSubstr("--report " + file.string() + " is a file"));
    expectRefusal(manyArguments({log, other}, {"--removed", reduced_.string() + "/"}), 1,
                  HasSubstr("OUT and --removed are the same folder"));
    expectRefusal(manyArguments({log, logs_.string() + "/"}), 1, HasSubstr("is no log"));
    arguments[6] = file / "below";
    expectRefusal(arguments, 2, HasSubstr("cannot create the folder"));
}

TEST_F(ManyLogsFolders, mayNotBecomeTheirInputs) {
    const Path log = writeGoodLog(1), other = writeGoodLog(2);
    Arguments arguments{"reduce", log, other, "--map", map_, "-o", logs_, "--force"};
    expectRefusal(arguments, 1, HasSubstr("IN and OUT of " + log.string() + " are the same file"));
    expectRefusal(manyArguments({log, other}, {"--removed", logs_, "--force"}), 1,
                  HasSubstr("IN and --removed of " + log.string() + " are the same file"));
}

TEST_F(ManyLogsFolders, folderTakesASingleLogToo) {
    const Path log = writeGoodLog(1), existing = folder_ / "existing";
    fs::create_directory(existing);
    for (const std::string& folder : {existing.string(), (folder_ / "new").string() + "/"}) {
        const RunResult run = runOffmap({"reduce", log, "--map", map_, "-o", folder});
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_THAT(namesIn(folder), UnorderedElementsAre("run1.rawlog"));
    }
}

}  // namespace
