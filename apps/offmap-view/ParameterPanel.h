// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Config.h>
#include <offmap/rawlog/Parameter.h>

#include <functional>
#include <string>
#include <vector>
#include <wx/panel.h>

class wxScrolledWindow;
class wxSearchCtrl;

namespace offmap::window {

class ParameterSection;

/// All parameters with their units and limits, section by section. What is not allowed is refused
/// at once: config() is always valid.
class ParameterPanel : public wxPanel {
 public:
    explicit ParameterPanel(wxWindow* parent);

    /// Does not call onChange. \param config valid
    void setConfig(const rawlog::Config& config);
    const rawlog::Config& config() const { return config_; }

    std::function<void(const rawlog::Config&)> onChange;
    std::function<void(const std::string&)> onError;

    /// Where presets are looked for first. \param folder empty: where the toolkit likes
    void setFolder(const std::string& folder) { folder_ = folder; }

 private:
    void addSections();
    wxSizer* makeButtons();
    void alignColumns();
    void arrange();
    void enter(const rawlog::Parameter& parameter, const std::string& text);
    void change(const rawlog::Config& config);
    void resetAll();
    void load();
    void save();
    void report(const std::string& error) const;

    rawlog::Config config_;
    std::string folder_;
    wxSearchCtrl* filter_;
    wxScrolledWindow* list_;
    std::vector<ParameterSection*> sections_;
};

}  // namespace offmap::window
