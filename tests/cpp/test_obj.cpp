#include "scene/obj.hpp"

#include "geometry/solids.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace knotwork::scene {
namespace {

void expectSame(const Mesh& a, const Mesh& b) {
    ASSERT_TRUE(std::equal(a.points().begin(), a.points().end(), b.points().begin(),
                           b.points().end()));
    ASSERT_TRUE(std::equal(a.corners().begin(), a.corners().end(), b.corners().begin(),
                           b.corners().end()));
    ASSERT_EQ(a.faces().count(), b.faces().count());
    for (std::size_t f = 0; f < a.faces().count(); ++f) {
        ASSERT_EQ(a.faces()[f].size(), b.faces()[f].size());
    }
}

Mesh read(const std::string& text) {
    auto mesh = readObj(text);
    EXPECT_TRUE(mesh.ok()) << mesh.error().path << ": " << mesh.error().message;
    return *mesh;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsVerticesAndFacesOfAnySize) {
    const Mesh mesh = read(square + "v 2 0.5 -1.25e0\nf 1 2 3 4\nf 3 2 5\n");
    EXPECT_EQ(mesh.points()[4], Vec3(2, 0.5, -1.25));
    EXPECT_EQ(mesh.counts(), (MeshCounts{5, 6, 2, 5}));
    EXPECT_EQ(mesh.faces()[1][2], 4U);
}

TEST(Obj, ReadsCornersWithTexturesAndNormals) {
    const Mesh expected = read(square + "f 1 2 3 4\n");
    expectSame(read(square + "f 1/1 2/2 3/3 4/4\n"), expected);
    expectSame(read(square + "f 1//9 2//9 3//-9 4//9\n"), expected);
    expectSame(read(square + "f 1/5/9 2/6/9 3/7/9 4/8/9"), expected);
}

TEST(Obj, CountsNegativeIndicesBackFromTheLastVertex) {
    const Mesh expected = read(square + "f 1 2 3 4\n");
    expectSame(read(square + "f -4 -3 -2 -1\n"), expected);
    const Mesh later = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -4/-1 -2//-1 -1\n");
    EXPECT_EQ(later.faces()[0][0], 0U);
    EXPECT_EQ(later.faces()[1][0], 0U);
    EXPECT_EQ(later.faces()[1][2], 3U);
}

TEST(Obj, PassesOverWhatIsNeitherVertexNorFace) {
    const std::string full =
        "\xEF\xBB\xBF# by hand\r\nmtllib a.mtl\r\no thing\r\n\r\nv 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 1"
        " # coloured\r\n  v\t1 1 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\ng left right\r\ns off\r\n"
        "usemtl stone\r\nf 1 2 \\\r\n 3\\\r\n 4#end\r\nl 1 2\r\np 1\r\n";
    expectSame(read(full), read(square + "f 1 2 3 4\n"));
}

TEST(Obj, AVertexMayComeAfterTheFacesThatNameIt) {
    expectSame(read("f 1 2 3 4\n" + square), read(square + "f 1 2 3 4\n"));
}

TEST(Obj, ReadsNumbersInAllTheirForms) {
    const std::vector<std::string> numbers{"0",    "-0",    "+1",   "1.",   ".5",
                                           "1e-2", "1E-22", "1e+5", "-2.5", "012.5",
                                           "1234567890.0987654321"};
    std::string text;
    for (const std::string& number : numbers) text += "v " + number + " 0 0\n";
    const Mesh mesh = read(text + "f 1 2 3\n");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double expected = std::strtod(numbers[i].c_str(), nullptr);
        EXPECT_EQ(mesh.points()[i].x, expected) << numbers[i];
        EXPECT_EQ(std::signbit(mesh.points()[i].x), std::signbit(expected)) << numbers[i];
    }
}

TEST(Obj, WhatIsWrittenReadsBackExactly) {
    for (const SolidDescription& description : solids()) {
        const Mesh mesh = *makeSolid(description.name);
        expectSame(read(writeObj(mesh)), mesh);
    }
    expectSame(read(writeObj(test::scannedMesh(40, 5, 1))), test::scannedMesh(40, 5, 1));
    const Mesh odd = *test::meshOf({{1e-300, -1e12, 4.9406564584124654e-324},
                                    {0.1, 1.0 / 3, -2.0 / 3},
                                    {-0.0, 123456789.123456789, 5e-5}},
                                   {{2, 0, 1}});
    expectSame(read(writeObj(odd)), odd);
    EXPECT_TRUE(std::signbit(read(writeObj(odd)).points()[2].x));
}

