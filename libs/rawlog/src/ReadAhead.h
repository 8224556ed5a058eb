// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PieceReader.h"

#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <oneapi/tbb/task_group.h>

namespace offmap::rawlog {

/// Reads a file a few pieces ahead in whatever thread of TBB is idle. If none is, whoever asks for
/// a piece reads it, so that no thread is needed but the one that asks.
class ReadAhead {
 public:
    explicit ReadAhead(PieceReader& reader) : reader_(reader) {}
    ~ReadAhead();
    ReadAhead(const ReadAhead&) = delete;
    ReadAhead& operator=(const ReadAhead&) = delete;

    /// Replaces what is in the piece by what comes next. \throw what reading has thrown
    void take(FilePiece& piece);

 private:
    using Lock = std::unique_lock<std::mutex>;
    bool mayRead() const { return !reading_ && !ended_ && ready_.size() < most; }
    void readOne(Lock& lock);
    void readSome();

    static constexpr size_t most = 16;  // pieces, 4 MiB
    PieceReader& reader_;
    std::mutex mutex_;  // of all below
    std::condition_variable changed_;
    std::list<FilePiece> ready_, spare_;
    std::exception_ptr error_;
    bool reading_ = false;  // in some thread
    bool asked_ = false;    // a task that is to read has not begun yet
    bool ended_ = false;
    // Where this is asked from may be cancelled, or end before this does.
    tbb::task_group_context context_{tbb::task_group_context::isolated};
    tbb::task_group tasks_{context_};
};

}  // namespace offmap::rawlog
