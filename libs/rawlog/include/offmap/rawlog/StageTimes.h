// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string_view>

namespace offmap::rawlog {

/// What each stage of a reduction costs: the time that processors were at work for it, in whatever
/// thread. Not the time that passed. Any thread may use it.
class StageTimes {
 public:
    /// The log is surveyed before it is reduced; both unpack it.
    enum Stage : uint8_t {
        Survey,
        Unpack,
        Read,
        Reduce,
        Order,
        Serialise,
        Cut,
        Pack,
        Write,
        Count
    };
    static constexpr std::array<std::string_view, Count> names{
        "survey", "unpack", "read", "reduce", "order", "serialise", "cut", "pack", "write"};

    /// Adds what its thread works from its beginning to its end, without what others measure in
    /// the same thread meanwhile.
    class Measure {
     public:
        Measure(StageTimes& times, Stage stage);
        ~Measure();
        Measure(const Measure&) = delete;
        Measure& operator=(const Measure&) = delete;

     private:
        void pause();

        std::atomic<int64_t>& total_;  ///< [ns]
        Measure* outer_;               ///< that waits for this one; may be null
        int64_t begin_ = 0;            ///< [ns] of the thread's work; since the last pause
    };

    double seconds(Stage stage) const { return 1e-9 * static_cast<double>(nanoseconds_[stage]); }

 private:
    std::array<std::atomic<int64_t>, Count> nanoseconds_{};
};

}  // namespace offmap::rawlog
