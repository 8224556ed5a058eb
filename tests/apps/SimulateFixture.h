// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFixture.h"

#include <offmap/evaluation/TruthFile.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace offmap::test {

/// A folder in which `offmap simulate` makes one of its own, "sim".
class SimulateFixture : public testing::Test {
 protected:
    using Path = std::filesystem::path;
    using Arguments = std::vector<std::string>;

    Arguments simulateArguments(const std::string& world, const Arguments& more = {}) const {
        Arguments all{"simulate", world, "-o", sim_};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    RunResult simulate(const std::string& world, const Arguments& more = {}) const {
        const RunResult run = runOffmap(simulateArguments(world, more));
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        return run;
    }

    /// What the summary says under a key.
    static std::string told(const RunResult& run, const std::string& key) {
        std::istringstream lines(run.out);
        std::string line;
        while (std::getline(lines, line)) {
            if (line.starts_with(key)) return line.substr(line.find_first_not_of(' ', key.size()));
        }
        ADD_FAILURE() << "no line '" << key << "' in\n" << run.out;
        return {};
    }

    /// The command line that the summary tells under a key, as a shell runs it.
    static RunResult follow(const RunResult& run, const std::string& key,
                            const std::string& more = {}) {
        const std::string line = told(run, key);
        EXPECT_TRUE(line.starts_with("offmap ")) << line;
        return runProgram(
            {"/bin/sh", "-c", offmapBinary().string() + line.substr(line.find(' ')) + " " + more});
    }

    /// All observations' truth.
    std::vector<evaluation::ObservationTruth> truth() const {
        evaluation::TruthReader reader(sim_ / "truth.csv.gz");
        std::vector<evaluation::ObservationTruth> all;
        while (const auto* one = reader.next()) all.push_back(*one);
        return all;
    }

    /// Those of the log that are of a class.
    template <class Observation>
    std::vector<std::shared_ptr<Observation>> logged() const {
        std::vector<std::shared_ptr<Observation>> all;
        for (const auto& obs : observationsOf(sim_ / "scans.rawlog")) {
            if (auto one = std::dynamic_pointer_cast<Observation>(obs)) all.push_back(one);
        }
        return all;
    }

    nlohmann::json json(const Path& file) const {
        std::ifstream in(file);
        return nlohmann::json::parse(in);
    }

    TemporaryFolder folder_;
    Path sim_ = folder_ / "sim";
};

}  // namespace offmap::test
