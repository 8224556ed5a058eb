// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPose2D.h>

#include <string>
#include <string_view>
#include <vector>

namespace offmap::app {

/// Finite numbers separated by commas, as many as the form has: "x,y,yaw_deg".
/// \throw UsageError naming the option, its text and the form
std::vector<double> parseNumbers(const std::string& text, std::string_view option,
                                 std::string_view form);

/// "x,y,yaw_deg" in metres and degrees. \throw UsageError
mrpt::math::TPose2D parsePose(const std::string& text, std::string_view option);

/// A check of CLI11: an option whose value was meant to come from a variable that is not set, must
/// not count as not given.
std::string notEmpty(const std::string& value);

}  // namespace offmap::app
