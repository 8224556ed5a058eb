// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/HealthTotals.h>

#include <nlohmann/json_fwd.hpp>

namespace offmap::rawlog {

/// Members of a scan in a report.
void addHealth(const core::Health& health, nlohmann::ordered_json& out);

/// Members of a report's totals.
nlohmann::ordered_json toJson(const HealthTotals& health);
/// \throw nlohmann::json::exception if it is something else
HealthTotals healthFrom(const nlohmann::ordered_json& json);

}  // namespace offmap::rawlog
