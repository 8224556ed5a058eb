// SPDX-License-Identifier: BSD-3-Clause
// All drawn panes with made-up values, for a look: gallery [light]. Ends when closed.
#include "../MadeUpFrame.h"
#include "FiguresPane.h"
#include "PlanPane.h"
#include "PlotsPane.h"
#include "TimelinePane.h"

#include <random>
#include <wx/app.h>
#include <wx/frame.h>
#include <wx/sizer.h>

namespace {

using offmap::test::madeUpFrame;

offmap::live::LiveFramePtr walkingFrame(int step, std::mt19937& random) {
    auto frame = std::make_shared<offmap::live::LiveFrame>(madeUpFrame());
    auto& scan = frame->reduced.organized.scan;
    std::normal_distribution<float> spread(0, 0.4F);
    for (int i = 0; i < 600; ++i) {
        scan.points.emplace_back(3 + spread(random), 2 + 0.3F * spread(random), 0.5F);
        scan.points.emplace_back(spread(random), -3 + spread(random), 0.5F);
    }
    scan.columns[0].end = static_cast<uint32_t>(scan.points.size());
    frame->result.labels.assign(scan.points.size(), offmap::core::PointLabel::Kept);
    const double angle = 0.02 * step;
    scan.columns[0].sensor->sensorInMap = {
        10 + 6 * std::cos(angle), 6 + 4 * std::sin(angle), 1, angle + M_PI / 2, 0, 0};
    frame->result.alignment->correction.pivot = {10 + 6 * std::cos(angle), 6 + 4 * std::sin(angle)};
    auto& record = frame->reduced.record;
    record.time += std::chrono::milliseconds(100 * step);
    record.counts.returns = 32'761;
    record.removedByRay = 12'300;
    record.onVerticalSegments = 14'000;
    record.keptByReason = {0, 1'204, 402, 96, 30, 0};
    record.milliseconds = 6.43;
    record.health.matchedShare = 0.95;
    record.health.fit = offmap::core::PoseFit{0.031, 0.004, 0.9, 1.2, 1};
    return frame;
}

class GalleryFrame : public wxFrame {
 public:
    explicit GalleryFrame(const offmap::window::Theme& theme)
        : wxFrame(nullptr, wxID_ANY, "Panes", wxDefaultPosition, {1400, 880}) {
        using namespace offmap::window;
        auto* plan = new PlanPane(this);
        auto* figures = new FiguresPane(this);
        auto* plots = new PlotsPane(this);
        auto* timeline = new TimelinePane(this);
        auto* live = new TimelinePane(this);
        plan->SetMinSize({700, 500});
        plots->SetMinSize({300, 260});
        auto* side = new wxBoxSizer(wxVERTICAL);
        side->Add(figures, 0, wxEXPAND);
        side->Add(plots, 0, wxTOP, 8);
        auto* upper = new wxBoxSizer(wxHORIZONTAL);
        upper->Add(plan, 1, wxEXPAND | wxRIGHT, 8);
        upper->Add(side, 0, wxEXPAND);
        auto* all = new wxBoxSizer(wxVERTICAL);
        all->Add(upper, 1, wxEXPAND | wxBOTTOM, 8);
        all->Add(timeline, 0, wxEXPAND | wxBOTTOM, 8);
        all->Add(live, 0, wxEXPAND);
        SetSizer(all);
        for (DrawnPane* pane : std::initializer_list<DrawnPane*>{plan, plots, timeline, live}) {
            pane->setTheme(theme);
        }
        figures->setTheme(theme);
        plan->setMap(offmap::test::hallMap());
        timeline->setTurns(1200);
        offmap::live::LiveFigures totals;
        totals.source.state = offmap::live::SourceState::Running;
        totals.turnsPerSecond = 9.93;
        totals.turnsDropped = 12;
        std::mt19937 random(6);
        std::normal_distribution<double> noise(0, 1);
        for (int i = 0; i < 1000; ++i) {
            const double share = 0.8 + 0.1 * std::sin(0.02 * i) + 0.01 * noise(random);
            const double milliseconds = 6 + std::abs(noise(random)) + (i % 97 == 0 ? 9 : 0);
            const bool suspect = i > 300 && i < 320;
            if (i < 500 || i > 700)
                timeline->add(static_cast<uint64_t>(i), share, milliseconds, suspect);
            if (i < 140) live->add(static_cast<uint64_t>(i), share, milliseconds, i % 50 == 7);
            plots->add(0.1 * i, share, milliseconds, milliseconds + 2 + std::abs(noise(random)),
                       8000 + 2000 * share * noise(random));
            if (i < 250) {
                const auto frame = walkingFrame(i, random);
                plan->show(frame);
                totals.latency.add(milliseconds + 2);
                totals.totals.milliseconds.add(milliseconds);
                figures->show(totals, frame);
            }
        }
        timeline->setPosition(812);
        live->setPosition(139);
    }
};

class Gallery : public wxApp {
 public:
    bool OnInit() override {
        const bool light = argc > 1 && argv[1] == "light";
        const auto& theme =
            light ? offmap::window::Theme::lightOne() : offmap::window::Theme::darkOne();
        offmap::window::applyToToolkit(theme);
        return (new GalleryFrame(theme))->Show();
    }
};

}  // namespace

wxIMPLEMENT_APP(Gallery);
