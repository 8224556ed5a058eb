// SPDX-License-Identifier: BSD-3-Clause
#include "NumberList.h"

#include "UsageError.h"

#include <fmt/format.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace offmap::app {

std::vector<double> parseNumbers(const std::string& text, std::string_view option,
                                 std::string_view form) {
    const size_t wanted = 1 + static_cast<size_t>(std::count(form.begin(), form.end(), ','));
    const auto fail = [&] {
        throw UsageError(fmt::format("{} is '{}', but must be {} number{}, {}", option, text,
                                     wanted, wanted == 1 ? "" : "s", form));
    };
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        double number = 0;
        if (at != end && *at == '+') ++at;
        const auto [stop, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !std::isfinite(number)) fail();
        numbers.push_back(number);
        if (stop == end) break;
        if (*stop != ',') fail();
        at = stop + 1;
    }
    if (numbers.size() != wanted) fail();
    return numbers;
}

mrpt::math::TPose2D parsePose(const std::string& text, std::string_view option) {
    const auto numbers = parseNumbers(text, option, "x,y,yaw_deg");
    return {numbers[0], numbers[1], mrpt::DEG2RAD(numbers[2])};
}

std::string notEmpty(const std::string& value) { return value.empty() ? "is empty" : ""; }

}  // namespace offmap::app
