#include "geometry/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace knotwork {

namespace {

using Points = std::vector<Vec3>;
using Indices = std::vector<std::uint32_t>;
using Values = std::span<const double>;

// ---- Regular ones ------------------------------------------------------------------------------

constexpr std::array<std::uint32_t, 12> tetrahedronFaces{0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
constexpr std::array<std::uint32_t, 24> cubeFaces{0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                                  1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
constexpr std::array<std::uint32_t, 24> octahedronFaces{0, 2, 4, 0, 3, 5, 0, 4, 3, 0, 5, 2,
                                                        1, 2, 5, 1, 3, 4, 1, 4, 2, 1, 5, 3};
constexpr std::array<std::uint32_t, 60> icosahedronFaces{
    0, 2, 5, 0, 4, 2, 0, 5,  10, 0, 8, 4,  0, 10, 8, 1, 3, 6, 1, 6, 8, 1, 7, 3,  1, 8,  10,
    1, 10, 7, 2, 4, 9, 2, 9, 11, 2, 11, 5, 3, 7, 11, 3, 9, 6, 3, 11, 9, 4, 6, 9, 4, 8, 6,
    5, 7, 10, 5, 11, 7};
constexpr std::array<std::uint32_t, 60> dodecahedronFaces{
    0, 8, 4,  18, 16, 0, 12, 2,  10, 8,  0, 16, 1, 14, 12, 1, 9, 11, 3, 14,
    1, 16, 18, 5, 9,  2, 12, 14, 3,  17, 2, 17, 19, 6, 10, 3, 11, 7, 19, 17,
    4, 8, 10, 6,  13, 4, 13, 15, 5,  18, 5, 15, 7, 11, 9,  6, 19, 7, 15, 13};
constexpr std::array<std::uint32_t, 48> cuboctahedronFaces{
    0, 4, 2, 5, 0, 10, 1, 8, 1, 7, 3, 6, 2, 9, 3, 11, 4, 8, 6, 9, 5, 11, 7, 10,  // squares
    0, 5, 10, 0, 8, 4, 1, 6, 8, 1, 10, 7, 2, 4, 9, 2, 11, 5, 3, 7, 11, 3, 9, 6};

template <std::size_t N>
Mesh regular(Points points, const std::array<std::uint32_t, N>& corners, std::uint32_t size) {
    return Mesh::trusted(std::move(points), {corners.begin(), corners.end()}, size);
}

/// (0, ±a, ±b), (±b, 0, ±a), (±a, ±b, 0).
void addCyclic(Points& points, double a, double b) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double first : {-a, a}) {
            for (const double second : {-b, b}) {
                Vec3 p{0};
                p[(axis + 1) % 3] = first;
                p[(axis + 2) % 3] = second;
                points.push_back(p);
            }
        }
    }
}

