// SPDX-License-Identifier: BSD-3-Clause
#include "FileReader.h"

#include "ChildProcess.h"
#include "ViewOptions.h"
#include "input/GuardedMap.h"
#include "input/PackedMap.h"

#include <offmap/rawlog/ParameterTable.h>
#include <offmap/rawlog/RegisterClasses.h>

#include <fmt/format.h>

#include <cstdio>
#include <string_view>

namespace offmap::window {

namespace {

constexpr std::string_view mode = "--read-for-window", endOfSettings = "--";

enum ReaderCode : int { gaveBytes = 0, gaveMessage = 2 };

/// What follows the mode: task, file, settings, the end of these, the window's own arguments.
struct Task {
    std::string name;
    std::filesystem::path file;
    std::vector<std::string> settings, arguments;
};

Task taskOf(const std::vector<std::string>& words) {
    Task task{words.at(0), words.at(1), {}, {}};
    size_t i = 2;
    for (; words.at(i) != endOfSettings; ++i) task.settings.push_back(words[i]);
    task.arguments.assign(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
    return task;
}

app::Bytes done(Task task) {
    ViewOptions options;
    CLI::App command;
    options.addTo(command);
    std::reverse(task.arguments.begin(), task.arguments.end());  // CLI11 takes them from the back
    command.parse(std::move(task.arguments));
    const rawlog::Config config = options.shared.LogOptions::readConfig(task.settings);
    if (task.name == "map") {
        return app::packed(app::readMapGuarded(task.file, options.shared.mapFile.request(config)));
    }
    rawlog::registerMrptClasses();
    app::requireReadable(task.file, config);
    return {};
}

}  // namespace

app::Bytes FileReader::ask(const std::string& task, const std::filesystem::path& file,
                           const rawlog::Config& config, const std::stop_token& stop) const {
    std::vector<std::string> words{std::string(mode), task, file.string()};
    for (const rawlog::Parameter& parameter : rawlog::parameters()) {
        words.push_back(fmt::format("{}={}", parameter.key, parameter.text(config)));
    }
    words.emplace_back(endOfSettings);
    words.insert(words.end(), arguments_.begin(), arguments_.end());
    ChildOutcome outcome = runProgram(program_, words, stop);
    if (stop.stop_requested()) throw Stopped();
    if (outcome.exitCode == gaveBytes) return std::move(outcome.output);
    if (outcome.exitCode == gaveMessage && !outcome.output.empty()) {
        throw std::runtime_error(std::string(outcome.output.begin(), outcome.output.end()));
    }
    throw std::runtime_error(
        fmt::format("{}: cannot be read: the reading process ended with code {}", file.string(),
                    outcome.exitCode));
}

maps::MapOfFile FileReader::readMap(const std::filesystem::path& map, const rawlog::Config& config,
                                    const std::stop_token& stop) const {
    return app::unpacked(ask("map", map, config, stop));
}

void FileReader::checkLog(const std::filesystem::path& log, const rawlog::Config& config,
                          const std::stop_token& stop) const {
    ask("log", log, config, stop);
}

bool FileReader::isWanted(int argc, char** argv) { return argc > 1 && argv[1] == mode; }

int FileReader::run(int argc, char** argv) {
    app::Bytes out;
    int code = gaveBytes;
    try {
        out = done(taskOf({argv + 2, argv + argc}));
    } catch (const std::exception& error) {
        const std::string_view message = error.what();
        out.assign(message.begin(), message.end());
        code = gaveMessage;
    }
    const bool written = std::fwrite(out.data(), 1, out.size(), stdout) == out.size();
    return written && std::fflush(stdout) == 0 ? code : 1;
}

}  // namespace offmap::window
