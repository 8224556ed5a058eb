// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/WaitingPieces.h>

#include <utility>

namespace offmap::live {

void WaitingPieces::add(TurnPiece piece) {
    const std::lock_guard lock(mutex_);
    if (pieces_.size() < most) pieces_.push_back(std::move(piece));
}

void WaitingPieces::clear() {
    const std::lock_guard lock(mutex_);
    pieces_.clear();
}

std::optional<TurnPiece> WaitingPieces::take() {
    const std::lock_guard lock(mutex_);
    if (pieces_.empty()) return std::nullopt;
    std::optional<TurnPiece> piece = std::move(pieces_.front());
    pieces_.pop_front();
    return piece;
}

}  // namespace offmap::live