Mesh tetrahedron(Values) {
    return regular({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, tetrahedronFaces, 3);
}

Mesh cube(Values) {
    return regular({{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                    {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, cubeFaces, 4);
}

Mesh octahedron(Values) {
    return regular({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   octahedronFaces, 3);
}

Mesh icosahedron(Values) {
    const double phi = std::numbers::phi;
    const double small = 1 / std::sqrt(1 + phi * phi);
    Points points;
    addCyclic(points, small, phi * small);
    return regular(std::move(points), icosahedronFaces, 3);
}

Mesh dodecahedron(Values) {
    const double unit = 1 / std::sqrt(3.0);
    Points points;
    for (const double x : {-unit, unit}) {
        for (const double y : {-unit, unit}) {
            for (const double z : {-unit, unit}) points.emplace_back(x, y, z);
        }
    }
    addCyclic(points, unit / std::numbers::phi, unit * std::numbers::phi);
    return regular(std::move(points), dodecahedronFaces, 5);
}

Mesh cuboctahedron(Values) {
    Points points;
    addCyclic(points, std::sqrt(0.5), std::sqrt(0.5));
    Indices starts;
    for (std::uint32_t square = 0; square < 6; ++square) starts.push_back(4 * square);
    for (std::uint32_t triangle = 0; triangle <= 8; ++triangle) starts.push_back(24 + 3 * triangle);
    return Mesh::trusted(std::move(points),
                         {cuboctahedronFaces.begin(), cuboctahedronFaces.end()},
                         std::move(starts));
}

// ---- Round ones --------------------------------------------------------------------------------

struct CircleAngle {
    double cosine;
    double sine;
};

/// Of the i-th of n equal parts of a turn.
CircleAngle angleOf(std::uint32_t i, std::uint32_t n) noexcept {
    const double angle = 2 * std::numbers::pi * i / n;
    return {std::cos(angle), std::sin(angle)};
}

std::uint32_t countOf(double value) noexcept { return static_cast<std::uint32_t>(value); }

void addQuad(Indices& corners, std::uint32_t a, std::uint32_t b, std::uint32_t c,
             std::uint32_t d) {
    corners.insert(corners.end(), {a, b, c, d});
}

/// The uniform prism: its sides are squares.
Mesh prism(Values values) {
    const std::uint32_t sides = countOf(values[0]);
    const double half = std::sin(std::numbers::pi / sides);  // of a side, on a circle of radius 1
    const double radius = 1 / std::sqrt(1 + half * half);
    Points points;
    Indices corners;
    for (const double z : {-half * radius, half * radius}) {
        for (std::uint32_t i = 0; i < sides; ++i) {
            const CircleAngle angle = angleOf(i, sides);
            points.emplace_back(radius * angle.cosine, radius * angle.sine, z);
        }
    }
    for (std::uint32_t i = 0; i < sides; ++i) corners.push_back(sides - 1 - i);
    for (std::uint32_t i = 0; i < sides; ++i) corners.push_back(sides + i);
    Indices starts{0, sides};
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
        addQuad(corners, i, next, sides + next, sides + i);
    }
    starts.push_back(static_cast<std::uint32_t>(corners.size()));
    return Mesh::trusted(std::move(points), std::move(corners), std::move(starts));
}

Mesh torus(Values values) {
    const std::uint32_t around = countOf(values[0]);
    const std::uint32_t across = countOf(values[1]);
    const double tube = values[2];
    Points points;
    Indices corners;
    for (std::uint32_t i = 0; i < around; ++i) {
        const CircleAngle u = angleOf(i, around);
        for (std::uint32_t j = 0; j < across; ++j) {
            const CircleAngle v = angleOf(j, across);
            const double distance = 1 - tube + tube * v.cosine;
            points.emplace_back(distance * u.cosine, distance * u.sine, tube * v.sine);
            const std::uint32_t next = (i + 1) % around * across;
            const std::uint32_t up = (j + 1) % across;
            addQuad(corners, i * across + j, next + j, next + up, i * across + up);
        }
    }
    return Mesh::trusted(std::move(points), std::move(corners), 4);
}

/// Rings of quads between two caps of triangles; the poles come last.
Mesh sphere(Values values) {
    const std::uint32_t around = countOf(values[0]);
    const std::uint32_t rings = countOf(values[1]) - 1;
    const std::uint32_t south = around * rings;
    Points points;
    Indices corners;
    Indices starts{0};
    const auto endFace = [&] { starts.push_back(static_cast<std::uint32_t>(corners.size())); };
    for (std::uint32_t j = 0; j < rings; ++j) {
        const double latitude = std::numbers::pi * ((j + 1.0) / (rings + 1) - 0.5);
        for (std::uint32_t i = 0; i < around; ++i) {
            const CircleAngle u = angleOf(i, around);
            const double distance = std::cos(latitude);
            points.emplace_back(distance * u.cosine, distance * u.sine, std::sin(latitude));
            const std::uint32_t at = j * around + i;
            const std::uint32_t next = j * around + (i + 1) % around;
            if (j == 0) {
                corners.insert(corners.end(), {south, next, at});
                endFace();
            }
            if (j + 1 == rings) {
                corners.insert(corners.end(), {at, next, south + 1});
            } else {
                addQuad(corners, at, next, next + around, at + around);
            }
            endFace();
        }
    }
    points.emplace_back(0, 0, -1);
    points.emplace_back(0, 0, 1);
    return Mesh::trusted(std::move(points), std::move(corners), std::move(starts));
}

Mesh grid(Values values) {
    const std::uint32_t columns = countOf(values[0]);
    const std::uint32_t rows = countOf(values[1]);
    const double corner = std::sqrt(0.5);
    Points points;
    Indices corners;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        for (std::uint32_t i = 0; i <= columns; ++i) {
            points.emplace_back(corner * (2.0 * i / columns - 1), corner * (2.0 * j / rows - 1), 0);
            if (i == columns || j == rows) continue;
            const std::uint32_t at = j * (columns + 1) + i;
            addQuad(corners, at, at + 1, at + columns + 2, at + columns + 1);
        }
    }
    return Mesh::trusted(std::move(points), std::move(corners), 4);
}

// ---- The list ----------------------------------------------------------------------------------

constexpr ParameterDescription steps(std::string_view name, std::string_view label, double least,
                                     double defaultValue, std::string_view help) {
    return {.name = name, .label = label, .min = least, .max = 1000, .defaultValue = defaultValue,
            .low = least, .high = 48, .help = help, .integer = true};
}

constexpr std::array prismParameters{
    steps("sides", "Sides", 3, 6, "How many sides the two ends have.")};
constexpr std::array torusParameters{
    steps("around", "Around", 3, 24, "How many faces there are around the axis."),
    steps("across", "Across", 3, 12, "How many faces there are around the tube."),
    ParameterDescription{.name = "tube", .label = "Tube", .min = 0.01, .max = 0.49,
                         .defaultValue = 0.3, .low = 0.1, .high = 0.45,
                         .help = "Radius of the tube; 1 is the distance of the outermost point."}};
constexpr std::array sphereParameters{
    steps("around", "Around", 3, 24, "How many faces there are around the axis."),
    steps("across", "Across", 2, 12, "How many faces there are from pole to pole.")};
constexpr std::array gridParameters{
    steps("columns", "Columns", 1, 8, "How many faces there are along x."),
    steps("rows", "Rows", 1, 8, "How many faces there are along y.")};

struct Solid {
    SolidDescription description;
    Mesh (*make)(Values values);
};

constexpr std::array table{
    Solid{{"tetrahedron", "Tetrahedron", {}}, tetrahedron},
    Solid{{"cube", "Cube", {}}, cube},
    Solid{{"octahedron", "Octahedron", {}}, octahedron},
    Solid{{"dodecahedron", "Dodecahedron", {}}, dodecahedron},
    Solid{{"icosahedron", "Icosahedron", {}}, icosahedron},
    Solid{{"cuboctahedron", "Cuboctahedron", {}}, cuboctahedron},
    Solid{{"prism", "Prism", prismParameters}, prism},
    Solid{{"torus", "Torus", torusParameters}, torus},
    Solid{{"sphere", "Sphere", sphereParameters}, sphere},
    Solid{{"grid", "Grid", gridParameters}, grid},
};

template <std::size_t... I>
constexpr std::array<SolidDescription, sizeof...(I)> descriptionsOf(std::index_sequence<I...>) {
    return {table[I].description...};
}

constexpr auto descriptions = descriptionsOf(std::make_index_sequence<table.size()>{});

const Solid* find(std::string_view name) noexcept {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Solid& solid) {
        return solid.description.name == name;
    });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::span<const SolidDescription> solids() noexcept { return descriptions; }

const SolidDescription* findSolid(std::string_view name) noexcept {
    const Solid* found = find(name);
    return found == nullptr ? nullptr : &found->description;
}

Result<Mesh> makeSolid(std::string_view name, std::span<const NamedValue> parameters) {
    const Solid* solid = find(name);
    if (solid == nullptr) {
        std::string known;
        for (const Solid& one : table) {
            known += (known.empty() ? "" : ", ") + std::string(one.description.name);
        }
        return refuse(Code::unknownName, "solid",
                      "There is no solid \"" + std::string(name) + "\"; there are " + known + ".");
    }
    const auto values = readParameters(solid->description.parameters, parameters, "parameters");
    if (!values) return values.error();
    return solid->make(*values);
}

}  // namespace knotwork
