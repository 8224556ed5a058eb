// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/VelodynePackets.h>

#include <cstddef>
#include <cstdint>

namespace offmap::rawlog {

/// Returns that are added to others. Room for them is made beforehand: to ask at each whether there
/// is any costs as much as to work it out.
class AppendedReturns {
 public:
    explicit AppendedReturns(VelodyneReturns& returns)
        : returns_(returns), count_(returns.points.size()) {}

    /// Where the next return goes. By value, the processor holds it in registers.
    struct Appender {
        mrpt::math::TPoint3Df* point;
        uint32_t* slot;
        uint8_t* laser;

        void add(const mrpt::math::TPoint3Df& p, size_t ofSlot, size_t ofLaser) {
            *point++ = p;
            *slot++ = static_cast<uint32_t>(ofSlot);
            *laser++ = static_cast<uint8_t>(ofLaser);
        }
    };

    /// \param most that will be added
    void makeRoom(size_t most) { resize(count_ + most); }
    void giveBackRoom() { resize(count_); }

    Appender appender() {
        return {returns_.points.data() + count_, returns_.slots.data() + count_,
                returns_.lasers.data() + count_};
    }
    void takeUpTo(const Appender& end) {
        count_ = static_cast<size_t>(end.point - returns_.points.data());
    }

    size_t count() const { return count_; }

 private:
    void resize(size_t count) {
        returns_.points.resize(count);
        returns_.slots.resize(count);
        returns_.lasers.resize(count);
    }

    VelodyneReturns& returns_;
    size_t count_;  // without the room
};

}  // namespace offmap::rawlog
