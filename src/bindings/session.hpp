// What one load() holds: B-functions, curves, surfaces, meshes and scenes behind integer handles,
// and the border's two buffers. Only numbers, strings and addresses cross, so nothing here can
// throw or be coerced.
//
// Conventions. Input crosses as CBOR: the facade asks for room(bytes), writes there and passes the
// number of bytes. A refused call answers 0, false, -1 or "" (whatever cannot be an answer) and
// leaves its reason in error(). Handles are not zero and are checked by every function. Small
// results are left in block(), lists of any length in bulk(), both until the next call; addresses
// are bytes from the start of memory. Texts are JSON.
#pragma once

#include "bindings/marshal_lists.hpp"
#include "bindings/queries.hpp"
#include "drawing/drawing_cache.hpp"
#include "drawing/exports.hpp"
#include "geometry/arc_length.hpp"
#include "geometry/b_function.hpp"
#include "geometry/curve.hpp"
#include "geometry/curve_subdivision.hpp"
#include "geometry/fitting.hpp"
#include "geometry/mesh.hpp"
#include "geometry/surface_grid.hpp"
#include "scene/scene.hpp"
#include "scene/specs.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace knotwork::bindings {

/// The facade asks for samples in blocks of so many points, which fit the first cache.
inline constexpr std::size_t blockPoints = 1024;

/// How many numbers of the block tell what kind of curve was made.
inline constexpr std::size_t curveTraits = 5;
/// The same of a surface.
inline constexpr std::size_t surfaceTraits = 7;

class Session {
public:
    using Address = std::uintptr_t;

    // The border.
    /// Why the last refused call was refused: { code, path, message }.
    [[nodiscard]] std::string error() const;
    /// Where to write up to `bytes` bytes of input of the next call; good until more are asked for.
    [[nodiscard]] Address room(unsigned bytes);
    /// Where the numbers of a small result stand; 3 · 1024 of them.
    [[nodiscard]] Address block() const;
    /// Where to write up to 1024 parameters for curveAt().
    [[nodiscard]] Address parameters() const;
    /// Where the 1024 integers of curveBasisAt() stand.
    [[nodiscard]] Address integers() const;
    /// Where the numbers of a list stand; dropBulk() gives their memory back.
    [[nodiscard]] Address bulk() const;
    void dropBulk();
    /// Forgets a value; an unknown handle is ignored.
    void release(int handle);
    /// The CBOR of the last input as JSON text, word for word.
    [[nodiscard]] std::string inputText(unsigned bytes);
    /// How many values are held.
    [[nodiscard]] int held() const { return held_; }

    // B-functions.
    [[nodiscard]] int bFunction(unsigned bytes);
    [[nodiscard]] std::string bFunctionSpec(int handle);
    /// block: the order at 0 and at 1, and then 1 for symmetric and 1 for smooth, else 0.
    [[nodiscard]] bool bFunctionTraits(int handle);
    /// Where its smoothness ends, or "".
    [[nodiscard]] std::string bFunctionWarning(int handle);
    /// block: B(t), B'(t), … B^(n)(t).
    [[nodiscard]] bool bFunctionDerivatives(int handle, double t, int n);
    /// block: `count` ≤ 1024 values, the first at `first` of `total` uniform ones.
    [[nodiscard]] bool bFunctionSample(int handle, unsigned first, unsigned count, unsigned total);
    [[nodiscard]] std::string bFunctions() const;

    // Questions by name, as the tables of queries.hpp have them; the name is never the user's. The
    // input is the object of the arguments; the answer is JSON, "" for a refusal.
    [[nodiscard]] std::string askCurve(const std::string& name, int handle, unsigned bytes);
    [[nodiscard]] std::string askSurface(const std::string& name, int handle, unsigned bytes);
    [[nodiscard]] std::string ask(const std::string& name, unsigned bytes);

    // Curves of every kind. What makes one also leaves in block: start and end of its domain, 1
    // where it is closed, its dimension, and its kind's place in Curve::Kind.
    [[nodiscard]] int curve(unsigned bytes);
    [[nodiscard]] std::string curveSpec(int handle);
    /// block: x, y, z.
    [[nodiscard]] bool curvePoint(int handle, double t);
    /// block: n+1 rows of x, y, z. `side` is -1 for the left, 1 for the right, and 0 for the right
    /// but the left at the end of the domain.
    [[nodiscard]] bool curveDerivatives(int handle, double t, int n, int side);
    /// block: `count` ≤ 1024 points, the first at `first` of `total` uniform ones.
    [[nodiscard]] bool curveSample(int handle, unsigned first, unsigned count, unsigned total);
    /// block: at the first `count` of parameters() all points, then all first derivatives, …;
    /// count · (derivatives + 1) ≤ 1024. A refusal names `ts[first + i]`.
    [[nodiscard]] bool curveAt(int handle, unsigned first, unsigned count, int derivatives);
    /// bulk: m points and then their m parameters. Answers m, or -1.
    [[nodiscard]] int curvePolyline(int handle, double tolerance);
    [[nodiscard]] std::string parametricCurves() const;

