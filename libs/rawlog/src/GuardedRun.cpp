// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedMemory.h"

#include <offmap/rawlog/GuardedRun.h>

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

// Present in builds that measure coverage, where _exit() would lose the child's counts.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): GCC's own
extern "C" void __gcov_dump() __attribute__((weak));

namespace offmap::rawlog {
namespace {

constexpr int interruptions[] = {SIGINT, SIGTERM, SIGHUP};

[[noreturn]] void throwErrno(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

using SharedMemory = std::unique_ptr<GuardedMemory, void (*)(GuardedMemory*)>;

SharedMemory sharedMemory() {
    void* memory = mmap(nullptr, sizeof(GuardedMemory), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throwErrno("cannot get shared memory");
    return {new (memory) GuardedMemory{}, [](GuardedMemory* m) { munmap(m, sizeof(*m)); }};
}

/// Holds back the interruptions and the news of the child's end, until they are asked for.
/// What this program ignores (nohup) stays ignored.
class SignalWatch {
 public:
    SignalWatch() {
        sigemptyset(&watched_);
        for (int number : interruptions) {
            struct sigaction action {};
            sigaction(number, nullptr, &action);
            if (action.sa_handler != SIG_IGN) sigaddset(&watched_, number);
        }
        sigaddset(&watched_, SIGCHLD);
        struct sigaction byDefault {};
        byDefault.sa_handler = SIG_DFL;
        sigaction(SIGCHLD, &byDefault, &oldChild_);  // if ignored, the child's end would be lost
        sigprocmask(SIG_BLOCK, &watched_, &oldMask_);
    }
    ~SignalWatch() {
        sigaction(SIGCHLD, &oldChild_, nullptr);
        sigprocmask(SIG_SETMASK, &oldMask_, nullptr);
    }
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    int wait() const { return sigwaitinfo(&watched_, nullptr); }

    /// In the child: a Ctrl-C reaches it too, but its end is the watcher's decision.
    void leaveToWatcher() const {
        for (int number : interruptions) std::signal(number, SIG_IGN);
        sigaction(SIGCHLD, &oldChild_, nullptr);
        sigprocmask(SIG_SETMASK, &oldMask_, nullptr);
    }

 private:
    sigset_t watched_{}, oldMask_{};
    struct sigaction oldChild_ {};
};

void limitResources(uint64_t memory) {
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
#if !defined(__SANITIZE_ADDRESS__)  // it reserves terabytes of address space
    uint64_t pages = 0;
    if (!(std::ifstream("/proc/self/statm") >> pages)) return;
    rlimit space{};
    getrlimit(RLIMIT_AS, &space);
    const uint64_t wanted = pages * static_cast<uint64_t>(sysconf(_SC_PAGESIZE)) + memory;
    space.rlim_cur = std::min<rlim_t>(space.rlim_cur, wanted);
    setrlimit(RLIMIT_AS, &space);
#else
    static_cast<void>(memory);
#endif
}

void flushStandardStreams() {
    std::cout.flush();
    std::clog.flush();
    std::fflush(nullptr);
}

[[noreturn]] void runChild(const std::function<int(GuardedStatus&)>& work, GuardedMemory& memory) {
    const auto threw = [&](const char* what) {
        std::strncpy(memory.message.data(), what, memory.message.size() - 1);
        memory.threw = true;
    };
    int exitCode = 1;
    bool finished = false;
    try {
        GuardedStatus status(memory);
        exitCode = work(status);
        finished = true;
    } catch (const std::exception& e) {
        threw(e.what());
    } catch (...) {
        threw("unknown exception");
    }
    flushStandardStreams();
    if (__gcov_dump) __gcov_dump();
    memory.finished = finished;
    _exit(exitCode);
}

int waitForChild(pid_t child, const SignalWatch& watch, GuardedMemory& memory, int& interruption) {
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child) return status;
        if (ended < 0 && errno != EINTR) throwErrno("cannot wait for the guarded work");
        const int number = watch.wait();
        if (number < 0 || number == SIGCHLD) continue;
        int expected = GuardedMemory::Working;
        memory.phase.compare_exchange_strong(expected, GuardedMemory::Stopped);
        const bool finishPublishing = expected == GuardedMemory::Publishing && interruption == 0;
        interruption = number;
        if (!finishPublishing) kill(child, SIGKILL);
    }
}

std::string causeOfDeath(int status, const GuardedMemory& memory) {
    if (memory.threw) return memory.message.data();
    if (WIFEXITED(status)) {
        return fmt::format("a library ended the program with exit code {}", WEXITSTATUS(status));
    }
    return fmt::format("crashed: {}{}", strsignal(WTERMSIG(status)),
                       WTERMSIG(status) == SIGKILL ? ", the system may be short of memory" : "");
}

GuardedOutcome outcomeOf(int status, int interruption, const GuardedMemory& memory) {
    GuardedOutcome outcome;
    if (memory.hasPlace) outcome.place = EntryPlace{memory.index, memory.offset};
    if (memory.finished && WIFEXITED(status)) {
        outcome.kind = GuardedOutcome::Kind::Finished;
        outcome.exitCode = WEXITSTATUS(status);
        outcome.signal = interruption;
    } else if (interruption != 0) {
        outcome.kind = GuardedOutcome::Kind::Interrupted;
        outcome.signal = interruption;
    } else {
        outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        outcome.cause = causeOfDeath(status, memory);
    }
    return outcome;
}

}  // namespace

GuardedOutcome runGuarded(const std::function<int(GuardedStatus&)>& work,
                          const GuardedOptions& options) {
    const SharedMemory memory = sharedMemory();
    flushStandardStreams();  // what is buffered would be written twice
    const SignalWatch watch;
    const pid_t self = getpid();
    const pid_t child = fork();
    if (child < 0) throwErrno("cannot start the guarded work");
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != self) _exit(1);  // the parent died before that took effect
        watch.leaveToWatcher();
        limitResources(options.memory);
        runChild(work, *memory);
    }
    int interruption = 0;
    const int status = waitForChild(child, watch, *memory, interruption);
    for (const GuardedMemory::Temporary& temporary : memory->temporaries) {
        if (temporary.used) unlink(temporary.path.data());
    }
    return outcomeOf(status, interruption, *memory);
}

}  // namespace offmap::rawlog
