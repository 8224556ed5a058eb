// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/Parameter.h>

#include <functional>
#include <memory>
#include <string>

class wxWindow;

namespace offmap::window {

/// The control of one parameter's value, which it shows and takes as text.
class ParameterEditor {
 public:
    virtual ~ParameterEditor() = default;

    virtual wxWindow& control() = 0;
    virtual void show(const std::string& text) = 0;

    /// What the user has entered: at once for switches, choices and steps, on Enter or when the
    /// field is left for text. It may not be allowed.
    std::function<void(const std::string&)> onEnter;

 protected:
    ParameterEditor() = default;
    ParameterEditor(const ParameterEditor&) = default;
    ParameterEditor& operator=(const ParameterEditor&) = default;
};

/// \param parent owns the control
std::unique_ptr<ParameterEditor> makeEditor(wxWindow& parent, const rawlog::Parameter& parameter);

}  // namespace offmap::window
