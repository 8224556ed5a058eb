// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/EntryPlace.h>
#include <offmap/rawlog/OutputFile.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace offmap::rawlog {

struct GuardedMemory;

/// What guarded work tells the program that watches it. It survives the death of the work.
class GuardedStatus : public TemporaryFiles {
 public:
    explicit GuardedStatus(GuardedMemory& memory) : memory_(memory) {}

    /// To be called before each entry that is read.
    void atEntry(const EntryPlace& place);

    /// To be called before the first output is published: from here on a first interruption is not
    /// obeyed, so that outputs appear together or not at all.
    void beginPublishing();

    void add(const std::filesystem::path& file) override;
    void remove(const std::filesystem::path& file) override;

 private:
    GuardedMemory& memory_;
    std::mutex mutex_;
};

struct GuardedOptions {
    uint64_t memory = uint64_t{4} << 30;  ///< [byte] that the work may take in addition
};

struct GuardedOutcome {
    enum class Kind : uint8_t {
        Finished,     ///< the work returned
        Died,         ///< it threw, crashed, or a library ended the program
        Interrupted,  ///< SIGINT, SIGTERM or SIGHUP arrived
    };

    Kind kind = Kind::Died;
    int exitCode = 0;                 ///< what the work returned, if it finished
    int signal = 0;                   ///< that interrupted it, came too late to, or that it died
                                      ///< of; else 0
    std::optional<EntryPlace> place;  ///< the last one that it told
    std::string cause;                ///< why it died, in words
};

/// Runs the work in a child of this program. MRPT's deserialiser does not survive corrupt bytes
/// (crashes, endless recursion, absurd allocations, exit() in the JPEG library): whatever happens,
/// this program lives, knows where, and no temporary file stays. Not to be called while other
/// threads run. The work may write to stdout and stderr and start threads of its own.
/// \throw std::system_error if there is no memory or no process to be had.
GuardedOutcome runGuarded(const std::function<int(GuardedStatus&)>& work,
                          const GuardedOptions& options = {});

}  // namespace offmap::rawlog
