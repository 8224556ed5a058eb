// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <wx/iconbndl.h>

namespace offmap::window {

/// The icon in the sizes that desktops ask for. Only with a screen.
wxIconBundle windowIcon();

}  // namespace offmap::window
