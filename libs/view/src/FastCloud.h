// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/CPointCloudColoured.h>

#include <utility>
#include <vector>

namespace offmap::view {

/// A coloured cloud that takes its points as they are: MRPT's own locks and marks itself as changed
/// for each, and sorts all of them into an octree that it does not draw by. It is stored, and told
/// by its class, as a CPointCloudColoured.
class FastCloud : public mrpt::opengl::CPointCloudColoured {
 public:
    /// \pre one colour per point
    FastCloud(std::vector<mrpt::math::TPoint3Df>&& points,
              std::vector<mrpt::img::TColor>&& colours) {
        m_vertex_buffer_data = std::move(points);
        m_color_buffer_data = std::move(colours);
    }

    void onUpdateBuffers_Points() override {}
    auto internalBoundingBoxLocal() const -> mrpt::math::TBoundingBoxf override {
        return verticesBoundingBox();
    }
};

}  // namespace offmap::view
