// SPDX-License-Identifier: BSD-3-Clause
#include "UtcTime.h"

#include <fmt/format.h>

#include <cmath>
#include <ctime>

namespace offmap::app {

std::string utcText(mrpt::Clock::time_point time) {
    constexpr double year1 = -62135596800, year10000 = 253402300800;  // [s since 1970]
    // To the millisecond first, or the seconds might be rounded up to 60.
    const double milliseconds = std::round(1e3 * mrpt::Clock::toDouble(time));
    const double seconds = std::floor(milliseconds / 1e3);
    if (!(seconds >= year1 && seconds < year10000)) return "no time";
    const auto whole = static_cast<std::time_t>(seconds);
    std::tm date{};
    if (gmtime_r(&whole, &date) == nullptr) return "no time";
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03.0f}Z", date.tm_year + 1900,
                       date.tm_mon + 1, date.tm_mday, date.tm_hour, date.tm_min, date.tm_sec,
                       milliseconds - 1e3 * seconds);
}

}  // namespace offmap::app
