// SPDX-License-Identifier: BSD-3-Clause
#include "HealthJson.h"

#include <mrpt/core/bits_math.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace offmap::rawlog {

using nlohmann::ordered_json;

namespace {

template <class T>
ordered_json orNull(const std::optional<T>& value) {
    return value ? ordered_json(*value) : ordered_json();
}

/// What is beyond makes a file hard to read.
std::optional<double> rounded(const std::optional<double>& value) {
    return value ? std::optional(std::round(1e6 * *value) / 1e6) : std::nullopt;
}

std::optional<double> degrees(const std::optional<double>& radians) {
    return radians ? std::optional(mrpt::RAD2DEG(*radians)) : std::nullopt;
}

}  // namespace

void addHealth(const core::Health& health, ordered_json& out) {
    out["matched_share"] = orNull(rounded(health.matchedShare));
    out["residual_bias_m"] = orNull(rounded(health.residualBias));
    out["pose_fit"] = nullptr;
    if (const auto& fit = health.fit) {
        out["pose_fit"] = {{"shift_m", *rounded(std::optional(fit->shift))},
                           {"turn_deg", *rounded(degrees(fit->turn))},
                           {"fitted_share", *rounded(std::optional(fit->fittedShare))},
                           {"prior_chi_square", *rounded(std::optional(fit->priorChiSquare))},
                           {"prior_inflation", fit->priorInflation}};
    }
    out["suspect"] = health.suspect ? ordered_json(core::toString(*health.suspect)) : nullptr;
}

ordered_json toJson(const HealthTotals& health) {
    ordered_json suspects = ordered_json::object();
    for (size_t r = 0; r < health.suspects.size(); ++r) {
        const auto reason = static_cast<core::Suspicion>(r);
        if (health.suspects[r] > 0)
            suspects[std::string(core::toString(reason))] = health.suspects[r];
    }
    ordered_json out;
    out["scans_suspect"] = suspects;
    out["first_suspects"] = health.firstSuspects;
    out["scans_with_corrected_pose"] = health.corrected;
    out["pose_shift_rms_m"] = orNull(rounded(health.shiftRms()));
    out["pose_turn_rms_deg"] = orNull(rounded(degrees(health.turnRms())));
    return out;
}

HealthTotals healthFrom(const ordered_json& json) {
    HealthTotals health;
    for (size_t r = 0; r < health.suspects.size(); ++r) {
        const std::string reason(core::toString(static_cast<core::Suspicion>(r)));
        health.suspects[r] = json.at("scans_suspect").value(reason, uint64_t{0});
    }
    health.firstSuspects = json.at("first_suspects").get<std::vector<uint64_t>>();
    health.corrected = json.at("scans_with_corrected_pose");
    if (health.corrected == 0) return health;
    const auto count = static_cast<double>(health.corrected);
    const double shift = json.at("pose_shift_rms_m");
    const double turn = mrpt::DEG2RAD(json.at("pose_turn_rms_deg").get<double>());
    health.squaredShift = count * shift * shift;
    health.squaredTurn = count * turn * turn;
    return health;
}

}  // namespace offmap::rawlog
