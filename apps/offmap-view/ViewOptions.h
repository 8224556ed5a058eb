// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/LiveInput.h"

#include <filesystem>
#include <string>
#include <vector>

namespace offmap::window {

/// The command line of offmap-view.
struct ViewOptions {
    std::string log;   ///< a rawlog or a capture; empty: none
    std::string live;  ///< "udp", "udp:PORT" or an INI file of sensors; empty: none
    app::SourceOptions from;
    app::SharedOptions shared;
    bool play = false;

    void addTo(CLI::App& app);

    /// What is to be opened; the source is empty if nothing is.
    /// \throw app::UsageError if log and live source are both given
    app::LiveRequest request() const;
};

}  // namespace offmap::window
