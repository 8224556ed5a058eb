// SPDX-License-Identifier: BSD-3-Clause
#include "CraftedEntries.h"
#include "InfoFixture.h"

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

/// Logs that cannot be read, or not to their end.
class BadInfo : public InfoFixture {
 protected:
    void expectUnreadable(const std::string& message) const {
        expectRefusal({"info", in_, "--json"}, 2,
                      AllOf(HasSubstr(in_.string()), HasSubstr(message)));
        EXPECT_EQ(info({"--json"}).out, "");
    }

    /// The first entries must be told, the damage on top.
    void expectDamageAfter(uint64_t entries) const {
        const json facts = InfoFixture::facts({}, 2);
        EXPECT_EQ(facts["log"]["entries"], entries);
        EXPECT_THAT(facts["log"]["damage"].get<std::string>(),
                    HasSubstr("entry " + std::to_string(entries)));
        const RunResult run = info();
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, HasSubstr("damaged"));
        EXPECT_THAT(run.err, HasSubstr("entry " + std::to_string(entries)));
    }
};

TEST_F(BadInfo, missingFile) { expectUnreadable("No such file"); }

TEST_F(BadInfo, emptyFile) {
    writeFile(in_, "");
    expectUnreadable("is empty");
}

TEST_F(BadInfo, noRawlog) {
    writeFile(in_, "x1 y1 x2 y2\n0 0 1 1\n");
    expectUnreadable("is not a rawlog");
}

TEST_F(BadInfo, truncatedLogIsToldAsFarAsItGoes) {
    writeLog(in_, smallLog(), std::nullopt);
    const std::string bytes = readFile(in_);
    writeFile(in_, bytes.substr(0, bytes.size() - 10));
    expectDamageAfter(2);
}

TEST_F(BadInfo, entryThatCrashesItsReaderIsSurvived) {
    writeLog(in_, smallLog(), std::nullopt);
    writeFile(in_, readFile(in_) + actionsHoldingAComment());
    expectDamageAfter(3);
}

TEST_F(BadInfo, wrongCommandLines) {
    writeLog(in_, smallLog());
    expectRefusal({"info"}, 1, HasSubstr("IN is required"));
    expectRefusal({"info", in_, "--pose-label", "NONE"}, 1, HasSubstr("LOCALIZATION"));
    expectRefusal({"info", in_, "--set", "pose.max_ag_s=2"}, 1, HasSubstr("pose.max_age_s"));
    expectRefusal({"info", in_, "--map", folder_ / "none.lines"}, 2, HasSubstr("none.lines"));
    expectRefusal({"info", in_, "--jsno"}, 1, HasSubstr("--jsno"));
}

}  // namespace
