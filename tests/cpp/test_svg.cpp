#include "drawing/svg.hpp"

#include "drawing/palette.hpp"
#include "drawing/screen.hpp"
#include "drawing/svg_shapes.hpp"
#include "drawing/svg_theme.hpp"
#include "drawing/xml.hpp"
#include "scene/builtin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace knotwork::drawing {
namespace {

using scene::Json;
using scene::Scene;

Scene opened(const std::string& text) {
    return Scene::open(scene::parseJson(text).value()).value();
}

std::string numberText(double value, int decimals) {
    std::string text;
    appendNumber(text, value, decimals);
    return text;
}

TEST(Xml, NumbersHaveAsFewDigitsAsTheyNeed) {
    EXPECT_EQ(numberText(0, 3), "0");
    EXPECT_EQ(numberText(-0.0, 3), "0");
    EXPECT_EQ(numberText(-0.0004, 3), "0");
    EXPECT_EQ(numberText(-0.0006, 3), "-0.001");
    EXPECT_EQ(numberText(12.3, 3), "12.3");
    EXPECT_EQ(numberText(12.30049, 3), "12.3");
    EXPECT_EQ(numberText(0.9996, 3), "1");
    EXPECT_EQ(numberText(1e-9, 4), "0");
    EXPECT_EQ(numberText(1234567.5, 4), "1234567.5");
    EXPECT_EQ(numberText(10.05, 2), "10.05");
    EXPECT_EQ(numberText(7, 0), "7");
    EXPECT_EQ(numberText(1e300, 4), "1000000000");
    EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity(), 9), "-1000000000");
    EXPECT_EQ(numberText(std::nan(""), 4), "0");
}

TEST(Xml, TextCannotBecomeMarkup) {
    std::string xml;
    appendEscaped(xml, "<a href=\"x\">'&amp;'\n\x01\x7f\xEF\xBF\xBE\xC3\xA6\xEF\xBF\xBD");
    EXPECT_EQ(xml, "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;&#39;&#10;\xEF\xBF\xBD\x7f"
                   "\xEF\xBF\xBD\xC3\xA6\xEF\xBF\xBD");
}

const std::string square = R"({"knotwork": 1, "title": "A <corner>", "description": "1 < 2",
    "view": {"camera": {"center": [1, 0.5], "height": 2}},
    "objects": [{"id": "c1", "type": "bspline-curve", "degree": 1, "points": [[0,0],[2,0],[2,1]],
        "style": {"colour": "#2f5fd0", "width": 3}, "show": {"knots": false, "basis": false}},
      {"id": "c2", "type": "bezier-curve", "points": [[0,0],[1,1],[2,0]], "show": {"polygon": false, "points": false}}]})";

TEST(Svg, IsGroupedAndNamedByObjectAndRole) {
    const std::string text = svg(opened(square).state(), {.width = 400, .height = 200});
    EXPECT_EQ(text, R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="200" viewBox="0 0 400 200" role="img" class="knotwork knotwork-light">
  <title>A &lt;corner&gt;</title>
  <desc>1 &lt; 2</desc>
  <rect class="knotwork-background" width="400" height="200" fill="#ffffff"/>
  <g class="knotwork-pane" data-pane="curve" data-matrix="100.0 0.0 0.0 -100.0 100.0 150.0">
    <g class="knotwork-object" data-object="c1" data-type="bspline-curve">
      <g class="knotwork-polygon" data-role="polygon" fill="none" stroke="#8a97ab" stroke-width="1.5" stroke-linecap="round" stroke-linejoin="round">
        <path d="M100,150L300,150L300,50"/>
      </g>
      <g class="knotwork-curve" data-role="curve" fill="none" stroke="#2f5fd0" stroke-width="3" stroke-linecap="round" stroke-linejoin="round">
        <path d="M100,150L300,150L300,50"/>
      </g>
      <g class="knotwork-points" data-role="points" fill="#c4561b" stroke="#ffffff" stroke-width="1.5">
        <circle cx="100" cy="150" r="5.5"/>
        <circle cx="300" cy="150" r="5.5"/>
        <circle cx="300" cy="50" r="5.5"/>
      </g>
    </g>
    <g class="knotwork-object" data-object="c2" data-type="bezier-curve">
      <g class="knotwork-curve" data-role="curve" fill="none" stroke="#2b6cb0" stroke-width="2.5" stroke-linecap="round" stroke-linejoin="round">
        <path d="M100,150C166.6667,83.3333 233.3333,83.3333 300,150"/>
      </g>
    </g>
  </g>
</svg>
)");
}

