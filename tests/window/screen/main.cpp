// SPDX-License-Identifier: BSD-3-Clause
// Tests of real controls and panes: the toolkit runs, no event loop does.
#include "../../support/Places.h"

#include <gtest/gtest.h>

#include <wx/app.h>
#include <wx/image.h>
#include <wx/init.h>
#include <wx/log.h>

std::filesystem::path offmap::test::offmapBinary() { return OFFMAP_BINARY; }

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // What the toolkit finds wrong with its use; else it would ask with a dialog and wait.
    wxSetAssertHandler([](const wxString& file, int line, const wxString&,
                          const wxString& condition, const wxString& message) {
        ADD_FAILURE() << file << ':' << line << ": " << condition << ": " << message;
    });
    wxApp::SetInstance(new wxApp);
    const wxInitializer toolkit(argc, argv);
    if (!toolkit.IsOk()) return 2;                   // no screen
    delete wxLog::SetActiveTarget(new wxLogStderr);  // no dialogs, which would wait
    wxImage::AddHandler(new wxPNGHandler);
    return RUN_ALL_TESTS();
}
