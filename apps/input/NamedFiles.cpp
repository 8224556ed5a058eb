// SPDX-License-Identifier: BSD-3-Clause
#include "NamedFiles.h"

#include "UsageError.h"

#include <fmt/format.h>

#include <map>
#include <sys/stat.h>
#include <system_error>

namespace offmap::app {

namespace {

/// Files by what they are, whatever their paths look like: a thousand logs are soon compared.
class KnownFiles {
 public:
    void add(const NamedFile& file) {
        if (file.second.empty()) return;
        byPath_.try_emplace(canonical(file.second), file.first);
        struct stat info {};
        if (stat(file.second.c_str(), &info) == 0) {
            byNode_.try_emplace({info.st_dev, info.st_ino}, file.first);
        }
    }

    /// How the command line calls the same file, if it is known; else null.
    const std::string* find(const std::filesystem::path& file) const {
        const auto path = byPath_.find(canonical(file));
        if (path != byPath_.end()) return &path->second;
        struct stat info {};
        if (stat(file.c_str(), &info) != 0) return nullptr;
        const auto node = byNode_.find({info.st_dev, info.st_ino});
        return node == byNode_.end() ? nullptr : &node->second;
    }

 private:
    static std::filesystem::path canonical(const std::filesystem::path& file) {
        std::error_code error;
        const auto canonical = std::filesystem::weakly_canonical(file, error);
        return error ? file.lexically_normal() : canonical;
    }

    std::map<std::filesystem::path, std::string> byPath_;
    std::map<std::pair<dev_t, ino_t>, std::string> byNode_;
};

}  // namespace

void requireDistinct(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read) {
    KnownFiles known;
    for (const NamedFile& file : read) known.add(file);
    for (const NamedFile& file : written) {
        if (file.second.empty()) continue;
        if (const std::string* name = known.find(file.second)) {
            throw UsageError(fmt::format("{} and {} are the same file, {}; give each its own",
                                         *name, file.first, file.second.string()));
        }
        known.add(file);
    }
}

}  // namespace offmap::app
