// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/LineMap.h>
#include <offmap/view/PlacedReturns.h>

#include <mrpt/img/TColor.h>
#include <mrpt/opengl/CSetOfObjects.h>

namespace offmap::view {

/// The colours of figures 7 and 8, on a dark ground: what the map knows steps back, what is left
/// stands out.
struct Palette {
    mrpt::img::TColor background{16, 19, 24};
    mrpt::img::TColor mapped{178, 24, 24};   ///< removed: dark red
    mrpt::img::TColor kept{144, 238, 144};   ///< on a kept vertical segment: light green
    mrpt::img::TColor rest{104, 110, 120};   ///< not on a vertical segment: grey
    mrpt::img::TColor orphan{190, 120, 40};  ///< removed as orphan
    mrpt::img::TColor wall{96, 165, 250};    ///< the map
    mrpt::img::TColor sensor{250, 204, 21};
    mrpt::img::TColor text{226, 232, 240};

    mrpt::img::TColor of(core::PointLabel label) const;
};

struct SceneOptions {
    Palette palette;
    float pointSize = 3.0F;      ///< [px]
    float wallLineWidth = 1.0F;  ///< [px]
    uint8_t wallOpacity = 48;    ///< [0, 255] of the walls' surfaces; 0: lines only
};

/// The scene's parts by name: "returns", "walls", "sensor". Walls are drawn where they come near
/// `extent`, from its floor to its ceiling or as high as the map says, for most reach from
/// everywhere to everywhere.
mrpt::opengl::CSetOfObjects::Ptr sceneOf(const PlacedReturns& returns, const core::LineMap& map,
                                         const mrpt::math::TBoundingBox& extent,
                                         const SceneOptions& options = {});

}  // namespace offmap::view
