// The renderer on a device that draws nothing and counts everything.
#include "render/renderer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

namespace knotwork::render {
namespace gl {
namespace {

/// What the device was told; GL is a thing of the whole process, so this is too.
struct Log {
    unsigned names = 0;
    int destroyed = 0;
    std::vector<Rect> areas;
    std::vector<Rect> draws;
    std::vector<scene::Colour> clears;
    std::string refusal;
    std::vector<std::string> steps;    ///< of the painting of a deep pane
    std::vector<std::size_t> vertices; ///< bytes of surfaces that were sent
    std::vector<std::size_t> corners;  ///< of triangles that were sent
    int targets = 0;
};

Log& log() {
    static Log told;
    return told;
}

}  // namespace

void ProgramTraits::destroy(unsigned) noexcept { log().destroyed += 1; }
void BufferTraits::destroy(unsigned) noexcept { log().destroyed += 1; }
void VertexArrayTraits::destroy(unsigned) noexcept { log().destroyed += 1; }
void TextureTraits::destroy(unsigned) noexcept { log().destroyed += 1; }
void FramebufferTraits::destroy(unsigned) noexcept { log().destroyed += 1; }
void RenderbufferTraits::destroy(unsigned) noexcept { log().destroyed += 1; }

Result<Pipeline> Device::makePipeline(std::string_view, std::string_view, const Layout& layout) {
    if (!log().refusal.empty()) return refuse(Code::notSupported, "", log().refusal);
    Pipeline made;
    made.program = Handle<ProgramTraits>(++log().names, counts_);
    made.records = makeRecords();
    made.layout = layout;
    return made;
}

Records Device::makeRecords() {
    Records made;
    made.texture = Handle<TextureTraits>(++log().names, counts_);
    return made;
}

Result<SurfacePipeline> Device::makeSurfacePipeline(std::string_view, std::string_view) {
    SurfacePipeline made;
    made.program = Handle<ProgramTraits>(++log().names, counts_);
    return made;
}

SurfaceBuffers Device::makeSurfaceBuffers(const SurfaceLayout&) {
    SurfaceBuffers made;
    made.vertices = Handle<BufferTraits>(++log().names, counts_);
    made.indices = Handle<BufferTraits>(++log().names, counts_);
    made.vertexArray = Handle<VertexArrayTraits>(++log().names, counts_);
    return made;
}

void Device::sendVertices(SurfaceBuffers& buffers, std::span<const std::byte> records) noexcept {
    buffers.vertexBytes = records.size();
    log().vertices.push_back(records.size());
}

void Device::sendTriangles(SurfaceBuffers& buffers,
                           std::span<const std::uint32_t> indices) noexcept {
    buffers.corners = indices.size();
    log().corners.push_back(indices.size());
}

bool Device::beginTarget(Target& target, int width, int height) noexcept {
    if (width > target.width || height > target.height) {
        log().targets += 1;
        target.framebuffer = Handle<FramebufferTraits>(++log().names, counts_);
        target.width = std::max(width, target.width);
        target.height = std::max(height, target.height);
    }
    log().steps.emplace_back("begin");
    return true;
}

void Device::endTarget(const Target&, const Rect&) noexcept { log().steps.emplace_back("end"); }
void Device::clearDepth() noexcept {}

void Device::setDepth(Depth depth) noexcept {
    constexpr std::array names{"ignored", "written", "writtenOnly", "masked", "nearer", "farther"};
    log().steps.emplace_back(names[static_cast<std::size_t>(depth)]);
}

void Device::prepare() noexcept {}
void Device::setArea(const Rect& area) noexcept { log().areas.push_back(area); }
void Device::clear(const scene::Colour& colour) noexcept { log().clears.push_back(colour); }

void Device::send(const Pipeline& pipeline, Records& records,
                  std::span<const std::byte> bytes) noexcept {
    records.bytes = bytes.size();
    records.count = bytes.size() / pipeline.layout.stride;
}

void Device::draw(const Pipeline&, const Records&, const Rect& pane, const Pass&) noexcept {
    log().draws.push_back(pane);
    log().steps.emplace_back("draw");
}

void Device::draw(const SurfacePipeline&, const SurfaceBuffers&, const SurfaceView&, std::size_t,
                  std::size_t) noexcept {
    log().steps.emplace_back("surface");
}

void Device::release() noexcept {}

}  // namespace gl

namespace {

constexpr Rect left{0, 0, 100, 100};
constexpr Rect right{100, 0, 100, 100};
const std::vector<double> zigzag{-10, 0, 0, 0, 10, 0, 10, 0, 0};

class RendererTest : public testing::Test {
protected:
    RendererTest() { gl::log() = {}; }

    void frame() {
        renderer.beginView(200, 100, {1, 1, 1, 1});
        for (const Rect& pane : {left, right}) {
            renderer.beginPane(pane, Projection::flat(pane, Vec3(0.0), 1, 1), 1);
            renderer.polyline(zigzag, {{}, 2});
            renderer.polyline(zigzag, {{}, 3});
            renderer.points(zigzag, {});
            renderer.endPane();
        }
        renderer.endView();
    }

