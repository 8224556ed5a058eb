// SPDX-License-Identifier: BSD-3-Clause
#include "SvgFixture.h"

namespace offmap::maps {

namespace {

using test::ends;
using test::errorOf;
using test::inSvg;
using test::parsed;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double exact = 1e-9;  // [m] coordinates of metres, after a few roundings of 1e-16

std::string repeated(const std::string& text, size_t times) {
    std::string all;
    for (size_t i = 0; i < times; ++i) all += text;
    return all;
}

size_t walls(const std::string& content) { return parsed(inSvg(content)).walls.size(); }

}  // namespace

TEST(SvgTree, transformsOfGroupsAreNested) {
    const auto drawing =
        parsed(inSvg("<g transform='translate(2 3)'><g transform='scale(2)rotate(90)'>"
                     "<line x1='0' y1='0' x2='1' y2='0'/></g></g>"));
    EXPECT_THAT(ends(drawing.walls.at(0)), test::near({2, 7, 2, 5}, exact));
}

TEST(SvgTree, layersAreInkscapesOrTheOutermostGroups) {
    const std::string line = "<path d='M0 0h1'/>";
    const auto inkscape = parsed(
        inSvg("<g inkscape:groupmode='layer' inkscape:label='Walls' id='layer1'><g id='g7'>" +
              line + "</g><g inkscape:groupmode='layer' inkscape:label='old'>" + line +
              "</g></g><g inkscape:groupmode='layer' id='layer2'>" + line + "</g>"));
    EXPECT_THAT(inkscape.layers, ElementsAre("Walls", "Walls/old", "layer2"));
    EXPECT_THAT(inkscape.layerOf, ElementsAre(0, 1, 2));
    const auto groups =
        parsed(inSvg("<g><g id='walls'><g id='inner'>" + line + "</g></g></g>" + line));
    EXPECT_THAT(groups.layers, ElementsAre("walls", ""));
}

TEST(SvgTree, useShowsItsTargetWhereItStands) {
    const auto drawing = parsed(
        inSvg("<defs><g id='desk'><rect width='2' height='1'/></g></defs>"
              "<use href='#desk' x='3' y='4'/><use xlink:href='#desk' transform='translate(5)'/>"));
    ASSERT_EQ(drawing.walls.size(), 8U);
    EXPECT_THAT(ends(drawing.walls[0]), test::near({3, 6, 5, 6}, exact));
    EXPECT_THAT(ends(drawing.walls[4]), test::near({5, 10, 7, 10}, exact));
    EXPECT_THAT(drawing.layers, ElementsAre("desk"));
}

TEST(SvgTree, symbolAndInnerDrawingFillTheirViewport) {
    // 2 x 1 units in 4 x 4 m: twice as large, 1 m below the upper edge of the viewport.
    for (const char* content :
         {"<symbol id='s' viewBox='0 0 2 1'><path d='M0 0h2'/></symbol>"
          "<use href='#s' x='1' y='2' width='4' height='4'/>",
          "<svg x='1' y='2' width='4' height='40%' viewBox='0 0 2 1'><path d='M0 0h2'/></svg>"}) {
        const auto drawing = parsed(inSvg(content));
        EXPECT_THAT(ends(drawing.walls.at(0)), test::near({1, 7, 5, 7}, exact)) << content;
    }
}

TEST(SvgTree, whatIsNotShownIsNoWall) {
    const std::string line = "<path d='M0 0h1'/>", seen = line;
    for (const char* hidden :
         {"display='none'", "style='display:none'", "style='fill:none; stroke : none'",
          "visibility='hidden'", "opacity='0'", "class='off'", "id='gone'", "fill='none'"}) {
        EXPECT_EQ(walls(std::string("<style>/* x { */ .a, .off { display: none } #gone{fill:none}"
                                    "</style><g ") +
                        hidden + ">" + line + "</g>" + seen),
                  1U)
            << hidden;
    }
    EXPECT_EQ(walls("<defs>" + line + "</defs><clipPath id='c'>" + line + "</clipPath>" + seen),
              1U);
    EXPECT_EQ(walls("<g visibility='hidden'><path d='M0 0h1' visibility='visible'/></g>"), 1U);
    EXPECT_EQ(walls("<g fill='none'><path d='M0 0h1' stroke='red'/></g>"), 1U);
}

TEST(SvgTree, whatIsLeftOutIsCounted) {
    const auto drawing = parsed(
        inSvg("<text>Hall</text><text/><image/><clipPath/><path display='none' d='M0 0h1'/>"
              "<use href='other.svg#a'/><g id='glyph-0-1'/><use href='#glyph-0-1'/>"
              "<rect width='10' height='10' fill='white'/><path d='M0 0h1' clip-path='url(#c)'/>"));
    EXPECT_EQ(drawing.walls.size(), 1U);
    EXPECT_THAT(drawing.notes,
                Contains("left out: 2 texts, 1 image, 1 clipPath, 1 letter, 1 hidden element, "
                         "1 background, 1 use without its target"));
    EXPECT_THAT(drawing.notes, Contains("1 clipped element taken whole"));
}

TEST(SvgTree, frameOfTheSheetWithAnOutlineIsAWall) {
    EXPECT_EQ(walls("<rect width='10' height='10' stroke='black'/>"), 4U);
}

TEST(SvgTree, brokenDrawingIsRefusedByPlaceAndCause) {
    EXPECT_THAT(errorOf("<svg>\n<g>\n</svg>"), HasSubstr("plan.svg:3: no valid XML"));
    EXPECT_THAT(errorOf(""), HasSubstr("no valid XML"));
    EXPECT_THAT(errorOf("<html/>"), HasSubstr("outermost element is <html>"));
    EXPECT_THAT(errorOf(inSvg("<text>A</text>")),
                AllOf(HasSubstr("shows no line"), HasSubstr("1 text")));
    for (const auto& [element, cause] : std::initializer_list<std::pair<const char*, const char*>>{
             {"<path id='w' d='M0 0 L1'/>", "d holds no valid path"},
             {"<path id='w' d='M0 0 Lnan 1'/>", "d holds no valid path"},
             {"<path id='w' d='M0 0 H1e300'/>", "check its unit"},
             {"<polygon id='w' points='1,2 3'/>", "points holds no valid path"},
             {"<rect id='w' width='wide'/>", "width is 'wide'"},
             {"<circle id='w' r='-2'/>", "r is -2, below 0"},
             {"<g id='w' transform='turn(3)'/>", "transform is 'turn(3)'"},
             {"<g id='w' data-sigma-m='x'/>", "data-sigma-m is 'x'"},
             {"<g id='w' data-z-min-m='2' data-z-max-m='1'/>", "data-z-min-m 2 is above"}}) {
        EXPECT_THAT(errorOf(inSvg("\n\n" + std::string(element))),
                    AllOf(HasSubstr("plan.svg:3: <"), HasSubstr(" id=\"w\">: "), HasSubstr(cause)));
    }
    EXPECT_THAT(errorOf("<svg viewBox='0 0 0 1'/>"), HasSubstr("viewBox is '0 0 0 1'"));
    EXPECT_THAT(errorOf("<svg width='-3mm' viewBox='0 0 1 1'/>"), HasSubstr("width is '-3mm'"));
}

TEST(SvgTree, endlessAndExplodingDrawingsAreRefused) {
    EXPECT_THAT(errorOf(inSvg("<g id='a'><use href='#a'/></g>")), HasSubstr("inside each other"));
    EXPECT_THAT(errorOf(inSvg(repeated("<g>", 100'000) + repeated("</g>", 100'000))),
                HasSubstr("inside each other"));
    std::string bomb = "<defs><path id='u0' d='M0 0'/>";
    for (int i = 1; i < 12; ++i) {
        const std::string use = "<use href='#u" + std::to_string(i - 1) + "'/>";
        bomb += "<g id='u" + std::to_string(i) + "'>" + repeated(use, 10) + "</g>";
    }
    EXPECT_THAT(errorOf(inSvg(bomb + "</defs><use href='#u11'/>")), HasSubstr("far too many"));
}

TEST(SvgTree, entitiesAreNotExpanded) {
    const std::string head = "<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]>";
    EXPECT_EQ(parsed(head + inSvg("<g id='&a;'><path d='M0 0h1'/></g>")).layers.at(0), "&a;");
}

}  // namespace offmap::maps
