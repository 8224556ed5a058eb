// SPDX-License-Identifier: BSD-3-Clause
#include "WindowIcon.h"

#include "IconSvg.h"

#include <wx/bmpbndl.h>

namespace offmap::window {

wxIconBundle windowIcon() {
    wxIconBundle icons;
    for (const int size : {16, 32, 48, 64, 128}) {  // [px]
        const wxSize square(size, size);
        icons.AddIcon(wxBitmapBundle::FromSVG(iconSvg, square).GetIcon(square));
    }
    return icons;
}

}  // namespace offmap::window