    Renderer renderer;
};

TEST_F(RendererTest, FourProgramsAndThreeListsAreSevenObjects) {
    ASSERT_TRUE(renderer.start());
    EXPECT_EQ(renderer.stats().live, (gl::Counts{4, 0, 0, 3, 0, 0}));
}

TEST_F(RendererTest, NeighbouringLinesAreOneDraw) {
    ASSERT_TRUE(renderer.start());
    frame();
    EXPECT_EQ(renderer.stats().drawCalls, 4);
    EXPECT_EQ(renderer.stats().vertices, 2U * (5 + 5 + 3));
}

TEST_F(RendererTest, EachPaneDrawsWithItsOwnProjection) {
    ASSERT_TRUE(renderer.start());
    frame();
    EXPECT_EQ(gl::log().draws, (std::vector<Rect>{left, left, right, right}));
}

TEST_F(RendererTest, PaintingOrderIsKeptAcrossKinds) {
    ASSERT_TRUE(renderer.start());
    renderer.beginView(100, 100, {});
    renderer.beginPane(left, Projection::flat(left, Vec3(0.0), 1, 1), 1);
    renderer.polyline(zigzag, {});
    renderer.triangles(zigzag, {});
    renderer.polyline(zigzag, {});
    renderer.endPane();
    EXPECT_EQ(renderer.stats().drawCalls, 3);
}

TEST_F(RendererTest, FramesDoNotAddUp) {
    ASSERT_TRUE(renderer.start());
    frame();
    const Stats first = renderer.stats();
    for (int i = 0; i < 100; ++i) frame();
    EXPECT_EQ(renderer.stats().live, first.live);
    EXPECT_EQ(renderer.stats().bufferBytes, first.bufferBytes);
    EXPECT_EQ(renderer.stats().vertices, first.vertices);
}

TEST_F(RendererTest, AfterALostContextNothingIsDeletedAndNothingIsDrawn) {
    ASSERT_TRUE(renderer.start());
    renderer.forget();
    EXPECT_EQ(renderer.stats().live.total(), 0);
    frame();
    EXPECT_TRUE(gl::log().draws.empty());
    EXPECT_EQ(gl::log().destroyed, 0);
}

TEST_F(RendererTest, AfterARestoredContextItDrawsAgain) {
    ASSERT_TRUE(renderer.start());
    renderer.forget();
    ASSERT_TRUE(renderer.start());
    frame();
    EXPECT_EQ(renderer.stats().live.total(), 7);
    EXPECT_EQ(renderer.stats().drawCalls, 4);
}

TEST_F(RendererTest, StartingTwiceLeavesNoObjectsBehind) {
    ASSERT_TRUE(renderer.start());
    ASSERT_TRUE(renderer.start());
    EXPECT_EQ(renderer.stats().live.total(), 7);
    EXPECT_EQ(gl::log().destroyed, 7);
}

TEST_F(RendererTest, ADriverThatRefusesIsReportedInItsWords) {
    gl::log().refusal = "no such extension";
    EXPECT_FALSE(renderer.start());
    EXPECT_NE(renderer.message().find("no such extension"), std::string::npos);
    frame();
    EXPECT_TRUE(gl::log().draws.empty());
}

TEST_F(RendererTest, ShapesArePaintedByTheirKind) {
    ASSERT_TRUE(renderer.start());
    renderer.beginView(100, 100, {});
    renderer.beginPane(left, Projection::flat(left, Vec3(0.0), 1, 1), 1, scene::Colour{0, 0, 0, 1});
    drawing::Shape shape;
    shape.positions = zigzag;
    for (const auto kind : {drawing::Kind::polyline, drawing::Kind::points,
                            drawing::Kind::triangles, drawing::Kind::label}) {
        shape.kind = kind;
        renderer.paint(shape);
    }
    renderer.endPane();
    EXPECT_EQ(renderer.stats().drawCalls, 3);
    EXPECT_EQ(renderer.stats().vertices, 5U + 3 + 3);
    EXPECT_EQ(gl::log().clears.size(), 2U);
}

TEST_F(RendererTest, DestroyingTheRendererFreesEverything) {
    {
        Renderer shortLived;
        ASSERT_TRUE(shortLived.start());
    }
    EXPECT_EQ(gl::log().destroyed, 7);
}

class SpaceTest : public RendererTest {
protected:
    SpaceTest() {
        EXPECT_TRUE(renderer.start());
        surface.kind = drawing::Kind::triangles;
        surface.role = drawing::Role::surface;
        surface.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        surface.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
        surface.indices = {0, 1, 2};
        surface.identity = fresh();
        line.positions = zigzag;
    }

    static std::shared_ptr<const void> fresh() { return std::make_shared<const int>(0); }

    void spaceFrame(const std::vector<const drawing::Shape*>& shapes, double unitsPerPixel = 1) {
        gl::log().steps.clear();
        renderer.beginView(100, 100, {1, 1, 1, 1});
        renderer.beginPane(
            left, Projection::parallel(left, Vec3(0.0), Mat3(1.0), unitsPerPixel, 100), 1,
            scene::Colour{1, 1, 1, 1});
        for (const drawing::Shape* shape : shapes) renderer.paint(*shape);
        renderer.endPane();
        renderer.endView();
    }

