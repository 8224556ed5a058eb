// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/ScanSource.h>

#include <deque>
#include <mutex>
#include <optional>

namespace offmap::live {

/// Pieces of the turn that is going on, for a reader that has nothing else to do. It may miss any
/// of them. Two threads may use it.
class WaitingPieces {
 public:
    /// No more are kept.
    static constexpr size_t most = 100;

    void add(TurnPiece piece);
    /// Forgets them: the turn has come.
    void clear();
    /// The oldest; none if none waits.
    std::optional<TurnPiece> take();

 private:
    std::mutex mutex_;
    std::deque<TurnPiece> pieces_;
};

}  // namespace offmap::live
