// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/core/Interval.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TSegment2D.h>

#include <optional>

namespace offmap::evaluation {

/// A laser beam. All shapes stand in the same frame, z up.
struct Ray {
    mrpt::math::TPoint3D origin;      ///< [m]
    mrpt::math::TVector3D direction;  ///< unit vector
};

/// A vertical rectangle, seen from both sides.
struct Panel {
    mrpt::math::TSegment2D line;  ///< [m] in top view
    core::Interval height;        ///< [m] z
};

/// A wire fence with square openings: beams meet its wires or nothing.
struct Mesh {
    Panel panel;
    double pitch;  ///< [m] from wire to wire, along and upwards, from point1 and the lower edge on
    double wire;   ///< [m] how broad a wire is
};

/// A horizontal plane without end, seen from both sides.
struct Plane {
    double z;  ///< [m]
};

/// A closed cylinder, standing or leaning: each of its horizontal sections is a circle.
struct Cylinder {
    mrpt::math::TPoint2D centre;      ///< [m] of the lowest section
    double radius;                    ///< [m]
    core::Interval height;            ///< [m] z
    mrpt::math::TPoint2D lean{0, 0};  ///< [m/m] way of the centre per metre of height
};

/// A closed box, turned about the vertical.
struct Box {
    mrpt::math::TPose2D centre;  ///< [m], [rad]
    double length;               ///< [m] along its own x axis
    double width;                ///< [m] along its own y axis
    core::Interval height;       ///< [m] z
};

/// Distance from the ray's origin to where it first meets the shape from outside, if it does. A ray
/// that lies in a panel or plane does not meet it. [m]
std::optional<double> meet(const Ray& ray, const Panel& panel);
std::optional<double> meet(const Ray& ray, const Mesh& mesh);
std::optional<double> meet(const Ray& ray, const Plane& plane);
std::optional<double> meet(const Ray& ray, const Cylinder& cylinder);
std::optional<double> meet(const Ray& ray, const Box& box);

/// A circle that holds a shape in top view.
struct BoundingCircle {
    mrpt::math::TPoint2D centre;  ///< [m]
    double radius;                ///< [m] infinite for a plane

    /// False for a ray that surely passes the shape.
    bool mayMeet(const Ray& ray) const;
};

BoundingCircle boundsOf(const Panel& panel);
BoundingCircle boundsOf(const Mesh& mesh);
BoundingCircle boundsOf(const Plane& plane);
BoundingCircle boundsOf(const Cylinder& cylinder);
BoundingCircle boundsOf(const Box& box);

/// The unit normal of a shape at a point of its surface, to either side. [m]
mrpt::math::TVector3D normalAt(const Panel& panel, const mrpt::math::TPoint3D& point);
mrpt::math::TVector3D normalAt(const Mesh& mesh, const mrpt::math::TPoint3D& point);
mrpt::math::TVector3D normalAt(const Plane& plane, const mrpt::math::TPoint3D& point);
mrpt::math::TVector3D normalAt(const Cylinder& cylinder, const mrpt::math::TPoint3D& point);
mrpt::math::TVector3D normalAt(const Box& box, const mrpt::math::TPoint3D& point);

}  // namespace offmap::evaluation