    drawing::Shape surface;
    drawing::Shape line;
};

TEST_F(SpaceTest, ASurfaceThatStaysIsSentOnce) {
    for (int i = 0; i < 5; ++i) spaceFrame({&surface});
    EXPECT_EQ(gl::log().vertices, (std::vector<std::size_t>{3 * sizeof(SurfaceVertex)}));
    EXPECT_EQ(gl::log().corners, (std::vector<std::size_t>{3}));
    EXPECT_EQ(gl::log().targets, 1);
}

TEST_F(SpaceTest, OfASurfaceThatIsDraggedTheVerticesAloneAreSent) {
    spaceFrame({&surface});
    const gl::Counts live = renderer.stats().live;
    for (int i = 0; i < 4; ++i) {
        surface.positions[2] += 1;
        surface.identity = fresh();
        spaceFrame({&surface});
    }
    EXPECT_EQ(gl::log().vertices.size(), 5U);
    EXPECT_EQ(gl::log().corners.size(), 1U);
    EXPECT_EQ(renderer.stats().live, live);
}

TEST_F(SpaceTest, OtherTrianglesAreSentAlsoWhereTheirNumberIsTheSame) {
    spaceFrame({&surface});
    surface.indices = {1, 2, 0};
    surface.identity = fresh();
    spaceFrame({&surface});
    EXPECT_EQ(gl::log().corners.size(), 2U);
}

TEST_F(SpaceTest, TheBuffersOfASurfaceThatIsGoneAreFreed) {
    spaceFrame({});
    const gl::Counts before = renderer.stats().live;
    spaceFrame({&surface});
    EXPECT_EQ(renderer.stats().live.buffers, before.buffers + 2);
    surface.identity.reset();
    spaceFrame({});
    EXPECT_EQ(renderer.stats().live, before);
}

TEST_F(SpaceTest, TwoSurfacesOfOneViewKeepTheirOwnBuffers) {
    drawing::Shape other = surface;
    other.identity = fresh();
    spaceFrame({&surface, &other});
    spaceFrame({&other, &surface});
    EXPECT_EQ(gl::log().vertices.size(), 2U);
}

TEST_F(SpaceTest, ASurfaceIsSentAgainWhenTheViewIsSoNearThatItsRoundingWouldBeSeen) {
    for (double& p : surface.positions) p += 1e6;
    spaceFrame({&surface});
    spaceFrame({&surface}, 1e-8);
    spaceFrame({&surface}, 1e-8);
    EXPECT_EQ(gl::log().vertices.size(), 2U);
    EXPECT_EQ(gl::log().corners.size(), 1U);
}

TEST_F(SpaceTest, AfterALostContextSurfacesAreSentAgain) {
    spaceFrame({&surface});
    renderer.forget();
    EXPECT_EQ(renderer.stats().live.total(), 0);
    spaceFrame({&surface});
    ASSERT_TRUE(renderer.start());
    spaceFrame({&surface});
    EXPECT_EQ(gl::log().vertices.size(), 2U);
    EXPECT_EQ(gl::log().destroyed, 0);
}

TEST_F(SpaceTest, WhatIsHiddenIsPaintedFaintlyAndThenWhatIsSeen) {
    spaceFrame({&line, &surface});
    EXPECT_EQ(gl::log().steps,
              (std::vector<std::string>{"begin", "written", "surface", "farther", "draw", "masked",
                                        "draw", "nearer", "draw", "ignored", "end"}));
}

TEST_F(SpaceTest, LinesOnASurfaceVanishBehindIt) {
    line.role = drawing::Role::isoline;
    spaceFrame({&surface, &line});
    EXPECT_EQ(gl::log().steps,
              (std::vector<std::string>{"begin", "written", "surface", "farther", "masked",
                                        "nearer", "draw", "ignored", "end"}));
}

TEST_F(SpaceTest, ThroughATransparentSurfaceLinesAreSeenAndBeforeItTheyAreWhole) {
    line.role = drawing::Role::isoline;
    surface.colour.alpha = 0.5;
    spaceFrame({&surface, &line});
    EXPECT_EQ(gl::log().steps,
              (std::vector<std::string>{"begin", "written", "farther", "nearer", "draw", "nearer",
                                        "surface", "writtenOnly", "surface", "masked", "nearer",
                                        "draw", "ignored", "end"}));
    spaceFrame({&surface, &line});
    EXPECT_EQ(gl::log().corners.size(), 1U);  // still in order for this eye
}

TEST_F(SpaceTest, AFlatPaneShowsNoLitSurface) {
    renderer.beginView(100, 100, {});
    renderer.beginPane(left, Projection::flat(left, Vec3(0.0), 1, 1), 1);
    renderer.paint(surface);
    renderer.endPane();
    EXPECT_EQ(renderer.stats().drawCalls, 0);
}

}  // namespace
}  // namespace knotwork::render