TEST(Obj, IsWrittenWithTheFewestDigits) {
    const Mesh mesh = *test::meshOf({{0.1, 2, -0.25}, {1, 0, 0}, {0, 1e-7, 0}}, {{0, 1, 2}});
    EXPECT_EQ(writeObj(mesh), "v 0.1 2.0 -0.25\nv 1.0 0.0 0.0\nv 0.0 1e-07 0.0\nf 1 2 3\n");
}

void expectRefusal(const std::string& text, Code code, const std::string& path,
                   const std::string& words) {
    const auto made = readObj(text);
    ASSERT_FALSE(made.ok()) << text;
    EXPECT_EQ(codeName(made.error().code), codeName(code)) << text;
    EXPECT_EQ(made.error().path, path) << text;
    EXPECT_NE(made.error().message.find(words), std::string::npos) << made.error().message;
}

TEST(ObjRefusals, SayTheLine) {
    const auto syntax = [](const std::string& text, const std::string& words) {
        expectRefusal(text, Code::syntax, "obj", words);
    };
    syntax("<!doctype html>\n", "Line 1: \"<!doctype\" is no word of OBJ");
    syntax("v 0 0\n", "Line 1: the vertex has 2 coordinates and needs 3");
    syntax("\n# nothing\nv 0 zero 0\n", "Line 3: \"zero\" is no number");
    syntax("v 1 2 3e\n", "\"3e\" is no number");
    for (const std::string number : {"nan", "inf", "0x10", "1,5", "1.2.3", "-", "+.", ".", "1e",
                                     "e5", "1e5.", "--1", "1f"}) {
        syntax("v 0 0 " + number + "\n", "is no number");
    }
    for (const std::string corner :
         {"1/", "1//", "/1", "1/2/", "1/2/3/4", "a", "1.5", "1/x", "//", "+"}) {
        syntax(square + "f 1 2 " + corner + "\n", "Line 5: \"" + corner + "\" names no vertex");
    }
    syntax(square + "f 1 2 \\\n3 \\\nx\n", "Line 7: \"x\"");
    syntax("v 0 0 0\rv 1 0 0\rw\r", "Line 3: \"w\"");
    syntax("g left \\\n middle \\\n right\nv 0 x 0\n", "Line 4: \"x\"");
    syntax("# drawn on c:\\\nv 0 x 0\n", "Line 2: \"x\"");
    syntax(std::string(100, 'x'), "…\" is no word");
    syntax(std::string("\0\1\2", 3), "Line 1");
}

TEST(ObjRefusals, NameVerticesThatThereAreNot) {
    const auto outOfRange = [](const std::string& text, const std::string& words) {
        expectRefusal(text, Code::outOfRange, "obj", words);
    };
    outOfRange(square + "f 1 2 5\n", "Line 5: there is no vertex 5; there are 4");
    outOfRange("f 1 2 7\n" + square, "Line 1: there is no vertex 7; there are 4");
    outOfRange(square + "f 1 2 0\n", "Line 5: there is no vertex 0");
    outOfRange(square + "f 1 2 -5\n", "Line 5: there is no vertex -5");
    outOfRange(square + "f 1 2 99999999999999999999\n", "Line 5: there is no vertex");
}

TEST(ObjRefusals, AreThoseOfTheMeshOtherwise) {
    expectRefusal(square + "f 1 2\n", Code::wrongLength, "faces[0]", "Line 5: the face has 2");
    expectRefusal(square + "f 1 2 3\nf\n", Code::wrongLength, "faces[1]", "Line 6: the face has 0");
    expectRefusal(square + "f 1 2 2\n", Code::outOfRange, "faces[0]", "comes twice");
    expectRefusal(square + "f 1 2 3\nf 2 3 4\n", Code::notManifold, "edges[1,2]", "turn one");
    expectRefusal("v 0 0 1e999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", Code::notFinite, "vertices[0]", "");
    expectRefusal("", Code::wrongLength, "vertices", "0 vertices");
    expectRefusal(square, Code::wrongLength, "faces", "0 faces");
}

TEST(ObjRefusals, StopAtTooManyVertices) {
    std::string text;
    for (std::size_t i = 0; i <= maxMeshVertices; ++i) text += "v 0 0 0\n";
    expectRefusal(text, Code::tooLarge, "obj", "Line 4000001");
}

}  // namespace
}  // namespace knotwork::scene
