// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <grp.h>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace offmap::test {

struct RunOptions {
    std::filesystem::path folder = {};                ///< to run in; empty: where this program is
    std::optional<uid_t> user = {};                   ///< to run as
    std::vector<std::pair<int, rlim_t>> limits = {};  ///< RLIMIT_..., its value
    bool ownGroup = false;                            ///< leads a process group of its own
    bool nobodyListens = false;                       ///< its stdout and stderr are broken pipes
    unsigned timeOut = 240;                           ///< [s] then SIGALRM ends it
};

/// Somebody without rights: root may do anything in spite of permissions.
inline std::optional<uid_t> unprivileged() {
    return geteuid() == 0 ? std::optional<uid_t>(65534) : std::nullopt;
}

struct RunResult {
    int exitCode = -1;       ///< as a shell tells it: 128 + signal for a signal
    std::string out, err;    ///< what it wrote to stdout and stderr
    int64_t peakMemory = 0;  ///< [KiB] largest resident set of it and of its children
};

inline void PrintTo(const RunResult& run, std::ostream* os) {
    *os << "exit code " << run.exitCode << "\nstdout: " << run.out << "\nstderr: " << run.err;
}

/// Another program, from its start to its end.
class RunningProgram {
 public:
    /// \param command a path and arguments
    explicit RunningProgram(std::vector<std::string> command, const RunOptions& options = {}) {
        // Opened with our rights: the user to run as may not reach the folder it stands in.
        const int program = open(command.front().c_str(), O_PATH | O_CLOEXEC);
        if (program < 0) throw std::runtime_error("no program " + command.front());
        if (options.nobodyListens) out_.closeReading(), err_.closeReading();
        child_ = fork();
        if (child_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
        if (child_ == 0) become(program, command, options);
        close(program);
        out_.closeWriting();
        err_.closeWriting();
    }
    ~RunningProgram() {
        if (child_ > 0) kill(child_, SIGKILL), waitpid(child_, nullptr, 0);
    }
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    pid_t id() const { return child_; }

    /// Whether it has not ended yet.
    bool runs() const {
        siginfo_t info{};
        waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
        return info.si_pid == 0;
    }

    RunResult wait() {
        int status = 0;
        rusage usage{};
        if (wait4(child_, &status, 0, &usage) != child_) {
            throw std::system_error(errno, std::generic_category(), "wait4");
        }
        child_ = 0;
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return {code, out_.content(), err_.content(), usage.ru_maxrss};
    }

 private:
    /// A pipe, because a limit of the file size does not hold for it. Large enough for all that is
    /// written, so that it may be read at the end.
    class Output {
     public:
        Output() {
            if (pipe2(ends_, O_CLOEXEC) != 0 || fcntl(ends_[1], F_SETPIPE_SZ, 1 << 20) < 0) {
                throw std::system_error(errno, std::generic_category(), "pipe");
            }
        }
        ~Output() { closeReading(), closeWriting(); }
        Output(const Output&) = delete;
        Output& operator=(const Output&) = delete;

        int writing() const { return ends_[1]; }
        void closeReading() { close(std::exchange(ends_[0], -1)); }
        void closeWriting() { close(std::exchange(ends_[1], -1)); }

        std::string content() const {
            std::string text;
            char piece[4096];
            ssize_t size = 0;
            while ((size = read(ends_[0], piece, sizeof piece)) > 0) {
                text.append(piece, static_cast<size_t>(size));
            }
            return text;
        }

     private:
        int ends_[2];
    };

    [[noreturn]] void become(int program, const std::vector<std::string>& command,
                             const RunOptions& options) const {
        const auto check = [](int status) {
            if (status >= 0) return;
            dprintf(STDERR_FILENO, "cannot start the program: %s\n", strerror(errno));
            _exit(127);
        };
        check(dup2(out_.writing(), STDOUT_FILENO));
        check(dup2(err_.writing(), STDERR_FILENO));
        check(dup2(open("/dev/null", O_RDONLY), STDIN_FILENO));
        if (!options.folder.empty()) check(chdir(options.folder.c_str()));
        if (options.ownGroup) check(setpgid(0, 0));
        for (const auto& [limit, value] : options.limits) {
            const rlimit both{value, value};
            check(setrlimit(static_cast<__rlimit_resource>(limit), &both));
        }
        if (options.user) {
            check(setgroups(0, nullptr));
            check(setgid(*options.user));
            check(setuid(*options.user));
        }
        alarm(options.timeOut);
        std::vector<char*> arguments;
        for (const std::string& word : command)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        check(fexecve(program, arguments.data(), environ));
        _exit(127);
    }

    Output out_, err_;
    pid_t child_ = 0;
};

inline RunResult runProgram(std::vector<std::string> command, const RunOptions& options = {}) {
    return RunningProgram(std::move(command), options).wait();
}

}  // namespace offmap::test
