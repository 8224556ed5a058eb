// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReduceFixture.h"

namespace offmap::test {

/// A folder of logs, and one that does not exist yet for what they are reduced to.
class ManyLogs : public ReduceFixture {
 protected:
    ManyLogs() { std::filesystem::create_directory(logs_); }

    /// A log of its own noise, as long as its number says.
    Path writeGoodLog(int number) const {
        SimulatedRobot robot(static_cast<uint64_t>(number));
        Observations log;
        for (int scan = 0; scan < number; ++scan) {
            log.insert(log.end(), {robot.localisation(), robot.cloud()});
            robot.wait(0.1);
        }
        const Path file = logs_ / ("run" + std::to_string(number) + ".rawlog");
        writeLog(file, log);
        return file;
    }

    Arguments manyArguments(const std::vector<Path>& logs, const Arguments& more = {}) const {
        Arguments all{"reduce"};
        all.insert(all.end(), logs.begin(), logs.end());
        all.insert(all.end(), {"--map", map_, "-o", reduced_});
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    RunResult reduceMany(const std::vector<Path>& logs, const Arguments& more = {}) const {
        return runOffmap(manyArguments(logs, more));
    }

    static std::vector<std::string> namesIn(const Path& folder) {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            names.push_back(entry.path().filename());
        }
        return names;
    }

    const Path logs_ = folder_ / "logs", reduced_ = folder_ / "deep" / "reduced";
};

}  // namespace offmap::test
