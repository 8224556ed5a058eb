// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/ScanClass.h>

namespace offmap::rawlog {

/// Makes the columns of one turn while it is being taken. `out` is the same in all calls; between
/// them its last columns may lose points (see SelfMask.h), but none may come or go.
class ColumnStream {
 public:
    virtual ~ColumnStream() = default;

    /// Appends the columns that are already clear and whose poses are settled.
    /// \param soFar what there is of the turn: all that the last call had, and more
    virtual void add(const Turn& soFar, TurnScan& out) = 0;

    /// Appends those that are left: `out` is what ScanClass::organize() makes of the turn.
    virtual void finish(const Turn& turn, TurnScan& out) = 0;
};

}  // namespace offmap::rawlog
