// SPDX-License-Identifier: BSD-3-Clause
#include "ScoreText.h"

#include <nlohmann/json.hpp>

#include <array>
#include <optional>

namespace offmap::app {

using evaluation::RemovalCount;
using nlohmann::ordered_json;

namespace {

ordered_json orNull(const std::optional<double>& number) {
    return number ? ordered_json(*number) : ordered_json();
}

ordered_json removedJson(const RemovalCount& count) {
    return {{"points", count.points},
            {"removed", count.removed},
            {"removed_share", orNull(count.removedShare())}};
}

ordered_json keptJson(const RemovalCount& count) {
    return {{"points", count.points},
            {"kept", count.points - count.removed},
            {"kept_share", orNull(count.keptShare())}};
}

ordered_json byKind(const evaluation::Score& score) {
    constexpr std::array names{"wall", "floor", "ceiling", "object"};
    ordered_json out;
    for (size_t k = 0; k < names.size(); ++k) out[names[k]] = keptJson(score.unmappedByKind[k]);
    return out;
}

ordered_json byStandOff(const evaluation::Score& score) {
    ordered_json out = ordered_json::array();
    for (const auto& [centimetres, count] : score.unmappedByStandOff) {
        ordered_json one;
        one["stand_off_m"] = centimetres / 100.0;
        one.update(keptJson(count));
        out.push_back(one);
    }
    return out;
}

template <class ShareAt>
ordered_json percentilesJson(const ShareAt& shareAt) {
    return {{"p05", orNull(shareAt(0.05))},
            {"p50", orNull(shareAt(0.5))},
            {"p95", orNull(shareAt(0.95))}};
}

}  // namespace

std::string scoreJson(const LogScore& score, const ScoredFiles& files) {
    const evaluation::PooledScore& pooled = score.score;
    const evaluation::Score& total = pooled.total();
    ordered_json out;
    out["offmap"] = OFFMAP_VERSION;
    out["truth"] = files.truth.string();
    out["log"] = files.log.string();
    out["scans"] = pooled.scans();
    out["observations"] = score.observations;
    out["observations_missing"] = score.missing.observations;
    out["observations_unknown"] = score.unknown.observations;
    out["points"] = total.mapped.points + total.unmapped.points;
    out["mapped_on_vertical_segments"] = removedJson(total.mappedOnSegments);
    out["mapped"] = removedJson(total.mapped);
    out["unmapped"] = keptJson(total.unmapped);
    out["geometric_mean"] = orNull(total.geometricMean());
    out["unmapped_by_kind"] = byKind(total);
    out["unmapped_by_stand_off"] = byStandOff(total);
    out["scan_percentiles"] = {
        {"mapped_removed_share",
         percentilesJson([&](double share) { return pooled.mappedRemoved(share); })},
        {"unmapped_removed_share",
         percentilesJson([&](double share) { return pooled.unmappedRemoved(share); })}};
    return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace offmap::app
