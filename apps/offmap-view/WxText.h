// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <wx/string.h>

namespace offmap::window {

/// Of UTF-8, whatever the locale. Bytes that are none read as Latin-1 instead of vanishing.
inline wxString toWx(std::string_view text) {
    wxString out = wxString::FromUTF8(text.data(), text.size());
    if (!out.empty() || text.empty()) return out;
    return {text.data(), wxConvISO8859_1, text.size()};
}

inline std::string fromWx(const wxString& text) { return text.ToStdString(wxConvUTF8); }

}  // namespace offmap::window
