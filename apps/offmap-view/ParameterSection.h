// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ParameterRow.h"

#include <offmap/rawlog/Parameter.h>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>
#include <wx/panel.h>

namespace offmap::window {

/// The parameters of one section under a heading that folds them.
class ParameterSection : public wxPanel {
 public:
    /// \param parameters of this section; must outlive this
    ParameterSection(wxWindow* parent, std::span<const rawlog::Parameter> parameters, bool open);

    void show(const rawlog::Config& config);
    /// Only what the text finds, folded or not; all of it, as it was folded, for an empty one.
    void filter(const std::string& text);

    /// [px] as wide as the widest name of all sections, so that their columns are in line
    int nameWidth() const;
    void setNameWidth(int width);

    std::function<void(const rawlog::Parameter&, const std::string& text)> onEnter;
    std::function<void()> onFold;  ///< its height is another

 private:
    void fold();
    void label();

    std::string heading_;
    bool open_;
    size_t changed_ = 0;
    std::string filter_;
    wxButton* head_;
    wxPanel* body_;
    wxFlexGridSizer* grid_;
    std::vector<std::unique_ptr<ParameterRow>> rows_;
};

}  // namespace offmap::window
