// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/ReductionResult.h>

#include <mrpt/img/TColor.h>

namespace offmap::view {

/// The colours of figures 7 and 8, on a dark ground: what the map knows steps back, what is left
/// stands out.
struct Palette {
    mrpt::img::TColor background{16, 19, 24};
    mrpt::img::TColor mapped{178, 24, 24};    ///< removed: dark red
    mrpt::img::TColor kept{144, 238, 144};    ///< on a kept vertical segment: light green
    mrpt::img::TColor rest{104, 110, 120};    ///< not on a vertical segment: grey
    mrpt::img::TColor orphan{190, 120, 40};   ///< removed as orphan
    mrpt::img::TColor wall{96, 165, 250};     ///< the map
    mrpt::img::TColor sensor{250, 204, 21};   ///< where it was said to stand
    mrpt::img::TColor refined{45, 212, 191};  ///< where the scan shows it to have stood
    mrpt::img::TColor text{226, 232, 240};
    mrpt::img::TColor highlight{255, 255, 255};  ///< what is being looked at

    mrpt::img::TColor of(core::PointLabel label) const;
    /// Of returns whose segment was kept for this reason.
    mrpt::img::TColor of(core::KeepReason reason) const;

    /// The same meanings on a light ground.
    static Palette light();
};

/// From dark violet over green to yellow, even in lightness. \param share [0, 1], clamped
mrpt::img::TColor sequential(double share);

/// Blue below 0, pale yellow at 0, red above. \param share [-1, 1], clamped
mrpt::img::TColor diverging(double share);

}  // namespace offmap::view
