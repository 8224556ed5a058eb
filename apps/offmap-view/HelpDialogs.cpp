// SPDX-License-Identifier: BSD-3-Clause
#include "HelpDialogs.h"

#include "Shortcuts.h"
#include "WindowIcon.h"
#include "WxText.h"

#include <algorithm>
#include <string_view>
#include <wx/aboutdlg.h>
#include <wx/sizer.h>
#include <wx/stattext.h>

namespace offmap::window {

namespace {

std::span<const Shortcut> groupFrom(std::span<const Shortcut> rest) {
    const auto end = std::ranges::find_if(
        rest, [&](const Shortcut& s) { return std::string_view(s.group) != rest.front().group; });
    return {rest.begin(), end};
}

void addGroup(wxWindow& parent, wxSizer& column, std::span<const Shortcut> group) {
    auto* heading = new wxStaticText(&parent, wxID_ANY, toWx(group.front().group));
    heading->SetFont(parent.GetFont().Bold());
    column.Add(heading, wxSizerFlags().Border(wxTOP | wxBOTTOM, parent.FromDIP(6)));
    auto* grid = new wxFlexGridSizer(2, parent.FromDIP(wxSize(16, 4)));
    for (const Shortcut& shortcut : group) {
        auto* key = new wxStaticText(&parent, wxID_ANY, toWx(shortcut.key));
        key->SetFont(wxFontInfo(parent.GetFont().GetPointSize()).Family(wxFONTFAMILY_TELETYPE));
        key->SetMinSize({parent.FromDIP(64), -1});
        grid->Add(key, wxSizerFlags().CentreVertical());
        grid->Add(new wxStaticText(&parent, wxID_ANY, toWx(shortcut.meaning)));
    }
    column.Add(grid, wxSizerFlags().Border(wxLEFT | wxBOTTOM, parent.FromDIP(6)));
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(wxWindow* parent)
    : wxDialog(parent, wxID_ANY, "Keyboard shortcuts") {
    auto* columns = new wxBoxSizer(wxHORIZONTAL);
    wxSizer* column = nullptr;
    size_t inColumn = 0;
    for (auto rest = shortcuts(); !rest.empty();) {
        const auto group = groupFrom(rest);
        if (column == nullptr || inColumn + group.size() > shortcuts().size() / 2) {
            column = new wxBoxSizer(wxVERTICAL);
            columns->Add(column, wxSizerFlags().Border(wxLEFT | wxRIGHT, FromDIP(14)));
            inColumn = 0;
        }
        addGroup(*this, *column, group);
        inColumn += group.size();
        rest = rest.subspan(group.size());
    }
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(columns, wxSizerFlags(1).Border(wxALL, FromDIP(8)));
    sizer->Add(CreateStdDialogButtonSizer(wxCLOSE), wxSizerFlags().Expand().Border());
    SetSizerAndFit(sizer);
    SetEscapeId(wxID_CLOSE);
    CentreOnParent();
}

void showAbout(wxWindow* parent) {
    wxAboutDialogInfo about;
    about.SetName("offmap-view");
    about.SetVersion(OFFMAP_VERSION);
    about.SetIcon(windowIcon().GetIcon(wxSize(128, 128)));
    about.SetDescription(
        toWx("Takes out of a 3D laser scan what a 2D map already knows, and shows what stays.\n\n"
             "After the paper “Dynamic real-time reduction of mapped features in a 3D point "
             "cloud”; what differs from it stands in doc/algorithm.md."));
    about.SetCopyright(toWx("© 2026 the offmap authors"));
    about.SetLicence(
        "BSD-3-Clause: use, change and share it freely, with its copyright notice and "
        "without any warranty. The full text stands in the file LICENSE.");
    wxAboutBox(about, parent);
}

}  // namespace offmap::window
