// SPDX-License-Identifier: BSD-3-Clause
// Tests of real controls and panes: the toolkit runs, no event loop does.
#include <gtest/gtest.h>

#include <wx/app.h>
#include <wx/init.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    wxApp::SetInstance(new wxApp);
    const wxInitializer toolkit(argc, argv);
    if (!toolkit.IsOk()) return 2;  // no screen
    return RUN_ALL_TESTS();
}
