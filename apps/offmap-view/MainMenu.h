// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Preferences.h"
#include "Shortcuts.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>
#include <wx/menu.h>

namespace offmap::window {

/// All actions group by group, and the files that were open before.
class MainMenu : public wxMenuBar {
 public:
    MainMenu();

    /// What a line of the menu stands for.
    static std::optional<Action> actionOf(int id);
    static int idOf(Action action);

    void setRecent(const std::vector<std::string>& logs, const std::vector<std::string>& maps);
    std::optional<std::string> recentLog(int id) const;
    std::optional<std::string> recentMap(int id) const;

 private:
    wxMenu* groupOf(const std::string& name);
    void fill(wxMenu& menu, int firstId, const std::vector<std::string>& files);

    wxMenu *logMenu_, *mapMenu_;
    std::vector<std::string> logs_, maps_;
};

}  // namespace offmap::window
