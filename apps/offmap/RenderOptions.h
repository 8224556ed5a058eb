// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/SharedOptions.h"

#include <offmap/view/Figure.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace offmap::app {

/// The command line of `offmap render`.
struct RenderOptions {
    std::filesystem::path input, output;
    SharedOptions shared;
    uint64_t entry = 0;
    std::string view = "both", colourBy = "label", theme = "dark", size;
    std::optional<double> azimuthDeg, elevationDeg;
    bool hideMapped = false, force = false;

    void addTo(CLI::App& command);

    /// The figure as it was asked for; the title is the input's name.
    /// \throw UsageError for a size that is none, or a direction that no picture has
    view::FigureOptions figure() const;
};

}  // namespace offmap::app