std::string attributeOf(const std::string& xml, const std::string& name) {
    const std::size_t at = xml.find(" " + name + "=\"");
    if (at == std::string::npos) return {};
    const std::size_t from = at + name.size() + 3;
    return xml.substr(from, xml.find('"', from) - from);
}

TEST(Svg, FitsTheDrawingWithAMarginAndKeepsTheAspect) {
    const std::string one = R"({"knotwork": 1, "objects": [{"id": "c1", "type": "bspline-curve",
        "degree": 1, "points": [[-20,30],[20,30],[20,40]]}]})";
    // 40 by 10 units: the width decides.
    const std::string text = svg(opened(one).state(), {.width = 500, .height = 500});
    EXPECT_EQ(attributeOf(text, "data-matrix"), "11.0 0.0 0.0 -11.0 250.0 635.0");
    EXPECT_NE(text.find("M30,305L470,305L470,195"), std::string::npos) << text;
}

TEST(Svg, TitleDescriptionAndBackgroundCanBeChosen) {
    const Scene scene = opened(square);
    const std::string text = svg(scene.state(), {.theme = SvgTheme::dark, .moment = {},
        .title = "\"]]><script>", .description = "&", .background = "none"});
    EXPECT_NE(text.find("<title>&quot;]]&gt;&lt;script&gt;</title>\n  <desc>&amp;</desc>\n  <g"),
              std::string::npos) << text;
    EXPECT_EQ(text.find("<rect"), std::string::npos);
    const std::string green = svg(scene.state(), {.background = "#00ff00"});
    EXPECT_NE(green.find("fill=\"#00ff00\"/>"), std::string::npos);
    const std::string empty = svg(opened(R"({"knotwork": 1})").state(), {});
    EXPECT_NE(empty.find("<title>Knotwork</title>\n  <rect"), std::string::npos) << empty;
}

TEST(Svg, TheContrastThemeIsReadable) {
    const Colour yellow{1, 0.9, 0.1, 1};
    EXPECT_EQ(svgColour(yellow, SvgTheme::light), "#ffe61a");
    const auto darkened = scene::parseColour(svgColour(yellow, SvgTheme::contrast));
    EXPECT_LE(luminance(*darkened), 0.1);
    EXPECT_EQ(svgColour({0, 0, 0.2, 1}, SvgTheme::contrast), "#000033");
}

TEST(Svg, LocalCurvesAreDashedWhereTheirNeighbourIsStronger) {
    const auto scenes = scene::builtinScenes();
    for (const auto& builtin : scenes) {
        const std::string text = svg(opened(std::string(builtin.document)).state(), {});
        EXPECT_EQ(text.find(" style="), std::string::npos);
        EXPECT_EQ(text.find("nan"), std::string::npos);
        if (builtin.id != "b-functions") continue;
        EXPECT_NE(text.find("<path data-index=\"1\" stroke-dasharray=\"6 5\" d=\"M"), std::string::npos);
        EXPECT_NE(text.find("<path data-index=\"1\" d=\"M"), std::string::npos);
        EXPECT_NE(text.find("class=\"knotwork-handle\""), std::string::npos);
        EXPECT_NE(text.find("<rect x="), std::string::npos);
    }
}

TEST(Svg, AClosedCurveEndsInItsStart) {
    const std::string text = svg(opened(R"({"knotwork": 1, "objects": [{"id": "c1",
        "type": "parametric-curve", "name": "circle"}]})").state(), {});
    const std::string path = attributeOf(text.substr(text.find("<path")), "d");
    EXPECT_EQ(path.back(), 'Z');
    EXPECT_EQ(path.find('L'), std::string::npos);
}

TEST(Svg, AViewInSpaceLooksFromItsAzimuthAndElevation) {
    const auto close = [](const Vec3& a, const Vec3& b) { return glm::length(a - b) < 1e-15; };
    const Orientation front = orientationFrom(0, 0);
    EXPECT_TRUE(close(front * Vec3(0, 1, 0), {1, 0, 0}));  // y to the right
    EXPECT_TRUE(close(front * Vec3(0, 0, 1), {0, 1, 0}));  // z up
    EXPECT_TRUE(close(front * Vec3(1, 0, 0), {0, 0, 1}));  // x towards the eye
    const Orientation above = orientationFrom(0.3, std::acos(0.0));
    EXPECT_TRUE(close(above * Vec3(0, 0, 1), {0, 0, 1}));
    const Orientation any = orientationFrom(usualAzimuth, usualElevation);
    EXPECT_NEAR(glm::determinant(any), 1, 1e-15);
    EXPECT_GT((any * Vec3(0, 0, 1)).y, 0.8);
}

