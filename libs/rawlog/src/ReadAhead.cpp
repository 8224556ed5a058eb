// SPDX-License-Identifier: BSD-3-Clause
#include "ReadAhead.h"

#include <algorithm>
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
    while (!settleNext()) mayRead() ? readOne(lock) : changed_.wait(lock);
    if (pieces_.empty()) {
        if (error_) std::rethrow_exception(error_);
        piece.bytes.clear();
        return;
    }
    std::swap(piece, pieces_.front().piece);
    spare_.splice(spare_.end(), pieces_, pieces_.begin());
    if (asked_ || !mayRead()) return;
    asked_ = true;
    lock.unlock();
    tasks_.run([this] { readSome(); });
}

/// What stands behind a piece that is no member is cut wrongly.
bool ReadAhead::mayRead() const {
    return !reading_ && !ended_ && pieces_.size() < most && !any(State::NoMember);
}

bool ReadAhead::any(State state) const {
    return std::ranges::any_of(pieces_, [=](const Ahead& ahead) { return ahead.state == state; });
}

/// Whether the next piece is ready, or there is none. Once nobody is busy with what stands behind a
/// piece that is no member, that is read again, uncut.
bool ReadAhead::settleNext() {
    // An empty member is not the end of the file.
    while (!pieces_.empty() && pieces_.front().state == State::Ready &&
           pieces_.front().piece.bytes.empty() && !pieces_.front().piece.packed.empty()) {
        pieces_.pop_front();
    }
    if (pieces_.empty()) return ended_ && !reading_;
    const auto& [next, state] = pieces_.front();
    if (state != State::NoMember) return state == State::Ready;
    if (reading_ || any(State::Unpacking)) return false;
    reader_.goOnUncut(next.compressedPosition - next.packed.size());
    pieces_.clear();
    ended_ = false;
    return false;
}

void ReadAhead::readSome() {
    Lock lock(mutex_);
    asked_ = false;
    while (mayRead()) readOne(lock);
}

/// Once it has read, nothing can fail any more: no piece is lost.
void ReadAhead::readOne(Lock& lock) {
    std::list<Ahead> one;
    if (spare_.empty()) {
        one.emplace_back();
    } else {
        one.splice(one.end(), spare_, spare_.begin());
    }
    FilePiece& piece = one.front().piece;
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
    const bool isLast = piece.packed.empty() && (piece.bytes.empty() || !piece.failure.empty());
    ended_ = ended_ || error || isLast;
    if (!error) {
        Ahead& ahead = one.front();
        pieces_.splice(pieces_.end(), one);
        changed_.notify_all();  // another may read
        if (!ahead.piece.packed.empty()) unpack(lock, ahead);
    }
    changed_.notify_all();
}

/// What cannot be unpacked, for want of memory too, is tried again uncut.
void ReadAhead::unpack(Lock& lock, Ahead& ahead) {
    ahead.state = State::Unpacking;
    lock.unlock();
    bool isMember = false;
    try {
        isMember = reader_.unpack(ahead.piece);
    } catch (...) {
    }
    lock.lock();
    ahead.state = isMember ? State::Ready : State::NoMember;
}

}  // namespace offmap::rawlog
