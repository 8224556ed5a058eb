// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterEditor.h"

#include "ParameterFacts.h"
#include "WxText.h"

#include <wx/checkbox.h>
#include <wx/choice.h>
#include <wx/textctrl.h>

namespace offmap::window {

namespace {

using rawlog::Parameter;
using rawlog::ParameterKind;

class SwitchEditor : public ParameterEditor {
 public:
    explicit SwitchEditor(wxWindow& parent) : box_(new wxCheckBox(&parent, wxID_ANY, "")) {
        box_->Bind(wxEVT_CHECKBOX, [this](wxCommandEvent& event) {
            onEnter(event.IsChecked() ? "true" : "false");
        });
    }
    wxWindow& control() override { return *box_; }
    void show(const std::string& text) override { box_->SetValue(text == "true"); }

 private:
    wxCheckBox* box_;
};

class ChoiceEditor : public ParameterEditor {
 public:
    ChoiceEditor(wxWindow& parent, const Parameter& p) : choice_(new wxChoice(&parent, wxID_ANY)) {
        for (const std::string_view name : p.choices) choice_->Append(toWx(name));
        choice_->Bind(wxEVT_CHOICE,
                      [this](wxCommandEvent& event) { onEnter(fromWx(event.GetString())); });
        // the wheel scrolls the panel, it does not choose
        choice_->Bind(wxEVT_MOUSEWHEEL, [this](wxMouseEvent& event) {
            choice_->GetParent()->GetEventHandler()->ProcessEvent(event);
        });
    }
    wxWindow& control() override { return *choice_; }
    void show(const std::string& text) override { choice_->SetStringSelection(toWx(text)); }

 private:
    wxChoice* choice_;
};

/// Any text; numbers can be stepped with the arrow keys or the wheel, ten at a time with Shift.
class TextEditor : public ParameterEditor {
 public:
    TextEditor(wxWindow& parent, const Parameter& p)
        : parameter_(p),
          field_(new wxTextCtrl(&parent, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                                wxTE_PROCESS_ENTER | wxTE_RIGHT)) {
        field_->Bind(wxEVT_TEXT_ENTER, [this](wxCommandEvent&) { enter(); });
        // a window that closes takes the focus away when this is gone already
        field_->Bind(wxEVT_KILL_FOCUS, [this, field = field_](wxFocusEvent& event) {
            if (!field->IsBeingDeleted()) enter();
            event.Skip();
        });
        field_->Bind(wxEVT_KEY_DOWN, [this](wxKeyEvent& event) { onKey(event); });
        field_->Bind(wxEVT_MOUSEWHEEL, [this](wxMouseEvent& event) { onWheel(event); });
    }

    wxWindow& control() override { return *field_; }

    void show(const std::string& text) override {
        shown_ = text;
        if (fromWx(field_->GetValue()) != text) field_->ChangeValue(toWx(text));
    }

 private:
    void enter() {
        const std::string entered = fromWx(field_->GetValue().Strip(wxString::both));
        if (entered == shown_) {
            show(shown_);  // without spaces around it
        } else {
            onEnter(entered);
        }
    }

    void onKey(wxKeyEvent& event) {
        const int key = event.GetKeyCode();
        const bool stepping = (key == WXK_UP || key == WXK_DOWN) && hasSteps();
        if (key == WXK_ESCAPE) {
            field_->ChangeValue(toWx(shown_));
        } else if (stepping) {
            step((key == WXK_UP ? 1 : -1) * (event.ShiftDown() ? 10 : 1));
        } else {
            event.Skip();
        }
    }

    /// Elsewhere than in the field that has the focus the wheel scrolls the panel.
    void onWheel(wxMouseEvent& event) {
        if (field_->HasFocus() && hasSteps() && event.GetWheelRotation() != 0) {
            step((event.GetWheelRotation() > 0 ? 1 : -1) * (event.ShiftDown() ? 10 : 1));
        } else {
            event.Skip();
        }
    }

    void step(int steps) {
        const std::string text = stepped(parameter_, fromWx(field_->GetValue()), steps);
        if (text != shown_) onEnter(text);
        field_->SelectAll();
    }

    bool hasSteps() const {
        return parameter_.kind == ParameterKind::Number || parameter_.kind == ParameterKind::Count;
    }

    const Parameter& parameter_;
    wxTextCtrl* field_;
    std::string shown_;
};

}  // namespace

std::unique_ptr<ParameterEditor> makeEditor(wxWindow& parent, const Parameter& p) {
    if (p.kind == ParameterKind::Switch) return std::make_unique<SwitchEditor>(parent);
    if (p.kind == ParameterKind::Choice) return std::make_unique<ChoiceEditor>(parent, p);
    return std::make_unique<TextEditor>(parent, p);
}

}  // namespace offmap::window