    // What is measured on curves of every kind. NaN stands for an end that is not given.
    /// block: point, tangent, normal and binormal, curvature, torsion; `side` as for derivatives.
    [[nodiscard]] bool curveFrame(int handle, double t, int side);
    /// block: t, x, y, z, distance of the point nearest to a place.
    [[nodiscard]] bool curveClosestPoint(int handle, double x, double y, double z);
    /// block: x, y, z of the centre and the radius of the smallest sphere around the curve.
    [[nodiscard]] bool curveSphere(int handle);
    /// block: the length from a to b.
    [[nodiscard]] bool curveLength(int handle, double a, double b);
    /// block: the parameter at the length s.
    [[nodiscard]] bool curveParameterAtLength(int handle, double s);

    // B-spline and blending curves; of any other kind NOT_SUPPORTED.
    /// bulk: the knots. Answers their number, or -1.
    [[nodiscard]] int curveKnots(int handle);
    [[nodiscard]] int curveGrevilles(int handle);
    /// bulk: x, y, z of the control points. Answers how many, or -1.
    [[nodiscard]] int curveControlPoints(int handle);
    [[nodiscard]] int curveInsertKnot(int handle, double t, int times);
    /// The input is the full refined vector, `count` doubles as they stand in memory.
    [[nodiscard]] int curveRefine(int handle, unsigned count, bool byBoehm);
    /// bulk: derivatives+1 rows of n numbers. Answers n, or -1.
    [[nodiscard]] int curveBasis(int handle, double t, int derivatives);
    /// block: the d+1 functions that are not zero at each of the first `count` of parameters(),
    /// count · (d+1) ≤ 3072; at integers(): the point of the first of them. Answers d+1, or 0 and a
    /// refusal that names `ts[first + i]`.
    [[nodiscard]] int curveBasisAt(int handle, unsigned first, unsigned count);
    /// bulk: the weights of the n local curves. Answers n, or -1.
    [[nodiscard]] int curveBlendBasis(int handle, double t);
    [[nodiscard]] int curveWithPose(int handle, int local, unsigned bytes);
    [[nodiscard]] int curveLocal(int handle, int local);
    /// The input is { knots, recut }.
    [[nodiscard]] int curveWithKnots(int handle, unsigned bytes);

    // Surfaces of every kind. What makes one also leaves in block: start and end of its domain along
    // u and along v, 1 in each direction where it is closed, and its kind's place in Surface::Kind.
    [[nodiscard]] int surface(unsigned bytes);
    [[nodiscard]] std::string surfaceSpec(int handle);
    /// block: x, y, z.
    [[nodiscard]] bool surfacePoint(int handle, double u, double v);
    /// block: S, Su, Sv, Suu, Suv, Svv.
    [[nodiscard]] bool surfaceDerivatives(int handle, double u, double v);
    /// block: the unit normal, or three zeros where there is none.
    [[nodiscard]] bool surfaceNormal(int handle, double u, double v);
    /// block: Gaussian and mean curvature, and the larger and the smaller principal one.
    [[nodiscard]] bool surfaceCurvatures(int handle, double u, double v);
    /// block and normals(): points first … first+count−1 of a grid of nu × nv ones and their unit
    /// normals, count ≤ 1024. What the grid is made of is kept until another one is asked for.
    [[nodiscard]] bool surfaceGrid(int handle, unsigned nu, unsigned nv, unsigned first,
                                   unsigned count);
    /// Where the normals of surfaceGrid() stand; 3 · 1024 numbers.
    [[nodiscard]] Address normals() const;
    /// Of a blending surface; the input is a pose.
    [[nodiscard]] int surfaceWithPose(int handle, int i, int j, unsigned bytes);
    /// bulk: n positions, n normals and n pairs of parameters; bulkIndices(): m indices. Answers
    /// { vertices: n, indices: m }, or "".
    [[nodiscard]] std::string surfaceTriangles(int handle, double tolerance);
    /// bulk: points of the isoline at a constant v (or u): `count` uniform ones, or as many as the
    /// tolerance asks for where count is 0. Answers how many, or -1.
    [[nodiscard]] int surfaceIsoline(int handle, bool alongU, double at, unsigned count,
                                     double tolerance);
    [[nodiscard]] std::string parametricSurfaces() const;

