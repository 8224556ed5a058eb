// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/evaluation/Drive.h>
#include <offmap/evaluation/GaussianNoise.h>
#include <offmap/evaluation/StandOff.h>

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace offmap::evaluation {

namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TSegment2D;

constexpr double chordLength = 0.1;  // [m] at most, of the chords that stand for a way

/// Where a robot can be.
class FreeSpace {
 public:
    FreeSpace(const World& world, const TPoint2D& start) : low_(start), high_(start) {
        for (const core::Wall& wall : mapOf(world)) {
            for (const TPoint2D& p : {wall.line.point1, wall.line.point2}) {
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
                high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
            }
        }
        for (const Surface& surface : world.surfaces()) {
            if (standsInTheWay(surface)) obstacles_.push_back(&surface);
        }
    }

    /// \param duration [s]
    bool isFree(const TPose2D& from, const Motion& motion, double duration) const {
        if (motion.speed == 0) return true;
        const double chords = std::max(1.0, std::ceil(motion.speed * duration / chordLength));
        TPose2D at = from;
        for (double i = 1; i <= chords; ++i) {
            const TPose2D next = moved(from, motion, duration * i / chords);
            if (!isFree({{at.x, at.y}, {next.x, next.y}})) return false;
            at = next;
        }
        return true;
    }

 private:
    static bool standsInTheWay(const Surface& surface) {
        constexpr double robotHeight = 1.8;  // [m]
        return std::visit(
            [](const auto& shape) {
                if constexpr (requires { shape.height; }) return shape.height.min() < robotHeight;
                return false;
            },
            surface.shape);
    }

    bool isFree(const TSegment2D& way) const {
        constexpr double clearance = 0.3;  // [m]
        const TPoint2D& end = way.point2;
        if (end.x < low_.x || end.x > high_.x || end.y < low_.y || end.y > high_.y) return false;
        return std::ranges::none_of(obstacles_, [&](const Surface* obstacle) {
            return std::visit(
                [&](const auto& shape) {
                    if constexpr (requires { gap(shape, way); }) {
                        return gap(shape, way) < clearance;
                    }
                    return false;
                },
                obstacle->shape);
        });
    }

    std::vector<const Surface*> obstacles_;
    TPoint2D low_, high_;  // [m] bounds of the map and the start
};

class Driver {
 public:
    Driver(const World& world, const DrivePlan& plan, uint64_t seed)
        : plan_(plan), space_(world, {plan.start.x, plan.start.y}), noise_(seed) {}

    std::vector<TPose2D> drive() {
        std::vector<TPose2D> places;
        TPose2D at = plan_.start;
        for (size_t i = 0; i < plan_.places; ++i) {
            std::optional<TPose2D> next;
            if (i > 0) {
                const double wander = noise_.next(mrpt::DEG2RAD(8.0));
                next = nextPlace({at.x, at.y, at.phi + wander}, plan_.step);
            }
            if (!next) next = nextPlace(at, 0);
            if (!next) throw std::runtime_error("no room for what the robot moves during a scan");
            places.push_back(*next);
            at = moved(*next, plan_.whileScanning, plan_.scanDuration);
        }
        return places;
    }

 private:
    /// The place after a step in the direction nearest to the heading in which there is room.
    std::optional<TPose2D> nextPlace(const TPose2D& from, double step) const {
        constexpr double turn = mrpt::DEG2RAD(15.0);
        constexpr Motion straight{1, 0};
        for (int i = 0; i <= 24; ++i) {
            const int turns = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
            TPose2D towards = from;
            if (turns != 0) towards.phi = mrpt::math::wrapToPi(from.phi + turns * turn);
            const bool stays = step == 0;
            const TPose2D place = stays ? towards : moved(towards, straight, step);
            if ((stays || space_.isFree(towards, straight, step)) &&
                space_.isFree(place, plan_.whileScanning, plan_.scanDuration)) {
                return place;
            }
        }
        return std::nullopt;
    }

    DrivePlan plan_;
    FreeSpace space_;
    GaussianNoise noise_;
};

}  // namespace

std::vector<TPose2D> placesOnDrive(const World& world, const DrivePlan& plan, uint64_t seed) {
    return Driver(world, plan, seed).drive();
}

}  // namespace offmap::evaluation
