// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/ScanSource.h>

namespace offmap::live {

/// What there is of a turn that is still going on, put together from its pieces.
class TurnInProgress {
 public:
    /// False if it does not follow those before: then it is not taken.
    bool add(const TurnPiece& piece);

    /// Whether this is how that turn begins.
    bool begins(const rawlog::Turn& turn) const;

    /// The first piece of another turn begins that one.
    void clear() { soFar_ = nullptr; }

    /// \pre a piece was added
    rawlog::Turn turn() const { return {soFar_}; }

 private:
    mrpt::obs::CObservationVelodyneScan::Ptr soFar_;
    uint64_t number_ = 0;  // of the turn
};

}  // namespace offmap::live
