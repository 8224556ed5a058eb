// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "WaitFor.h"

#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace offmap::test {

/// A file that whoever reads it waits for, as on a disk that does not answer.
class EndlessFile {
 public:
    explicit EndlessFile(std::filesystem::path path) : path_(std::move(path)) {
        if (mkfifo(path_.c_str(), 0600) != 0) throw std::runtime_error("no FIFO " + path_.string());
    }
    ~EndlessFile() {
        if (writing_ >= 0) close(writing_);
    }
    EndlessFile(const EndlessFile&) = delete;
    EndlessFile& operator=(const EndlessFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Waits until somebody reads it.
    bool isRead() {
        return waitFor([this] {
            if (writing_ < 0) writing_ = open(path_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
            return writing_ >= 0;
        });
    }

 private:
    const std::filesystem::path path_;
    int writing_ = -1;  // once there is a reader; so that it finds no end
};

}  // namespace offmap::test
