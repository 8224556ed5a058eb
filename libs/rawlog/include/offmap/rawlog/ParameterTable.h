// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Parameter.h>

#include <span>
#include <string_view>

namespace offmap::rawlog {

/// Everything that can be adjusted, section by section. The configuration file, --set and the
/// listing of the parameters are all made from it.
std::span<const Parameter> parameters();

/// \throw std::invalid_argument if there is no such key; it names the nearest one.
const Parameter& findParameter(std::string_view key);

/// The parameter "sensor.NAME", which can be set for a single sensor.
/// \throw std::invalid_argument if there is no such name; it names the nearest one.
const Parameter& findSensorParameter(std::string_view name);

}  // namespace offmap::rawlog
