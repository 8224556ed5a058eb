// SPDX-License-Identifier: BSD-3-Clause
#include "FastCloud.h"
#include "WallStrips.h"

#include <offmap/core/WallGeometry.h>
#include <offmap/view/Scene.h>

#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CSphere.h>

#include <algorithm>
#include <array>
#include <memory>

namespace offmap::view {
namespace {

using core::PointLabel;
using mrpt::math::TBoundingBox;
using mrpt::opengl::CSetOfObjects;

constexpr std::array labels{PointLabel::NotOnVerticalSegment, PointLabel::Kept, PointLabel::Mapped,
                            PointLabel::Orphan};

/// Points on their way into a cloud.
struct CloudPoints {
    std::vector<mrpt::math::TPoint3Df> points;
    std::vector<mrpt::img::TColor> colours;

    void reserve(size_t n) {
        points.reserve(n);
        colours.reserve(n);
    }
    mrpt::opengl::CRenderizable::Ptr cloud(float pointSize) && {
        auto cloud = std::make_shared<FastCloud>(std::move(points), std::move(colours));
        cloud->setPointSize(pointSize);
        return cloud;
    }
};

bool comesNear(const core::Wall& wall, const TBoundingBox& extent) {
    const double margin = 0.25 * std::max(extent.max.x - extent.min.x, extent.max.y - extent.min.y);
    const auto [low, high] = core::boundsOf(wall);
    return low.x <= extent.max.x + margin && extent.min.x - margin <= high.x &&
           low.y <= extent.max.y + margin && extent.min.y - margin <= high.y;
}

}  // namespace

bool isShown(PointLabel label, const SceneOptions& options) {
    if (core::isRemoved(label)) return options.showMapped;
    return label == PointLabel::Kept || options.showRest;
}

std::vector<uint8_t> hiddenReturns(const PlacedReturns& returns, const SceneOptions& options) {
    if (options.showMapped && options.showRest) return {};
    std::vector<uint8_t> hidden(returns.labels.size());
    std::ranges::transform(returns.labels, hidden.begin(), [&](PointLabel label) -> uint8_t {
        return isShown(label, options) ? 0 : 1;
    });
    return hidden;
}

/// Returns off the vertical segments are many and matter least: smaller, and drawn first.
CSetOfObjects::Ptr returnsOf(const PlacedReturns& returns, const SceneOptions& options) {
    std::array<size_t, labels.size()> counts{};
    for (const PointLabel label : returns.labels) ++counts.at(static_cast<size_t>(label));
    std::array<mrpt::img::TColor, labels.size()> colours;
    std::array<bool, labels.size()> shown{};
    for (const PointLabel label : labels) {
        colours.at(static_cast<size_t>(label)) = options.palette.of(label);
        shown.at(static_cast<size_t>(label)) = isShown(label, options);
    }
    CloudPoints rest, onSegments;
    rest.reserve(counts.front());
    onSegments.reserve(returns.points.size() - counts.front());
    for (size_t i = 0; i < returns.points.size(); ++i) {
        const auto label = static_cast<size_t>(returns.labels[i]);
        if (!shown[label]) continue;
        CloudPoints& cloud = label == 0 ? rest : onSegments;
        cloud.points.push_back(returns.points[i]);
        cloud.colours.push_back(returns.colours.empty() ? colours[label] : returns.colours[i]);
    }
    auto clouds = CSetOfObjects::Create();
    clouds->setName("returns");
    clouds->insert(std::move(rest).cloud(0.7F * options.pointSize));
    clouds->insert(std::move(onSegments).cloud(options.pointSize));
    return clouds;
}

CSetOfObjects::Ptr wallsOf(const core::LineMap& map, const TBoundingBox& extent,
                           const SceneOptions& options) {
    WallStrips strips;
    for (const core::Wall& wall : map.walls())
        if (comesNear(wall, extent)) strips.add(wall, extent.min.z, extent.max.z);
    auto walls = CSetOfObjects::Create();
    walls->setName("walls");
    walls->insert(strips.lines(options.palette.wall, options.wallLineWidth));
    if (options.wallOpacity > 0) {
        walls->insert(strips.surfaces(options.palette.wall, options.wallOpacity));
    }
    return walls;
}

CSetOfObjects::Ptr sensorOf(const PlacedReturns& returns, const TBoundingBox& extent,
                            const SceneOptions& options) {
    auto sensor = CSetOfObjects::Create();
    sensor->setName("sensor");
    if (returns.sensorPath.empty()) return sensor;
    const auto size = static_cast<float>(
        0.012 * std::max(extent.max.x - extent.min.x, extent.max.y - extent.min.y));
    auto ball = mrpt::opengl::CSphere::Create(size);
    auto arrow =
        mrpt::opengl::CArrow::Create(0, 0, 0, 4 * size, 0, 0, 0.35F, 0.25F * size, 0.7F * size);
    ball->setColor_u8(options.palette.sensor);
    arrow->setColor_u8(options.palette.sensor);
    arrow->enableLight(false);
    sensor->insert(ball);
    sensor->insert(arrow);
    sensor->setPose(returns.sensorPath[returns.sensorPath.size() / 2]);
    return sensor;
}

CSetOfObjects::Ptr sceneOf(const PlacedReturns& returns, const core::LineMap& map,
                           const TBoundingBox& extent, const SceneOptions& options) {
    auto scene = CSetOfObjects::Create();
    scene->insert(returnsOf(returns, options));
    if (options.showPoses) scene->insert(sensorOf(returns, extent, options));
    if (options.showWalls) scene->insert(wallsOf(map, extent, options));
    return scene;
}

}  // namespace offmap::view
