// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace offmap::window {

namespace {

void require(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Both ends of a pipe, which close themselves.
class Pipe {
 public:
    Pipe() {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0) require(errno, "cannot make a pipe");
    }
    ~Pipe() {
        closeWriting();
        close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reading() const { return ends_[0]; }
    int writing() const { return ends_[1]; }
    void closeWriting() {
        if (ends_[1] >= 0) close(ends_[1]);
        ends_[1] = -1;
    }

 private:
    std::array<int, 2> ends_{};
};

pid_t start(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            const Pipe& output) {
    std::vector<char*> words{const_cast<char*>("offmap-view")};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    require(posix_spawn_file_actions_init(&actions), "cannot prepare a process");
    posix_spawn_file_actions_adddup2(&actions, output.writing(), STDOUT_FILENO);
    pid_t child = 0;
    const int error =
        posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    require(error, "cannot start the reading process");
    return child;
}

/// Until the child closes it, or it is killed because it is no longer wanted.
std::vector<uint8_t> readAll(int from, pid_t child, const std::stop_token& stop) {
    constexpr int patience = 50;  // [ms] between looks at the token
    std::vector<uint8_t> all, part(1 << 16);
    for (;;) {
        if (stop.stop_requested()) kill(child, SIGKILL);
        pollfd waited{from, POLLIN, 0};
        if (poll(&waited, 1, patience) <= 0) continue;
        const ssize_t size = read(from, part.data(), part.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return all;
        all.insert(all.end(), part.begin(), part.begin() + size);
    }
}

}  // namespace

ChildOutcome runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const std::stop_token& stop) {
    Pipe output;
    const pid_t child = start(program, arguments, output);
    output.closeWriting();
    ChildOutcome outcome;
    outcome.output = readAll(output.reading(), child, stop);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return outcome;
}

}  // namespace offmap::window
