// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DrawnPane.h"
#include "Series.h"

#include <span>
#include <string>

namespace offmap::window {

/// Three plots over the last minute, one over the other: the removed share, how long reducing took
/// and how old its results were, and the points kept.
class PlotsPane : public DrawnPane {
 public:
    explicit PlotsPane(wxWindow* parent);

    /// \param seconds [s] of any clock; where it goes back, the plots begin anew
    /// \param removedShare [0, 1] \param milliseconds [ms] that reducing took \param latency [ms]
    void add(double seconds, double removedShare, double milliseconds, double latency,
             double keptPoints);
    void clear();

 protected:
    void draw(wxGraphicsContext& canvas, const wxSize& size) override;

 private:
    /// One of the curves in a plot.
    struct Curve {
        const Series& series;
        std::string name;
        std::string now;  ///< the present value, with its unit; empty: none
        wxColour colour;
    };
    void drawPlot(wxGraphicsContext& canvas, const wxRect2DDouble& place, double top,
                  std::span<const Curve> curves);
    void drawHeads(wxGraphicsContext& canvas, const wxRect2DDouble& place,
                   std::span<const Curve> curves);
    void drawLevels(wxGraphicsContext& canvas, const wxRect2DDouble& box, double top);
    void drawSeconds(wxGraphicsContext& canvas, const wxRect2DDouble& box);

    Series removed_, milliseconds_, latency_, kept_;
    double now_ = 0;  // [s] of the newest sample
};

}  // namespace offmap::window
