// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MainFrame.h"

#include <memory>
#include <wx/app.h>

namespace offmap::window {

/// The program with a screen.
class ViewApp : public wxApp {
 public:
    ViewApp(FileReader reader, SessionRequest request);

    bool OnInit() override;
    int OnExit() override;
    /// What a handler throws is told, and the window lives on.
    bool OnExceptionInMainLoop() override;

 private:
    FileReader reader_;
    SessionRequest request_;
    std::unique_ptr<wxConfigBase> settings_;
};

}  // namespace offmap::window
