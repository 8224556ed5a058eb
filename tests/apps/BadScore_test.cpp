// SPDX-License-Identifier: BSD-3-Clause
#include "ScoreFixture.h"

#include <algorithm>

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

/// Two clouds and their truth, of which something is wrong.
class BadScore : public ScoreFixture {
 protected:
    BadScore() {
        SimulatedRobot robot;
        log_.push_back(robot.cloud());
        robot.wait(1);
        log_.push_back(robot.cloud());
        writeLog(in_, log_);
        good_ = truthOf(in_, [](size_t i) { return i % 2 == 0; });
        writeTruth(good_);
    }

    template <class Matcher>
    void expectRefused(const Matcher& message, int exitCode = 2, const Arguments& more = {}) const {
        expectRefusal(scoreArguments(in_, more), exitCode, message);
    }

    Observations log_;
    Truth good_;
};

TEST_F(BadScore, scanThatIsNotInTheLogIsNamed) {
    writeLog(in_, Observations{log_[0]});
    expectRefused(AllOf(HasSubstr("1 observation with "), HasSubstr("is not in " + in_.string()),
                        HasSubstr("first 'CLOUD' at 1700000001.000000 s"),
                        HasSubstr("--partial scores what is in both")));
}

TEST_F(BadScore, scanThatTheTruthDoesNotKnowIsNamed) {
    writeTruth({good_[1]});
    expectRefused(AllOf(HasSubstr("1 observation with "), HasSubstr("not in " + truth_.string()),
                        HasSubstr("first 'CLOUD' at 1700000000.000000 s")));
}

TEST_F(BadScore, partialScoresWhatIsInBoth) {
    writeLog(in_, Observations{log_[1]});
    const RunResult run = runOffmap(scoreArguments(in_, {"--partial", "--json", json_}));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, AllOf(testing::StartsWith("warning: "), HasSubstr("1700000000.000000")));
    const auto score = nlohmann::json::parse(readFile(json_));
    EXPECT_EQ(score["observations_missing"], 1);
    EXPECT_EQ(score["points"], good_[1].points.size());
}

TEST_F(BadScore, truthOfAnotherLogIsTold) {
    Truth other = good_;
    for (auto& observation : other) observation.sensor = "OTHER";
    writeTruth(other);
    const auto message = AllOf(HasSubstr(truth_.string() + " is the truth of another log"),
                               HasSubstr("2 observations with"));
    expectRefused(message);
    expectRefused(message, 2, {"--partial"});
}

TEST_F(BadScore, pointsThatTheTruthDoesNotKnowAreCounted) {
    Truth other = good_;
    other[1].points.resize(other[1].points.size() - 3);
    writeTruth(other);
    const auto message = AllOf(HasSubstr("3 points of " + in_.string()),
                               HasSubstr("in 1 observation, first 'CLOUD' at 1700000001"));
    expectRefused(message);
    expectRefused(message, 2, {"--partial"});
}

TEST_F(BadScore, truthInAnotherOrderIsRefused) {
    writeTruth({good_[1], good_[0]});
    expectRefused(AllOf(HasSubstr(truth_.string()), HasSubstr("must stand in the order of")));
    writeTruth({good_[0], good_[1], good_[0]});
    expectRefused(HasSubstr("too late or twice"));
}

TEST_F(BadScore, observationsThatCannotBeToldApartAreRefused) {
    writeLog(in_, Observations{log_[0], log_[0]});
    expectRefused(AllOf(HasSubstr(in_.string()), HasSubstr("two 3D observations 'CLOUD'")));
}

TEST_F(BadScore, emptyFilesAreTold) {
    writeTruth({});
    expectRefused(HasSubstr("tells of no return"));
    writeFile(truth_, "");
    expectRefused(HasSubstr(truth_.string() + " is empty"));
    writeTruth(good_);
    writeFile(in_, "");
    expectRefused(HasSubstr(in_.string() + " is empty"));
}

TEST_F(BadScore, missingFilesAreTold) {
    std::filesystem::remove(in_);
    expectRefused(AllOf(HasSubstr("cannot open " + in_.string()), HasSubstr("check the path")));
    std::filesystem::remove(truth_);
    expectRefused(AllOf(HasSubstr("cannot open " + truth_.string()), HasSubstr("check the path")));
    expectRefusal({"score"}, 1, HasSubstr("TRUTH is required"));
}

TEST_F(BadScore, badRowIsNamed) {
    std::string text = readFile(truth_);
    text.insert(text.find('\n') + 1, "0,1.0000000,A,1,2,three,0,floor,,0\n");
    writeFile(truth_, text);
    expectRefused(AllOf(HasSubstr(truth_.string() + ", line 2: "), HasSubstr("z_m is 'three'")));
}

TEST_F(BadScore, damagedLogIsTold) {
    const std::string content = readFile(in_);
    writeFile(in_, content.substr(0, content.size() / 2));
    expectRefused(AllOf(HasSubstr(in_.string() + ": entry "), HasSubstr("truncated or corrupt")));
}

TEST_F(BadScore, filesMustDiffer) {
    expectRefused(HasSubstr("--json"), 1, {"--json", in_});
    expectRefused(HasSubstr("--json"), 1, {"--json", truth_});
}

TEST_F(BadScore, existingScoreNeedsForce) {
    writeFile(json_, "{}");
    expectRefused(AllOf(HasSubstr(json_.string()), HasSubstr("exists already")), 2,
                  {"--json", json_});
}

TEST_F(BadScore, wrongParametersAreUsageErrors) {
    expectRefused(HasSubstr("no.such"), 1, {"--set", "no.such=1"});
    expectRefused(HasSubstr("nowhere"), 1, {"--config", "nowhere"});
}

}  // namespace
