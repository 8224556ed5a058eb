// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PieceReader.h"

#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <oneapi/tbb/task_group.h>

namespace offmap::rawlog {

/// Reads a file a few pieces ahead in whatever thread of TBB is idle: one reads, several unpack the
/// members of a gzip file. Whoever asks for a piece that is not ready takes part in that meanwhile,
/// so that no thread is needed but the one that asks.
class ReadAhead {
 public:
    explicit ReadAhead(PieceReader& reader) : reader_(reader) { reader_.cutMembers(); }
    ~ReadAhead();
    ReadAhead(const ReadAhead&) = delete;
    ReadAhead& operator=(const ReadAhead&) = delete;

    /// Replaces what is in the piece by what comes next. \throw what reading has thrown
    void take(FilePiece& piece);

 private:
    using Lock = std::unique_lock<std::mutex>;
    enum class State { Unpacking, Ready, NoMember };
    struct Ahead {
        FilePiece piece;
        State state = State::Ready;
    };

    bool mayRead() const;
    bool any(State state) const;
    bool settleNext();
    void readOne(Lock& lock);
    void unpack(Lock& lock, Ahead& ahead);
    void readSome();

    static constexpr size_t most = 4;  // pieces, each mostly a MiB or less
    PieceReader& reader_;
    std::mutex mutex_;  // of all below
    std::condition_variable changed_;
    std::list<Ahead> pieces_, spare_;  // in the order of the file
    std::exception_ptr error_;
    bool reading_ = false;  // in some thread
    bool asked_ = false;    // a task that is to read has not begun yet
    bool ended_ = false;
    // Where this is asked from may be cancelled, or end before this does.
    tbb::task_group_context context_{tbb::task_group_context::isolated};
    tbb::task_group tasks_{context_};
};

}  // namespace offmap::rawlog
