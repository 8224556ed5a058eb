// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SceneChoices.h"
#include "Shortcuts.h"
#include "Theme.h"

#include <functional>
#include <limits>
#include <optional>
#include <vector>
#include <wx/panel.h>

class wxBitmapButton;
class wxChoice;
class wxSlider;
class wxStaticText;

namespace offmap::window {

/// The row of controls above the picture.
class ControlBar : public wxPanel {
 public:
    explicit ControlBar(wxWindow* parent);

    std::function<void(Action)> onAction;
    std::function<void(double)> onSpeed;      ///< times as fast as recorded; infinite: at once
    std::function<void(double)> onPointSize;  ///< [px]

    void setTheme(const Theme& theme);
    void setPlaying(bool playing, bool canPause);
    /// \param turn from 0; none: nothing is shown \param turns 0: not known
    void setPlace(std::optional<uint64_t> turn, uint64_t turns);
    void setChoices(const SceneChoices& choices, CameraMode camera);
    /// \param factor one of its own can be chosen from then on
    void setSpeed(double factor);
    double speed() const;
    /// To the next higher speed that can be chosen, or the next lower one.
    void changeSpeed(int steps);

 private:
    wxBitmapButton* addButton(Action action, const wxString& tip);
    wxChoice* addChoice(const std::vector<wxString>& texts, const wxString& tip);
    void buildPlayControls();
    void buildViewControls();

    struct Button {
        wxBitmapButton* control;
        Action action;
    };
    std::vector<Button> buttons_;
    std::vector<double> speeds_{
        0.1, 0.25, 0.5, 1, 2, 5, 10, 100, std::numeric_limits<double>::infinity()};
    wxBitmapButton* playButton_ = nullptr;
    wxChoice *speed_ = nullptr, *camera_ = nullptr, *colours_ = nullptr;
    wxSlider* pointSize_ = nullptr;
    wxStaticText* place_ = nullptr;
    const Theme* theme_ = &Theme::darkOne();
    bool playing_ = false;
};

}  // namespace offmap::window
