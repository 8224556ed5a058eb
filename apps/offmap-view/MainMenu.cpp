// SPDX-License-Identifier: BSD-3-Clause
#include "MainMenu.h"

#include <string_view>
#include <wx/control.h>

namespace offmap::window {

namespace {

constexpr int mostRecent = 10;
constexpr int firstAction = wxID_HIGHEST + 1;
constexpr int firstLog = firstAction + 100, firstMap = firstLog + mostRecent;

/// A key without Ctrl or F would be taken from whatever is being typed into: such keys stand in
/// the text only, and the frame looks after them.
wxString labelOf(const Shortcut& shortcut) {
    const std::string_view key = shortcut.key;
    const bool accelerator = key.starts_with("Ctrl+") || key == "F1" || key == "F11";
    return accelerator ? wxString::Format("%s\t%s", shortcut.meaning, shortcut.key)
                       : wxString::Format("%s  (%s)", shortcut.meaning, shortcut.key);
}

std::optional<std::string> at(const std::vector<std::string>& files, int index) {
    if (index < 0 || index >= static_cast<int>(files.size())) return std::nullopt;
    return files[static_cast<size_t>(index)];
}

}  // namespace

MainMenu::MainMenu() : logMenu_(new wxMenu), mapMenu_(new wxMenu) {
    for (const Shortcut& shortcut : shortcuts()) {
        wxMenu* group = groupOf(shortcut.group);
        if (shortcut.action == Action::SaveScreenshot) {
            group->AppendSubMenu(logMenu_, "Recent logs");
            group->AppendSubMenu(mapMenu_, "Recent maps");
            group->AppendSeparator();
        }
        if (shortcut.action == Action::Quit) group->AppendSeparator();
        group->Append(idOf(shortcut.action), labelOf(shortcut));
    }
    groupOf("Help")->Append(wxID_ABOUT, "About offmap-view");
}

wxMenu* MainMenu::groupOf(const std::string& name) {
    const int index = FindMenu(name);
    if (index != wxNOT_FOUND) return GetMenu(static_cast<size_t>(index));
    auto* menu = new wxMenu;
    Append(menu, "&" + name);
    return menu;
}

int MainMenu::idOf(Action action) { return firstAction + static_cast<int>(action); }

std::optional<Action> MainMenu::actionOf(int id) {
    const int index = id - firstAction;
    if (index < 0 || index >= static_cast<int>(shortcuts().size())) return std::nullopt;
    return static_cast<Action>(index);
}

void MainMenu::fill(wxMenu& menu, int firstId, const std::vector<std::string>& files) {
    while (menu.GetMenuItemCount() > 0) menu.Destroy(menu.FindItemByPosition(0));
    for (size_t i = 0; i < files.size(); ++i) {
        menu.Append(firstId + static_cast<int>(i),
                    wxControl::EscapeMnemonics(wxString::FromUTF8(files[i])));
    }
    if (files.empty()) menu.Append(wxID_NONE, "none yet")->Enable(false);
}

void MainMenu::setRecent(const std::vector<std::string>& logs,
                         const std::vector<std::string>& maps) {
    logs_ = logs;
    maps_ = maps;
    fill(*logMenu_, firstLog, logs_);
    fill(*mapMenu_, firstMap, maps_);
}

std::optional<std::string> MainMenu::recentLog(int id) const { return at(logs_, id - firstLog); }

std::optional<std::string> MainMenu::recentMap(int id) const {
    return id >= firstMap ? at(maps_, id - firstMap) : std::nullopt;
}

}  // namespace offmap::window
