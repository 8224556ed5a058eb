// SPDX-License-Identifier: BSD-3-Clause
#include "ReadAhead.h"

#include <utility>

namespace offmap::rawlog {

ReadAhead::~ReadAhead() {
    {
        const Lock lock(mutex_);
        ended_ = true;
    }
    try {
        tasks_.wait();
    } catch (...) {  // short of memory before it read: nobody misses it any more
    }
}

void ReadAhead::take(FilePiece& piece) {
    Lock lock(mutex_);
    if (ready_.empty() && mayRead()) readOne(lock);
    // A thread that reads does nothing else, so that this one does not wait for itself.
    changed_.wait(lock, [this] { return !reading_ || !ready_.empty(); });
    if (ready_.empty()) {
        if (error_) std::rethrow_exception(error_);
        piece.bytes.clear();
        return;
    }
    std::swap(piece, ready_.front());
    spare_.splice(spare_.end(), ready_, ready_.begin());
    if (asked_ || !mayRead()) return;
    asked_ = true;
    lock.unlock();
    tasks_.run([this] { readSome(); });
}

void ReadAhead::readSome() {
    Lock lock(mutex_);
    asked_ = false;
    while (mayRead()) readOne(lock);
}

/// Once it has read, nothing can fail any more: no piece is lost.
void ReadAhead::readOne(Lock& lock) {
    std::list<FilePiece> one;
    if (spare_.empty()) {
        one.emplace_back();
    } else {
        one.splice(one.end(), spare_, spare_.begin());
    }
    FilePiece& piece = one.front();
    reading_ = true;
    lock.unlock();
    std::exception_ptr error;
    try {
        reader_.read(piece);
    } catch (...) {
        error = std::current_exception();
    }
    lock.lock();
    reading_ = false;
    error_ = error;
    ended_ = ended_ || error || piece.bytes.empty() || !piece.failure.empty();
    if (!error) ready_.splice(ready_.end(), one);
    changed_.notify_all();
}

}  // namespace offmap::rawlog