Shape trianglesOf(const Colour& colour, std::vector<double> positions) {
    Shape shape;
    shape.role = Role::surface;
    shape.kind = Kind::triangles;
    shape.colour = colour;
    shape.positions = std::move(positions);
    return shape;
}

/// The shapes of one surface seen from above, in a picture of 10 by 10 units and pixels.
std::string solidText(std::vector<Shape> shapes) {
    const Scene scene = opened(R"({"knotwork": 1, "objects": [{"id": "s",
        "type": "parametric-surface", "name": "plane"}]})");
    Drawing drawing;
    drawing.shapes = std::move(shapes);
    const Affine screen = screenOf(planeOrientation(), {5, 5, 1}, {0, 0, 10, 10});
    XmlWriter xml(2);
    writeShapes(xml, drawing, scene.state(), {Pane::curve, screen, SvgTheme::light});
    return xml.take();
}

/// The data of all paths of surfaces.
std::vector<std::string> facetsIn(const std::string& text) {
    std::vector<std::string> found;
    constexpr std::string_view begin = " d=\"";
    for (std::size_t at = text.find("data-role=\"surface\""); at != std::string::npos;
         at = text.find("data-role=\"surface\"", at + 1)) {
        const std::size_t data = text.find(begin, at) + begin.size();
        found.push_back(text.substr(data, text.find('"', data) - data));
    }
    return found;
}

constexpr Colour blue{0, 0, 1, 1};
constexpr Colour red{1, 0, 0, 1};

TEST(Svg, WhatIsFartherAwayIsPaintedFirst) {
    const Shape near = trianglesOf(red, {0, 0, 2, 10, 0, 2, 0, 10, 2});
    const Shape far = trianglesOf(blue, {0, 0, 1, 10, 0, 1, 0, 10, 1});
    Shape line;
    line.role = Role::isoline;
    line.positions = {1, 1, 1, 2, 1, 1};
    const std::string text = solidText({near, far, line});
    const std::size_t first = text.find("#0000");
    const std::size_t grey = text.find("data-role=\"isoline\"");
    const std::size_t last = text.rfind("M0,10L0,0L10,10Z");
    EXPECT_LT(first, grey) << text;
    EXPECT_LT(grey, last) << text;
    EXPECT_NE(text.find("M1,9L2,9"), std::string::npos) << text;
}

TEST(Svg, NeighboursOfOneColourAreOnePathUnlessSomethingLiesBetweenThem) {
    const std::vector<double> low{0, 0, 1, 4, 0, 1, 0, 4, 1};
    const std::vector<double> beside{5, 5, 3, 9, 5, 3, 5, 9, 3};
    const std::vector<double> above{0, 0, 3, 4, 0, 3, 0, 4, 3};
    const auto both = [](std::vector<double> a, const std::vector<double>& b) {
        a.insert(a.end(), b.begin(), b.end());
        return trianglesOf(red, std::move(a));
    };
    const Shape between = trianglesOf(blue, {0, 0, 2, 4, 0, 2, 0, 4, 2});
    EXPECT_EQ(facetsIn(solidText({both(low, beside), between})).size(), 2U);
    EXPECT_EQ(facetsIn(solidText({both(low, above), between})).size(), 3U);
    EXPECT_EQ(facetsIn(solidText({both(low, beside), trianglesOf({0, 0, 1, 0.5}, low)})).size(), 2U);
}

TEST(Svg, TwoTrianglesOfAFlatCellAreOneFacet) {
    const auto cell = [](double height) {
        Shape shape = trianglesOf(red, {0, 0, 0, 4, 0, 0, 4, 4, height, 0, 4, 0});
        shape.indices = {0, 1, 2, 0, 2, 3};
        return shape;
    };
    EXPECT_EQ(facetsIn(solidText({cell(0)})), std::vector<std::string>{"M0,10L0,6L4,6L4,10Z"});
    EXPECT_EQ(facetsIn(solidText({cell(3)})).size(), 2U);
}

TEST(Svg, FacetsOfOnePathNeverTakeEachOthersPaintAway) {
    // Seen from above one goes round to the left and one to the right, and they overlap.
    const Shape shape = trianglesOf(red, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1, 1, 3, 1, 3, 1, 1});
    const auto paths = facetsIn(solidText({shape}));
    EXPECT_EQ(paths, std::vector<std::string>{"M0,10L0,6L4,10ZM1,9L1,7L3,9Z"});
}

}  // namespace
}  // namespace knotwork::drawing
