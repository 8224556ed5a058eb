// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFiles.h"

#include "input/NamedFiles.h"
#include "input/UsageError.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <system_error>

namespace offmap::app {

namespace fs = std::filesystem;

namespace {

/// Without a slash at its end.
fs::path folderOf(const fs::path& named) {
    return named.has_filename() ? named : named.parent_path();
}

/// The outputs of the command line, and how it calls them.
std::vector<NamedFile> outputsOf(const ReduceOptions& options) {
    return {{"OUT", options.output},
            {"--removed", options.removed},
            {"--report", options.report},
            {"--segments", options.segments},
            {"--inspect", options.inspect}};
}

void requireFolder(const NamedFile& output) {
    const auto& [name, folder] = output;
    if (folder.empty() || fs::is_directory(folder)) return;
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(folderOf(folder), ignored))) {
        throw UsageError(
            fmt::format("{} {} is a file, but a folder is needed: each log gets its own file in it",
                        name, folder.string()));
    }
    static const std::set<std::string> extensionsOfFiles{".rawlog", ".gz", ".json", ".csv"};
    if (extensionsOfFiles.contains(folder.extension().string())) {
        throw UsageError(fmt::format(
            "{} {} would be a folder with a file for each log; end it with / if that is meant",
            name, folder.string()));
    }
}

/// "run7" of "logs/run7.rawlog.gz"
std::string stemOf(const fs::path& log) {
    std::string name = log.filename().string();
    for (const std::string ending : {".rawlog", ".rawlog.gz"}) {
        if (name.size() > ending.size() && name.ends_with(ending)) {
            return name.substr(0, name.size() - ending.size());
        }
    }
    return name;
}

ReduceFiles filesInFolders(const fs::path& log, const ReduceOptions& options) {
    const auto in = [](const fs::path& folder, const std::string& name) {
        return folder.empty() ? folder : folderOf(folder) / name;
    };
    const std::string stem = stemOf(log);
    return {log,
            in(options.output, log.filename().string()),
            in(options.removed, stem + ".rawlog"),
            in(options.report, stem + ".json"),
            in(options.segments, stem + ".csv"),
            in(options.inspect, stem + ".rawlog")};
}

/// Rawlogs of one name cannot stand in one folder.
void requireFoldersOfTheirOwn(const std::vector<NamedFile>& outputs) {
    std::map<fs::path, std::string> nameOf;  // by folder
    for (const auto& [name, output] : outputs) {
        if (output.empty()) continue;
        std::error_code ignored;
        const auto [other, isNew] =
            nameOf.emplace(fs::weakly_canonical(folderOf(output), ignored), name);
        if (isNew) continue;
        throw UsageError(fmt::format("{} and {} are the same folder, {}; give each its own",
                                     other->second, name, output.string()));
    }
}

std::vector<ReduceFiles> filesInFolders(const ReduceOptions& options) {
    for (const NamedFile& output : outputsOf(options)) requireFolder(output);
    requireFoldersOfTheirOwn(
        {{"OUT", options.output}, {"--removed", options.removed}, {"--inspect", options.inspect}});
    std::vector<ReduceFiles> all;
    std::map<fs::path, fs::path> logOf;  // by its name
    for (const fs::path& log : options.inputs) {
        const fs::path name = log.filename();
        if (name.empty() || name == "." || name == "..") {
            throw UsageError(fmt::format("'{}' is no log; name the logs in it", log.string()));
        }
        const auto [other, isNew] = logOf.emplace(name, log);
        if (!isNew) {
            throw UsageError(fmt::format(
                "{} and {} would both become {}; reduce them into folders of their own",
                other->second.string(), log.string(), (folderOf(options.output) / name).string()));
        }
        all.push_back(filesInFolders(log, options));
    }
    return all;
}

}  // namespace

bool writesFolders(const ReduceOptions& options) {
    return options.inputs.size() > 1 || !options.output.has_filename() ||
           fs::is_directory(options.output);
}

std::vector<ReduceFiles> filesOf(const ReduceOptions& options) {
    const bool folders = writesFolders(options);
    std::vector<ReduceFiles> all;
    if (folders) {
        all = filesInFolders(options);
    } else {
        all.push_back({options.inputs.front(), options.output, options.removed, options.report,
                       options.segments, options.inspect});
    }
    std::vector<NamedFile> written, read;
    for (const ReduceFiles& files : all) {
        const std::string ofLog = folders ? " of " + files.input.string() : "";
        read.emplace_back("IN", files.input);
        written.emplace_back("OUT" + ofLog, files.output);
        written.emplace_back("--removed" + ofLog, files.removed);
        written.emplace_back("--report" + ofLog, files.report);
        written.emplace_back("--segments" + ofLog, files.segments);
        written.emplace_back("--inspect" + ofLog, files.inspect);
    }
    read.emplace_back("--map", options.shared.map);
    read.emplace_back("--config", options.shared.config.file);
    read.emplace_back("--trajectory", options.shared.poses.trajectory);
    requireDistinct(written, read);
    return all;
}

void createFolders(const ReduceOptions& options) {
    for (const auto& [name, folder] : outputsOf(options)) {
        if (folder.empty()) continue;
        std::error_code error;
        fs::create_directories(folderOf(folder), error);
        if (!error) continue;
        throw std::runtime_error(
            fmt::format("cannot create the folder {}: {}; name another with {}", folder.string(),
                        error.message(), name));
    }
}

}  // namespace offmap::app