    // Subdivision of polygons. It begins with all but the last levels, which are made block by block.
    /// Answers how many points the final polygon has, or -1.
    [[nodiscard]] int subdivision(unsigned bytes);
    /// block: `count` ≤ 1024 points of it, the first at `first`, which is even.
    [[nodiscard]] bool subdivisionPoints(unsigned first, unsigned count);
    void dropSubdivision();

    // Points. A fit leaves in block, after the traits of its curve: sum of squares, root of the
    // mean square and largest of the residuals, and how many parameters were found (none where
    // they were given); bulk: those.
    [[nodiscard]] int fit(unsigned bytes);
    [[nodiscard]] int interpolate(unsigned bytes);
    /// block: centre and radius.
    [[nodiscard]] bool enclosingSphere(unsigned bytes);

    // Meshes. Large ones come in through rooms of their own, which a mesh then takes over.
    /// block: the addresses of the points, of the starts of the faces (one more than faces) and of
    /// their corners, all to be written. TOO_LARGE for more than there may be.
    [[nodiscard]] bool meshRoom(unsigned vertices, unsigned faces, unsigned corners);
    [[nodiscard]] int meshFromRoom();
    /// Where to write a text of so many bytes.
    [[nodiscard]] Address textRoom(unsigned bytes);
    /// Of the text, which is OBJ.
    [[nodiscard]] int meshFromText();
    /// Of a specification, which is short.
    [[nodiscard]] int mesh(unsigned bytes);
    /// The specification of a mesh that was made of one, else `null`.
    [[nodiscard]] std::string meshSpec(int handle);
    /// block: how many vertices, faces and corners; the size of every face or 0; the addresses of
    /// the points, of the corners and, where sizes differ, of the starts, good while it is held.
    [[nodiscard]] bool meshParts(int handle);
    /// block: how many vertices, edges, faces and boundary edges; the address of the edges.
    [[nodiscard]] bool meshCounts(int handle);
    /// bulk: a normal for every vertex. Answers how many, or -1.
    [[nodiscard]] int meshNormals(int handle);
    /// bulkIndices: three a triangle. Answers how many triangles, or -1.
    [[nodiscard]] int meshTriangles(int handle);
    [[nodiscard]] Address bulkIndices() const;
    [[nodiscard]] int meshTriangulated(int handle);
    [[nodiscard]] std::string meshObj(int handle);
    /// The mesh with those of { creases }.
    [[nodiscard]] int meshCreased(int handle, unsigned bytes);
    /// [{ edge, sharpness }]
    [[nodiscard]] std::string meshCreases(int handle);
    /// `scheme` is the place of one in MeshScheme.
    [[nodiscard]] int meshSubdivided(int handle, int scheme, int levels);
    /// bulk: all positions, then all normals. Answers how many vertices, or -1.
    [[nodiscard]] int meshLimit(int handle, int scheme);
    /// { approximating, regular, extraordinary, mesh }
    [[nodiscard]] std::string meshClassification(int scheme) const;
    [[nodiscard]] std::string solids() const;

