// SPDX-License-Identifier: BSD-3-Clause
#include "ViewApp.h"

#include <exception>
#include <utility>
#include <wx/image.h>
#include <wx/log.h>

namespace offmap::window {

ViewApp::ViewApp(FileReader reader, SessionRequest request)
    : reader_(std::move(reader)), request_(std::move(request)) {
    SetAppName("offmap-view");
    SetClassName("offmap-view");
}

bool ViewApp::OnInit() {
    wxImage::AddHandler(new wxPNGHandler);
    const wxLogNull damagedSettings;  // read as none; a dialog about them would help nobody
    settings_ = std::make_unique<wxConfig>("offmap-view");
    auto* frame = new MainFrame(reader_, request_, *settings_);
    frame->Show();
    return true;
}

int ViewApp::OnExit() {
    settings_.reset();
    return wxApp::OnExit();
}

bool ViewApp::OnExceptionInMainLoop() {
    try {
        throw;
    } catch (const std::exception& error) {
        wxLogError("%s", error.what());
    }
    return true;
}

}  // namespace offmap::window
