// SPDX-License-Identifier: BSD-3-Clause
#include "PlanePlacement.h"

#include "Coordinates.h"
#include "PrintableName.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace offmap::maps {

namespace {

using mrpt::math::TPoint2D;

void scale(DrawnLines& lines, double factor) {
    if (factor == 1) return;
    for (TPoint2D& point : lines.points) point *= factor;
}

void shift(DrawnLines& lines, const TPoint2D& origin) {
    for (TPoint2D& point : lines.points) point -= origin;
}

bool isInDegrees(const Extent& extent) {
    return extent.low.x >= -180 && extent.high.x <= 180 && extent.low.y >= -90 &&
           extent.high.y <= 90;
}

std::unique_ptr<OGRCoordinateTransformation> conversion(const OGRSpatialReference& from,
                                                        const OGRSpatialReference& to) {
    std::unique_ptr<OGRCoordinateTransformation> made(
        OGRCreateCoordinateTransformation(&from, &to));
    if (made) return made;
    throw std::runtime_error(
        "its coordinate reference system cannot be converted; --map-crs local takes its "
        "coordinates for lengths");
}

/// A place on the earth in the file's own system, which may be of another date or datum.
TPoint2D inSystem(const GeographicPlace& place, const OGRSpatialReference& system) {
    OGRSpatialReference earth;
    earth.SetWellKnownGeogCS("WGS84");
    earth.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    TPoint2D point{place.longitudeDeg, place.latitudeDeg};
    convert(*conversion(earth, system), {&point, 1});
    if (std::isfinite(point.x) && std::isfinite(point.y)) return point;
    throw std::runtime_error(fmt::format(
        "--map-anchor {:.7f},{:.7f} lies outside of where its coordinate reference system holds",
        place.latitudeDeg, place.longitudeDeg));
}

/// Distances and directions from the centre become true; those between other places of a map, by
/// 4 micrometres within a kilometre of it.
void project(DrawnLines& lines, const TPoint2D& centre) {
    OGRSpatialReference plane;
    plane.CopyGeogCSFrom(&*lines.system);  // its own datum: nothing is shifted
    plane.SetAE(centre.y, centre.x, 0, 0);
    plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    convert(*conversion(*lines.system, plane), lines.points);
}

void placeGeographic(DrawnLines& lines, const Extent& extent, const MapOptions& options,
                     Drawing& drawing) {
    TPoint2D centre{0.5 * (extent.low.x + extent.high.x), 0.5 * (extent.low.y + extent.high.y)};
    if (options.anchor) centre = inSystem(*options.anchor, *lines.system);
    project(lines, centre);
    drawing.notes.push_back(
        fmt::format("coordinates: degrees, projected to metres around {}{:.7f},{:.7f}{}",
                    options.anchor ? "" : "its middle ", centre.y, centre.x,
                    options.anchor ? "" : "; --map-anchor takes another place"));
}

void placeProjected(DrawnLines& lines, const MapOptions& options, Drawing& drawing) {
    if (options.anchor && lines.system->IsProjected()) {
        shift(lines, inSystem(*options.anchor, *lines.system));
    }
    const double unit = lines.system->GetLinearUnits();  // [m]
    scale(lines, unit);
    const char* name = lines.system->GetName();
    std::string note = fmt::format("coordinates: {}", printableName(name == nullptr ? "" : name));
    if (unit != 1) note += fmt::format(", units of {} m", unit);
    if (options.anchor) note += ", counted from --map-anchor";
    drawing.notes.push_back(std::move(note));
}

void placeLocal(DrawnLines& lines, VectorKind kind, const MapOptions& options, Drawing& drawing) {
    const auto& unit = lines.unit;
    const double metres = options.units ? inMetres(*options.units) : unit ? unit->metres : 1;
    scale(lines, metres);
    if (options.units) {
        drawing.notes.push_back(fmt::format("unit: {}, by --map-units", toString(*options.units)));
    } else if (unit) {
        drawing.notes.push_back(
            fmt::format("unit: {}, by the drawing's $INSUNITS; --map-units overrides", unit->name));
    } else if (kind == VectorKind::Cad) {
        drawing.notes.emplace_back(
            "unit: metres, as the drawing states none; --map-units overrides");
    } else {
        drawing.notes.emplace_back("coordinates: local metres");
    }
    if (options.anchor) {
        drawing.warnings.emplace_back(
            "--map-anchor does nothing: the coordinates are lengths, not places on the earth");
    }
}

}  // namespace

bool placeInPlane(DrawnLines& lines, VectorKind kind, const MapOptions& options, Drawing& drawing) {
    const Extent extent = extentOf(lines.points);
    const auto& system = lines.system;
    const bool isSaidLocal = options.coordinates == MapCoordinates::Local || options.units;
    const bool isGeographic = system && system->IsGeographic() != 0;
    if (kind == VectorKind::Cad || isSaidLocal || !system || extent.isEmpty() ||
        (isGeographic && !isInDegrees(extent))) {
        placeLocal(lines, kind, options, drawing);
    } else if (isGeographic) {
        placeGeographic(lines, extent, options, drawing);
        return true;
    } else if (system->IsProjected() != 0 || system->IsLocal() != 0) {
        placeProjected(lines, options, drawing);
    } else {
        throw std::runtime_error(
            "its coordinates are neither degrees nor lengths in a plane; convert it to a projected "
            "coordinate reference system, or --map-crs local takes them for lengths");
    }
    return false;
}

}  // namespace offmap::maps