    // Scenes.
    [[nodiscard]] int openScene(unsigned bytes);
    /// The scene itself, for a view that shows it; null for an unknown handle.
    [[nodiscard]] std::shared_ptr<scene::Scene> scene(int handle) const;
    [[nodiscard]] std::string sceneDocument(int handle);
    [[nodiscard]] std::string sceneSchema(int handle);
    /// { command, path }
    [[nodiscard]] std::string sceneExecute(int handle, unsigned bytes);
    /// 1 done, 0 nothing there to take back, -1 refused.
    [[nodiscard]] int sceneUndo(int handle);
    [[nodiscard]] int sceneRedo(int handle);
    [[nodiscard]] bool sceneCanUndo(int handle);
    [[nodiscard]] bool sceneCanRedo(int handle);
    [[nodiscard]] double sceneRevision(int handle);
    /// What is selected: a list of paths.
    [[nodiscard]] std::string sceneSelection(int handle);
    /// The input is such a list.
    [[nodiscard]] bool sceneSelect(int handle, unsigned bytes);
    /// { bounds, shapes: [{ …, at, count }] }, each shape's `count` numbers at the address `at`
    /// until the next drawing. NaN stands for a phase, time or tolerance that is not given.
    [[nodiscard]] std::string sceneDrawing(int handle, double phase, double time, double tolerance,
                                           unsigned panes);
    /// Writes the scene in the format with this place in drawing::ExportFormat; the input is its
    /// options. block: address and number of the bytes, which last until dropExport().
    [[nodiscard]] bool sceneExport(int handle, int format, unsigned bytes);
    void dropExport();
    /// The same in slices: a handle, behind which the export is until it is released.
    [[nodiscard]] int sceneExporting(int handle, int format, unsigned bytes);
    /// Goes on by about so many numbers that are written as text. block: 1 where something is left to
    /// do, else 0; how much is done, 0 … 1; address and number of the bytes that were written, which
    /// last until the next slice of any export.
    [[nodiscard]] bool exportAdvance(int handle, double numbers);
    [[nodiscard]] std::string scenes() const;
    [[nodiscard]] std::string documentSchema() const;

private:
    struct CurveValue {
        Curve curve;
        // Each of these is made when it is first asked for.
        std::optional<scene::Json> spec;
        std::optional<CurveSampler> sampler;
        std::vector<std::uint8_t> source;  ///< what the specification is to be read from
        std::optional<ArcLength> lengths{};
    };
    struct SurfaceValue {
        Surface surface;
        // Each of these is made when it is first asked for.
        std::optional<scene::Json> spec;
        std::optional<SurfaceGrid> grid{};
        std::vector<std::uint8_t> source{};  ///< what the specification is to be read from
    };
    struct MeshValue {
        Mesh mesh;
        std::optional<scene::Json> spec;
    };
    struct MeshRoom {
        std::vector<Vec3> points;
        std::vector<std::uint32_t> starts;
        std::vector<std::uint32_t> corners;
    };
    using Value = std::variant<std::monostate, std::unique_ptr<scene::Made<BFunction>>,
                               std::unique_ptr<CurveValue>, std::shared_ptr<scene::Scene>,
                               std::unique_ptr<SurfaceValue>, std::unique_ptr<MeshValue>,
                               std::unique_ptr<drawing::SceneExport>>;
    struct Slot {
        Value value;
        unsigned generation = 1;
    };

    int refuse(Error error);
    [[nodiscard]] Result<scene::Json> input(unsigned bytes) const;
    [[nodiscard]] std::span<const std::uint8_t> inputBytes(unsigned bytes) const;
    [[nodiscard]] int hold(Value value);
    [[nodiscard]] int holdCurve(CurveValue value);
    [[nodiscard]] int holdCurve(Result<scene::Made<Curve>> made);
    [[nodiscard]] int holdSurface(SurfaceValue value);
    [[nodiscard]] static const scene::Json& specOf(SurfaceValue& held);
    [[nodiscard]] static const scene::Json& specOf(CurveValue& held);
    [[nodiscard]] int holdMesh(Result<Mesh> mesh);
    [[nodiscard]] const Slot* slot(int handle) const;
    /// The value of this type behind the handle; null (and DISPOSED in error()) if there is none.
    template <class T>
    [[nodiscard]] T* find(int handle);
    [[nodiscard]] const ArcLength* findLengths(int handle);
    [[nodiscard]] const BsplineCurve* findBspline(int handle);
    [[nodiscard]] const BlendingCurve* findBlending(int handle);
    /// The local curve, or nothing (and OUT_OF_RANGE `j` in error()).
    [[nodiscard]] std::optional<std::size_t> findLocal(const BlendingCurve& curve, int local);
    int holdFit(Fit fit);
    /// Where the text stands.
    void leaveText(std::string text, std::size_t at);
    int leave(std::vector<double> numbers, std::size_t count);
    /// Moves the first `count` of parameters() into the curve's domain; false, and a refusal that
    /// names `ts[first + i]`, where one lies outside.
    bool enterDomain(const Curve& curve, unsigned first, std::size_t count);
    std::string deliver(Result<Answer> answer);

    Error error_;
    std::vector<std::uint8_t> room_;
    std::array<double, 3 * blockPoints> block_{};
    std::array<double, 3 * blockPoints> normals_{};
    std::array<double, blockPoints> parameters_{};
    std::array<std::int32_t, blockPoints> integers_{};
    std::vector<double> bulk_;
    const double* list_ = nullptr;  ///< bulk_, or numbers that a value holds
    std::vector<std::uint32_t> bulkIndices_;
    std::string text_;
    MeshRoom meshRoom_;
    std::optional<FinalPolygon> subdivided_;
    drawing::DrawingCache drawings_;
    int drawn_ = 0;  ///< the scene that they are of
    std::vector<Slot> slots_;
    std::vector<unsigned> free_;
    int held_ = 0;
};

}  // namespace knotwork::bindings
