// SPDX-License-Identifier: BSD-3-Clause
#include "LineGatherer.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace offmap::maps {

namespace {

constexpr size_t mostPlaces = 50'000'000;  // 800 MB

std::optional<double> number(const OGRFeature& feature, const char* field) {
    const int index = feature.GetFieldIndex(field);
    if (index < 0 || !feature.IsFieldSetAndNotNull(index)) return std::nullopt;
    const double value = feature.GetFieldAsDouble(index);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// With the properties that geoJsonOf() writes.
DrawnLines::Line lineLike(const OGRFeature& feature, uint32_t layer) {
    DrawnLines::Line line{.layer = layer, .feature = feature.GetFID()};
    line.sigma = number(feature, "sigma_m");
    if (line.sigma && *line.sigma < 0) line.sigma.reset();
    const auto everything = core::Interval::everything();
    const double low = number(feature, "z_min_m").value_or(everything.min());
    const double high = number(feature, "z_max_m").value_or(everything.max());
    if (low <= high) line.height = {low, high};
    return line;
}

}  // namespace

uint32_t LineGatherer::layerIndex(const std::string& name) {
    const auto [found, isNew] =
        layerOf_.try_emplace(name, static_cast<uint32_t>(drawn_.layers.size()));
    if (isNew) drawn_.layers.push_back(name);
    return found->second;
}

void LineGatherer::add(const OGRFeature& feature, uint32_t layer) {
    line_ = lineLike(feature, layer);
    if (const OGRGeometry* geometry = feature.GetGeometryRef()) add(*geometry);
}

void LineGatherer::add(const OGRGeometry& geometry) {
    if (geometry.hasCurveGeometry()) {
        constexpr double step = 0.5;  // [deg] as in GdalSession
        const std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry(step));
        if (linear && !linear->hasCurveGeometry()) add(*linear);
        return;
    }
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPoint) {
        ++drawn_.leftOut["points and texts"];
    } else if (type == wkbLineString) {
        addPlaces(*geometry.toSimpleCurve());
    } else if (type == wkbPolygon || type == wkbTriangle) {
        for (const OGRLinearRing* ring : *geometry.toPolygon()) addPlaces(*ring);
    } else if (type == wkbPolyhedralSurface || type == wkbTIN) {
        for (const OGRPolygon* face : *geometry.toPolyhedralSurface()) add(*face);
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
        for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part);
    }
}

void LineGatherer::addPlaces(const OGRSimpleCurve& line) {
    line_.begin = drawn_.points.size();
    if (line_.begin + static_cast<size_t>(line.getNumPoints()) > mostPlaces) {
        throw std::runtime_error(
            fmt::format("its lines have more than {} million places; export the walls alone",
                        mostPlaces / 1'000'000));
    }
    line_.rises = false;
    for (int i = 0; i < line.getNumPoints(); ++i) {
        drawn_.points.emplace_back(line.getX(i), line.getY(i));
        drawn_.hasHeights = drawn_.hasHeights || line.getZ(i) != 0;
        line_.rises = line_.rises || line.getZ(i) != line.getZ(0);
    }
    line_.end = drawn_.points.size();
    drawn_.lines.push_back(line_);
}

}  // namespace offmap::maps
