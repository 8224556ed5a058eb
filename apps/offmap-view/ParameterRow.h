// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ParameterEditor.h"

#include <offmap/rawlog/Parameter.h>

#include <functional>
#include <memory>
#include <string>

class wxButton;
class wxFlexGridSizer;
class wxStaticText;

namespace offmap::window {

/// A parameter's name, value, unit and the button back to its default, in a grid of four columns.
class ParameterRow {
 public:
    /// \param parameter, parent must outlive this
    ParameterRow(wxWindow& parent, wxFlexGridSizer& grid, const rawlog::Parameter& parameter);

    const rawlog::Parameter& parameter() const { return parameter_; }
    void show(const rawlog::Config& config);
    void setVisible(bool visible);

    int nameWidth() const;  ///< [px] that the name takes, when bold
    void setNameWidth(int width);

    /// The user has entered this text, which may not be allowed.
    std::function<void(const std::string&)> onEnter;

 private:
    const rawlog::Parameter& parameter_;
    wxStaticText* name_;
    std::unique_ptr<ParameterEditor> editor_;
    wxStaticText* unit_;
    wxButton* reset_;
};

}  // namespace offmap::window
