// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Returns.h"
#include "ReduceFixture.h"

#include <offmap/maps/SvgMapWriter.h>
#include <offmap/maps/TextMap.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using namespace offmap::test;
using offmap::core::Wall;
using testing::HasSubstr;

/// The office's plan as people draw it.
class DirtyPlans : public ReduceFixture {
 protected:
    void SetUp() override {
        OFFMAP_NEEDS_SHARED_DATA()
        in_ = sharedData("room/room1.rawlog");
        plan_ = offmap::maps::readTextMap(sharedData("room/room.lines"), 0.03);
    }

    static std::string svg(const std::vector<Wall>& walls) {
        return offmap::maps::svgMapOf(walls, std::vector<std::string>(walls.size(), "walls"));
    }

    /// How many returns go with this map.
    size_t removedWith(const Path& map, const Arguments& options = {}) {
        map_ = map;
        Arguments more{"--force"};
        more.insert(more.end(), options.begin(), options.end());
        const RunResult run = reduce(more);
        EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(run);
        EXPECT_EQ(run.err, "") << "no warning is due";
        size_t removed = 0;
        const Observations before = observationsOf(in_), after = observationsOf(out_);
        for (size_t i = 0; i < before.size(); ++i) {
            removed += returnsOf(*before[i]).size() - returnsOf(*after.at(i)).size();
        }
        return removed;
    }

    size_t removedWithSvg(const std::string& text, const Arguments& options = {}) {
        writeFile(folder_ / "plan.svg", text);
        return removedWith(folder_ / "plan.svg", options);
    }

    std::vector<Wall> plan_;
};

Wall moved(Wall wall, double dx, double dy) {
    for (auto* end : {&wall.line.point1, &wall.line.point2})
        *end = *end + mrpt::math::TPoint2D(dx, dy);
    return wall;
}

/// The other face of each wall, behind it as seen from the middle of the room; jogs have none.
std::vector<Wall> withOuterFaces(std::vector<Wall> walls, const mrpt::math::TPoint2D& inside,
                                 double thickness) {
    for (const Wall& wall : std::vector<Wall>(walls)) {
        if (wall.line.length() < 0.2) continue;
        const auto outwards = (wall.line.point1 + wall.line.point2) * 0.5 - inside;
        const bool isAlongX = wall.line.point1.y == wall.line.point2.y;
        walls.push_back(moved(wall, isAlongX ? 0 : std::copysign(thickness, outwards.x),
                              isAlongX ? std::copysign(thickness, outwards.y) : 0));
    }
    return walls;
}

}  // namespace

TEST_F(DirtyPlans, cleanPlanRemovesWhatTheTextMapDoes) {
    const double asText = static_cast<double>(removedWith(sharedData("room/room.lines")));
    EXPECT_GT(asText, 17'000);
    EXPECT_NEAR(static_cast<double>(removedWithSvg(svg(plan_))), asText, 0.02 * asText);
}

TEST_F(DirtyPlans, planOnPaperDoesSoAtItsScale) {
    // 1:50, in millimetres of an A4 sheet, as one path of a layer
    std::string path;
    for (const Wall& wall : plan_) {
        const auto& [a, b] = wall.line;
        path +=
            fmt::format("M{:.3f},{:.3f} L{:.3f},{:.3f} ", 20 * a.x, -20 * a.y, 20 * b.x, -20 * b.y);
    }
    const double asText = static_cast<double>(removedWith(sharedData("room/room.lines")));
    const double onPaper = static_cast<double>(
        removedWithSvg("<svg width='297mm' height='210mm' viewBox='0 0 297 210'><g id='walls' "
                       "transform='translate(100 110)'><path fill='none' stroke='black' d='" +
                           path + "'/></g></svg>",
                       {"--map-scale", "50", "--map-origin=-5,-5,0"}));
    EXPECT_NEAR(onPaper, asText, 0.02 * asText);
}

TEST_F(DirtyPlans, bothFacesOfThickWallsRemoveWhatTheInnerOneDoes) {
    in_ = folder_ / "in.rawlog";
    writeLog(in_, smallLog());
    const auto walls = mapOf(offmap::evaluation::officeRoom());
    const double single = static_cast<double>(removedWithSvg(svg(walls)));
    EXPECT_GT(single, 1'000);
    for (const double thickness : {0.1, 0.2, 0.3}) {
        const auto faces = withOuterFaces(walls, {4, 2.5}, thickness);
        EXPECT_EQ(faces.size(), 2 * walls.size());
        EXPECT_NEAR(static_cast<double>(removedWithSvg(svg(faces))), single, 0.02 * single)
            << thickness << " m thick";
    }
}

TEST_F(DirtyPlans, outerFacesOfTheRealOfficeAddLittle) {
    const double single = static_cast<double>(removedWithSvg(svg(plan_)));
    for (const double thickness : {0.1, 0.2, 0.3}) {
        const double twofold =
            static_cast<double>(removedWithSvg(svg(withOuterFaces(plan_, {2.7, 0.8}, thickness))));
        // What was seen up to 30 cm behind the inner face, in reveals and openings, is now near a
        // face of the plan.
        EXPECT_GT(twofold, 0.98 * single) << thickness << " m thick";
        EXPECT_LT(twofold, 1.04 * single) << thickness << " m thick";
    }
}

TEST_F(DirtyPlans, piecesDuplicatesAndSpecksDoNotMatter) {
    std::vector<Wall> pieces;
    for (const Wall& wall : plan_) {
        const auto way = wall.line.point2 - wall.line.point1;
        const auto at = [&](double share) { return wall.line.point1 + way * share; };
        // overlapping, touching, twice, backwards
        for (const auto& [from, to] : {std::pair{0.0, 0.4}, {0.3, 0.6}, {1.0, 0.6}, {0.6, 1.0}}) {
            Wall piece = wall;
            piece.line = {at(from), at(to)};
            pieces.push_back(piece);
        }
        Wall speck = wall;
        speck.line = {at(0.5) + mrpt::math::TPoint2D(0.5, 0.5),
                      at(0.5) + mrpt::math::TPoint2D(0.52, 0.5)};
        pieces.push_back(speck);
    }
    const size_t whole = removedWithSvg(svg(plan_));
    EXPECT_EQ(removedWithSvg(svg(pieces), {"--report", folder_ / "r.json"}), whole);
    const auto report = nlohmann::json::parse(readFile(folder_ / "r.json"));
    EXPECT_EQ(report["map"]["walls"], plan_.size());
    EXPECT_THAT(report["map"]["notes"].dump(),
                testing::AllOf(HasSubstr("merged 36 "), HasSubstr("dropped 12 ")));
}
