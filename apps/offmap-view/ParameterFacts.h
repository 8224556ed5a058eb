// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Parameter.h>

#include <string>
#include <string_view>

namespace offmap::window {

/// "vertical" of vertical.max_tilt_deg.
std::string_view sectionOf(const rawlog::Parameter& parameter);
/// "max tilt" of vertical.max_tilt_deg: its unit stands beside.
std::string nameOf(const rawlog::Parameter& parameter);
/// A section as a heading: "Vertical segments".
std::string headingOf(std::string_view section);

/// Key, name, heading or meaning hold each word of the text, in either case.
bool isFoundBy(const rawlog::Parameter& parameter, std::string_view text);

bool isDefault(const rawlog::Parameter& parameter, const rawlog::Config& config);

/// Whether a scan that is reduced again shows the change. Others count when a log, a map or a
/// source is opened.
bool actsAtOnce(const rawlog::Parameter& parameter);

/// Meaning, what is allowed, the default, the key, and when it acts: one line each.
std::string hintOf(const rawlog::Parameter& parameter);

/// How far one step goes: a power of ten, about a tenth of what the default is or less. Only of
/// numbers and counts.
double stepOf(const rawlog::Parameter& parameter);

/// So many steps up from a value, on whole steps and within the limits; of what is no number, the
/// default.
std::string stepped(const rawlog::Parameter& parameter, const std::string& text, int steps);

}  // namespace offmap::window
