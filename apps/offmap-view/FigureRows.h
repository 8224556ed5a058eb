// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/live/LiveFigures.h>
#include <offmap/live/LiveFrame.h>

#include <optional>
#include <string>
#include <vector>

namespace offmap::window {

/// A figure in words.
struct FigureRow {
    enum class Mood : uint8_t { Plain, Good, Bad };

    std::string label, value;
    Mood mood = Mood::Plain;
    std::optional<core::KeepReason> reason{};  ///< that it counts returns of
};

/// How a reduction is going and what became of its latest turn; always the same labels in the same
/// order. \param frame null: no turn yet
std::vector<FigureRow> figuresOf(const live::LiveFigures& figures, const live::LiveFrame* frame);

/// Why a turn is in doubt, in a few words.
std::string inWords(core::Suspicion suspicion);

}  // namespace offmap::window
