// The typed form of the interface. A test compares the names below with what the module exports.

/** `[x, y]` or `[x, y, z]`. */
export type Point = readonly [number, number] | readonly [number, number, number];
/** A point as it comes back. */
export type Point3 = [number, number, number];
/** Points one by one, or a flat array of x, y, z triples. */
export type Points = readonly Point[] | Float64Array;
export type Numbers = readonly number[] | Float64Array;

export type ErrorCode =
    | 'WRONG_TYPE' | 'WRONG_LENGTH' | 'NOT_FINITE' | 'NOT_INTEGER' | 'OUT_OF_RANGE' | 'TOO_LARGE'
    | 'UNKNOWN_NAME' | 'UNKNOWN_FIELD' | 'KNOTS_DECREASING' | 'KNOTS_MULTIPLICITY' | 'KNOTS_COUNT'
    | 'RANK_DEFICIENT' | 'NOT_MANIFOLD' | 'NOT_SUPPORTED' | 'SYNTAX' | 'VERSION' | 'DISPOSED'
    | 'OUT_OF_MEMORY';

/** Every refusal. Nothing else is ever thrown, and what was refused has changed nothing. */
export class KnotworkError extends Error {
    constructor(code: ErrorCode, path: string, message: string, problems?: readonly Problem[]);
    readonly code: ErrorCode;
    /** Where in the input, such as `knots[3]` or `objects[0].bFunction.alpha`; '' for the whole. */
    readonly path: string;
    /** This, and of a document all else that is wrong with it, in the order of reading; at most 100. */
    readonly problems: readonly Problem[];
}

export interface Problem {
    code: ErrorCode;
    path: string;
    message: string;
}

export interface LoadOptions {
    /** The bytes of the module, its URL, or (in Node) its path, instead of the one beside this file. */
    wasm?: ArrayBuffer | ArrayBufferView | URL | string;
}

/** A fresh module with values of its own. */
export function load(options?: LoadOptions): Promise<Knotwork>;

export interface Knotwork {
    bFunction(spec: BFunctionSpec): BFunction;
    /** The families of B-functions and their parameters. */
    readonly bFunctions: BFunctionFamily[];
    /**
     * How a B-function stands with the axioms D1 to D5. A formula may break any of them here, and is
     * not refused for it.
     */
    axioms(spec: BFunctionSpec): AxiomVerdict[];

    curve(spec: BsplineCurveSpec): BsplineCurve;
    curve(spec: ParametricCurveSpec): ParametricCurve;
    curve(spec: BlendingCurveSpec): BlendingCurve;
    curve(spec: BezierCurveSpec): BezierCurve;
    curve(spec: LineCurveSpec): LineCurve;
    curve(spec: ArcCurveSpec): ArcCurve;
    curve(spec: SubdivisionCurveSpec): SubdivisionCurve;
    curve(spec: FormulaCurveSpec): FormulaCurve;
    curve(spec: CurveSpec): Curve;
    /** The named curves and their parameters. */
    readonly parametricCurves: ParametricCurveModel[];

    surface(spec: BsplineSurfaceSpec): BsplineSurface;
    surface(spec: ParametricSurfaceSpec): ParametricSurface;
    surface(spec: BlendingSurfaceSpec): BlendingSurface;
    surface(spec: BlendingTriangleSpec): BlendingTriangle;
    surface(spec: SurfaceSpec): Surface;
    /** The named surfaces, their formulas and their parameters. */
    readonly parametricSurfaces: ParametricSurfaceModel[];

    /**
     * The final polygon: closed 2^levels · n points, the first not repeated; open, a level turns N
     * points into 2N − degree, or 2N − 1 of the four-point scheme. At most 2^22 points.
     */
    subdivide(spec: Subdivision & IntoOption, options?: IntoOption): Float64Array;
    /**
     * A mesh of at most 4 million vertices. NOT_MANIFOLD with path `edges[a,b]` where the edge between
     * two vertices has more than two faces, or two that go along it in the same direction.
     */
    mesh(spec: MeshSpec): Mesh;
    /** The named meshes and their parameters. */
    readonly solids: Solid[];
    /** The B-spline curve with `count` control points that is nearest to points. */
    fit(request: FitRequest): Fit;
    /** The B-spline curve through points, with one control point each. */
    interpolate(request: InterpolationRequest): Fit;
    /** A sphere with all points in it, by default the smallest. */
    enclosingSphere(points: Points, options?: { method?: 'minimal' | 'ritter' | 'incremental' }): Sphere;

    /** An algorithm step by step. */
    trace(given: TraceArguments): Trace;

    scene(document: SceneDocument): Scene;
    /** All that is wrong with a document: nothing where it opens. Never refuses. */
    validate(document: unknown): Problem[];
    /** The built-in scenes. */
    readonly scenes: BuiltinScene[];

    /**
     * The document of a text in another format: a document, a table of points (separated by commas,
     * semicolons, tabs or blanks; a first line may name its columns), OBJ, or SVG (its paths, exact
     * up to arcs). A refusal names line and column.
     */
    importDocument(text: string, options?: ImportOptions): SceneDocument;
    /** The shortest link, `#v1.…`, that opens as this document. */
    encodeLink(document: SceneDocument): Promise<string>;
    /** The document of such a link, or of an address that ends in one. */
    decodeLink(link: string): Promise<SceneDocument>;
    /** The JSON Schema of documents. */
    documentSchema(): Record<string, unknown>;

    /** The session of the wasm module, for the application that draws its scenes. */
    readonly session: unknown;
}

/** What lives in the module until it is disposed of (or, as a net, garbage-collected). */
export interface Disposable {
    /** Frees its memory; everything but dispose() is DISPOSED afterwards. */
    dispose(): void;
    [Symbol.dispose](): void;
}

export interface IntoOption {
    /** An array of the right length to be filled and returned, so that nothing is allocated. */
    into?: Float64Array;
}

// B-functions

export interface AxiomVerdict {
    axiom: 'D1' | 'D2' | 'D3' | 'D4' | 'D5';
    statement: string;
    holds: boolean;
    /** Where it is broken first. */
    t?: number;
    /** The value there, the slope for D4, B(t) + B(1 − t) for D5. */
    found?: number;
    /** The statement, or why it does not hold. */
    text: string;
}

export type BFunctionSpec =
    | { family: 'linear' }
    | { family: 'trigonometric'; order?: number }
    | { family: 'polynomial'; p?: number; q?: number }
    | { family: 'rational'; m?: number; c?: number }
    | { family: 'expo-rational'; alpha?: number; beta?: number; gamma?: number; lambda?: number }
    | { family: 'logistic'; c?: number }
    | { family: 'tabulated'; values: Numbers }
    /** The user's own B(t), a formula in t such as 't^2*(3-2*t)'; checked against the axioms. */
    | { family: 'formula'; expression: string }
    | { family: 'dual' | 'symmetrised'; of: BFunctionSpec }
    | { family: 'composed'; outer: BFunctionSpec; inner: BFunctionSpec }
    | { family: 'mixed'; of: readonly [BFunctionSpec, BFunctionSpec]; weight?: number };

export interface BFunction extends Disposable {
    /** B(t), t in [0, 1]. */
    value(t: number): number;
    /** [B, B′, …, B⁽ⁿ⁾] at t, one-sided at the ends; n up to 25. */
    derivatives(t: number, n: number): number[];
    /** Values at `count` uniform parameters, both ends included. */
    sample(count: number, options?: IntoOption): Float64Array;
    /** The Hermite orders at 0 and at 1: how many derivatives vanish there. Infinity is possible. */
    readonly order: [number, number];
    /** Whether B(t) + B(1 − t) = 1. */
    readonly symmetric: boolean;
    /** Whether derivatives of every order exist on all of [0, 1]. */
    readonly smooth: boolean;
    /** Where its smoothness ends, in words; '' for a smooth one. */
    readonly warning: string;
    /** What it was made from, defaults filled in. */
    readonly spec: BFunctionSpec;
}

export interface ParameterDescription {
    name: string;
    label: string;
    min: number;
    max: number;
    default: number;
    /** Whether `min` itself is excluded. */
    minOpen: boolean;
    maxOpen: boolean;
    integer: boolean;
    help: string;
}

export interface BFunctionFamily {
    family: string;
    label: string;
    formula: string;
    parameters: ParameterDescription[];
    /** The fields that hold other B-functions, and how many. */
    operands: { name: string; label: string; count: number }[];
}

// Curves

export interface BsplineCurveSpec {
    type: 'bspline-curve';
    degree: number;
    form?: 'clamped' | 'open' | 'closed';
    points: Points;
    /** Points + degree + 1 numbers, or points + 1 of one period where closed; default uniform. */
    knots?: Numbers;
    /** One positive number a point makes the curve rational. */
    weights?: Numbers;
}

export interface ParametricCurveSpec {
    type: 'parametric-curve';
    /** A name of `kw.parametricCurves`. */
    name: string;
    parameters?: Record<string, number>;
    domain?: readonly [number, number];
}

/** Scale, then rotate, both about the local curve's own origin, then translate. */
export interface Pose {
    translate?: Point;
    rotate?: { axis?: Point; angle?: number };
    scale?: number | Point;
}

/**
 * What is cut from a model at a knot: the model itself, its tangent, the arc with its curvature, its
 * Taylor polynomial, or a B-spline next to it in the mean square.
 */
export type LocalKind = 'sub-curve' | 'line' | 'arc' | 'bezier' | 'bspline';

export interface BlendingCurveSpec {
    type: 'blending-curve';
    bFunction: BFunctionSpec;
    /** What the local curves are cut from, where they are counted. */
    model?: CurveSpec;
    locals: { count: number; kind?: LocalKind; degree?: number } | readonly CurveSpec[];
    form?: 'open' | 'closed';
    /** Maps each local curve's own domain onto the interval where it takes part. */
    fit?: 'affine';
    /** Equal steps of the model's parameter (the default) or of its length, where `knots` are not given. */
    spacing?: 'parameter' | 'length';
    /** Where each local curve is centred; a closed curve has one more, a period after the first. */
    knots?: Numbers;
    poses?: readonly ({ local: number } & Pose)[];
}

/** Degree = points − 1, at most 25. Like the two below it is continued by its formula. */
export interface BezierCurveSpec {
    type: 'bezier-curve';
    points: Points;
    /** One positive number a point makes the curve rational. */
    weights?: Numbers;
    /** Default [0, 1]. */
    domain?: readonly [number, number];
}

export interface LineCurveSpec {
    type: 'line-curve';
    from: Point;
    to: Point;
    /** Default [0, 1]. */
    domain?: readonly [number, number];
}

/** The arc of constant speed with this point and this curvature, and this first derivative, at `at`. */
export interface ArcCurveSpec {
    type: 'arc-curve';
    at: number;
    point: Point;
    /** Not zero. */
    first: Point;
    second: Point;
    domain: readonly [number, number];
}

export type Subdivision = {
    type?: 'subdivision-curve';
    points: Points;
    /** Default false. */
    closed?: boolean;
    /** How often it is subdivided; default 4. */
    levels?: number;
} & (
    /** Degree 1 to 25, default 3. */
    | { scheme: 'lane-riesenfeld'; degree?: number }
    | { scheme: 'chaikin' }
    /** Tension -1 to 1, default 1/16, which keeps cubics; 0 keeps the polygon. */
    | { scheme: 'four-point'; tension?: number }
);

/**
 * The polyline through the final polygon of at most 2^20 points. Its parameter is that of its limit,
 * the uniform B-spline of the same degree (closed [0, n]; open [degree, n], past whose ends the
 * polygon reaches a little), and counts the vertices in the four-point scheme (closed [0, n], open
 * [0, n − 1]).
 */
export type SubdivisionCurveSpec = Subdivision & { type: 'subdivision-curve' };

/**
 * Formulas in t and the named parameters: + - * / ^, parentheses, numbers, pi, e and sin cos tan
 * asin acos atan sinh cosh tanh exp log sqrt abs. ^ is right-associative and binds tighter than a
 * sign: -t^2 is −(t²). They must be finite on the domain, and go on outside it.
 */
export interface FormulaCurveSpec {
    type: 'formula-curve';
    x: string;
    y: string;
    /** Without it the curve is planar. */
    z?: string;
    parameters?: Record<string, number>;
    domain: readonly [number, number];
    /** The ends of the domain meet, and it is a period; default false. */
    closed?: boolean;
}

export type CurveSpec = BsplineCurveSpec | ParametricCurveSpec | BlendingCurveSpec | BezierCurveSpec
    | LineCurveSpec | ArcCurveSpec | SubdivisionCurveSpec | FormulaCurveSpec;

/** A right-handed orthonormal basis that moves along a curve, all of it finite everywhere. */
export interface Frame {
    point: Point3;
    tangent: Point3;
    /** The left normal in the plane; in space it points to the centre of curvature. */
    normal: Point3;
    binormal: Point3;
    /** In the plane positive in a left turn, in space not negative; 0 at a cusp, which has none. */
    curvature: number;
    torsion: number;
}

/** Outside its domain a closed curve wraps and any other is OUT_OF_RANGE. */
export interface Curve extends Disposable {
    readonly domain: [number, number];
    readonly closed: boolean;
    /** 2 where it lies in the plane z = 0, otherwise 3. */
    readonly dimension: number;
    point(t: number): Point3;
    /**
     * The point and n derivatives, n up to 25. `side` says from where a knot is approached: the
     * right by default, the left at the right end.
     */
    derivatives(t: number, n: number, options?: { side?: 'left' | 'right' }): Point3[];
    /** `count` points, uniform in the parameter, both ends included. */
    sample(count: number, options?: IntoOption): Float64Array;
    /** All positions, then all first derivatives, …. */
    sampleAt(ts: Numbers, options?: IntoOption & { derivatives?: number }): Float64Array;
    /**
     * A polyline that is nowhere further from the curve than the tolerance (default 0.001), every
     * knot among its points; TOO_LARGE where that takes more than 4 million of them.
     */
    polyline(options?: { tolerance?: number }): { points: Float64Array; parameters: Float64Array };
    /**
     * The moving frame. Where the curve stands still its tangent is the limit from the side, where
     * it is straight in space its normal is carried along without turning about the tangent.
     */
    frame(t: number, options?: { side?: 'left' | 'right' }): Frame;
    /**
     * The length from a to b, by default from end to end. A closed curve is followed from a in its
     * direction, through the seam where b lies before a; of any other, a must not lie after b.
     */
    length(a?: number, b?: number): number;
    /** The nearest point of the curve; of several the one with the smallest parameter. */
    closestPoint(p: Point): { t: number; point: Point3; distance: number };
    /**
     * Where a line in the plane z = 0 (in space the plane that is upright on it) crosses the curve and
     * its control polygon: of B-spline, Bézier and subdivision curves, other curves are `NOT_SUPPORTED`.
     * Contact is no crossing. Of a spline the curve has at most as many as the polygon.
     */
    crossings(point: Point, direction: Point): { curve: { t: number; point: Point3 }[]; polygon: Point3[] };
    /** The smallest sphere around all of the curve. */
    enclosingSphere(): { center: Point3; radius: number };
    /** The parameter at which the length from the start is s: the inverse of length(). */
    parameterAtLength(s: number): number;
    /** What it was made from, defaults filled in. */
    readonly spec: CurveSpec;
}

export interface BsplineCurve extends Curve {
    /** In the form in which they are given: one period of a closed curve. */
    readonly knots: number[];
    /** The Greville abscissae, one a point. */
    readonly greville: number[];
    /** The control points as x, y, z triples. */
    controlPoints(options?: { into?: Float64Array }): Float64Array;
    /** The same curve with the knot t `times` times more (default once). */
    insertKnot(t: number, times?: number): BsplineCurve;
    /**
     * The same curve over the full refined vector `knots` (one period where closed): every knot as
     * often as before or more often, up to degree + 1 times, and new ones inside the domain.
     */
    refine(knots: Numbers, options?: { algorithm?: 'oslo' | 'boehm' }): BsplineCurve;
    /** The discrete B-splines of that refinement: a row a new point, a column an old one. */
    osloMatrix(knots: Numbers): number[][];
    /**
     * Takes one knot t out if no point of the curve moves farther than the tolerance (default 1e-9).
     * The deviation bounds what moves, at most 5 % above the maximum; Infinity where no curve is left.
     */
    removeKnot(t: number, options?: { tolerance?: number }): { curve: BsplineCurve; deviation: number; removed: boolean };
    /** The same curve as one of a higher degree (default by 1). */
    elevateDegree(by?: number): BsplineCurve;
    /** One Bézier curve for each span that is not empty, with its interval as `domain`. */
    bezierPieces(): BezierCurveSpec[];
    /** T₁ … T_d at t, T_k of k rows of k + 1: their product with the active points is the point. */
    factorMatrices(t: number): number[][][];
    /**
     * The exact derivative over the same domain: of degree d − 1; of degree 1 with a gap at each
     * knot where d is 1; of degree 2d where the curve is rational (NOT_SUPPORTED beyond degree 12).
     */
    derivativeCurve(): BsplineCurve;
    /** Before t and after t; a closed curve as one clamped curve over [t, t + period]. */
    split(t: number): [BsplineCurve] | [BsplineCurve, BsplineCurve];
    /** The same points over the same domain, from the end to the start. */
    reversed(): BsplineCurve;
    /** Row k: the k-th derivative of all n basis functions. */
    basis(t: number, options?: { derivatives?: number }): number[][];
    /**
     * The degree + 1 basis functions that are not zero at each parameter, one parameter after the
     * other, and for each parameter the index of the first of them (those that follow are counted
     * modulo the number of points where the curve is closed).
     */
    basisAt(ts: Numbers, options?: { into?: BasisValues }): BasisValues;
    readonly spec: BsplineCurveSpec;
}

export interface BasisValues {
    values: Float64Array;
    first: Int32Array;
}

export interface ParametricCurve extends Curve {
    readonly spec: ParametricCurveSpec;
}

export interface BlendingCurve extends Curve {
    readonly knots: number[];
    /** The same curve with local curve j in this pose instead of the one it has. */
    withPose(j: number, pose: Pose): BlendingCurve;
    /** Local curve j where it takes part, posed. */
    local(j: number): Curve;
    /**
     * The same over other knots, as many as there are. With `recut` (the default) the local curves
     * are cut anew there and every pose has its new pivot; without it they stay where they are.
     */
    withKnots(knots: Numbers, options?: { recut?: boolean }): BlendingCurve;
    /** The weights with which the local curves are blended at t: at most two are not 0, sum 1. */
    blendBasis(t: number): number[];
    readonly spec: BlendingCurveSpec;
}

export interface BezierCurve extends Curve {
    readonly spec: BezierCurveSpec;
}

export interface LineCurve extends Curve {
    readonly spec: LineCurveSpec;
}

export interface ArcCurve extends Curve {
    readonly spec: ArcCurveSpec;
}

export interface SubdivisionCurve extends Curve {
    /**
     * Where the given points go, one each: for degree d the B-spline's point at i − (d − 1)/2
     * (closed) or i + (d + 1)/2 (open; beyond the domain, its end). The four-point scheme keeps them.
     */
    limitPoints(): Float64Array;
    /**
     * The derivatives of the limit there. NOT_SUPPORTED for degree 1 and for tensions outside
     * (0, 0.19273), whose limits have corners.
     */
    limitTangents(): Float64Array;
    readonly spec: SubdivisionCurveSpec;
}

export interface FormulaCurve extends Curve {
    readonly spec: FormulaCurveSpec;
}

export interface ParametricCurveModel {
    name: string;
    label: string;
    dimension: number;
    parameters: ParameterDescription[];
}

// Meshes

/**
 * Inscribed in the unit sphere, but for the cube with the corners (±1, ±1, ±1), the tetrahedron with
 * (1, 1, 1), (1, −1, −1), (−1, 1, −1), (−1, −1, 1), and the octahedron with the unit vectors. The grid
 * is open and lies in the plane z = 0.
 */
export type SolidSpec =
    | { solid: 'tetrahedron' | 'cube' | 'octahedron' | 'dodecahedron' | 'icosahedron' | 'cuboctahedron' }
    | { solid: 'prism'; parameters?: { sides?: number } }
    /** `tube` is the radius of the tube where 1 is the distance of the outermost point. */
    | { solid: 'torus'; parameters?: { around?: number; across?: number; tube?: number } }
    | { solid: 'sphere'; parameters?: { around?: number; across?: number } }
    | { solid: 'grid'; parameters?: { columns?: number; rows?: number } };

/**
 * An edge, by its two vertices, that `catmull-clark` and `loop` keep sharp for `sharpness` levels (above
 * 0, up to 10; a fraction is what the last of them keeps), or for ever where it is `'infinite'`.
 */
export interface MeshCrease {
    edge: readonly [number, number];
    sharpness: number | 'infinite';
}

export type MeshSpec =
    | (SolidSpec & { creases?: readonly MeshCrease[] })
    /** Each face names its vertices once, counter-clockwise seen from outside. */
    | { vertices: Points; faces: readonly (readonly number[])[]; creases?: readonly MeshCrease[] }
    /** The text of an OBJ file: its vertices and faces; everything else in it is passed over. */
    | { obj: string };

/** `butterfly` is the modified one. */
export type MeshScheme = 'catmull-clark' | 'doo-sabin' | 'loop' | 'butterfly' | 'sqrt3';

export interface Mesh extends Disposable {
    readonly counts: { vertices: number; edges: number; faces: number; boundaryEdges: number };
    /** x, y, z triples. */
    readonly vertices: Float64Array;
    readonly faces: number[][];
    /** [v0, v1, f0, f1]: face f0 goes from v0 to v1, f1 back; −1 on a boundary. */
    readonly edges: number[][];
    /** Those that it was given or has left of a coarser mesh. */
    readonly creases: MeshCrease[];
    /** Three vertices a triangle: the faces cut for drawing, larger ones than quads as if convex. */
    readonly indices: Uint32Array;
    /**
     * A unit normal for every vertex: the mean of its faces' normals weighted by their angles there.
     * Zero for vertices without faces, or where those cancel.
     */
    vertexNormals(options?: IntoOption): Float64Array;
    /**
     * `levels` steps of a scheme (0 or more). `loop`, `butterfly` and `sqrt3` need triangles, otherwise
     * they are NOT_SUPPORTED at `faces[i]`. A boundary is a curve of its own without fixed corners.
     * Creases are for `catmull-clark` and `loop` (elsewhere NOT_SUPPORTED at `scheme`); a level takes 1
     * from their sharpness.
     */
    subdivide(scheme: MeshScheme, levels?: number): Mesh;
    /** Where the vertices go in the end, and the normals there. Not of `doo-sabin`, whose limits belong to faces, nor with creases. */
    limit(scheme: MeshScheme): { positions: Float64Array; normals: Float64Array };
    /** How smooth its limits are, where all valences are regular and elsewhere, and which meshes it takes. */
    classification(scheme: MeshScheme): {
        approximating: boolean;
        regular: 'C1' | 'C2';
        extraordinary: 'C1';
        mesh: 'any' | 'triangles';
    };
    /** The same vertices with the triangles of `indices` as faces. */
    triangulated(): Mesh;
    /** The text of an OBJ file, which reads back as the same mesh, to the bit. */
    toObj(): string;
    /** What makes it again: the solid that it is, defaults filled in, or its vertices and faces. */
    readonly spec:
        | (SolidSpec & { creases?: MeshCrease[] })
        | { vertices: Point3[]; faces: number[][]; creases?: MeshCrease[] };
}

export interface Solid {
    name: SolidSpec['solid'];
    label: string;
    parameters: ParameterDescription[];
}

// Points

export interface InterpolationRequest {
    points: Points;
    degree: number;
    /** `'closed'` does not repeat the first point. */
    form?: 'clamped' | 'open' | 'closed';
    /**
     * How parameters over [0, 1] are found (default `'chord'`, by distance), or one number a point,
     * not decreasing. Own ones of a closed curve have the period 1 where all lie in [0, 1),
     * otherwise one mean step more than their range.
     */
    parameters?: 'chord' | 'centripetal' | 'uniform' | Numbers;
}

export interface FitRequest extends InterpolationRequest {
    /** The number of control points. Too few data for it is `RANK_DEFICIENT`. */
    count: number;
    /** Default uniform over the range of the parameters; averaged where count is that of the points. */
    knots?: Numbers;
    /** Whether the curve begins and ends exactly in the first and the last point. */
    interpolateEnds?: boolean;
    /**
     * The factor λ ≥ 0 in Σ|C(u) − Q|² + λ Σ|cᵢ₋₁ − 2cᵢ + cᵢ₊₁|², which is minimised: the larger,
     * the straighter the control polygon (default 0).
     */
    smoothing?: number;
}

export interface Fit {
    curve: BsplineCurve;
    /** One a point: those that were given (the array itself if it is a Float64Array), or found. */
    parameters: Float64Array;
    /** Of the distances between the points and the curve at their parameters. */
    residuals: { sumOfSquares: number; rms: number; max: number };
}

export interface Sphere {
    center: Point3;
    radius: number;
}

// Surfaces

export type Form = 'clamped' | 'open' | 'closed';

export interface BsplineSurfaceSpec {
    type: 'bspline-surface';
    /** Along u and along v, up to 25. */
    degree: readonly [number, number];
    /** Default clamped in both directions. */
    form?: readonly [Form, Form];
    /** Rows of points: points[i][j], i along u. */
    points: readonly Points[];
    /** Along u and along v, each as of a curve. */
    knots?: readonly [Numbers, Numbers];
    /** Rows of positive numbers make it rational. */
    weights?: readonly Numbers[];
}

export type ParametricSurfaceSpec = { type: 'parametric-surface' } & (
    | { name: 'plane'; parameters?: { width?: number; height?: number } }
    | { name: 'cylinder' | 'cone'; parameters?: { radius?: number; height?: number } }
    | { name: 'torus' | 'klein'; parameters?: { R?: number; r?: number } }
    | { name: 'sphere'; parameters?: { radius?: number } }
    | { name: 'moebius'; parameters?: { radius?: number; width?: number } }
    | { name: 'helicoid'; parameters?: { radius?: number; pitch?: number; turns?: number } }
    | {
        name: 'seashell';
        parameters?: { R?: number; r?: number; height?: number; growth?: number; turns?: number };
    }
);

/**
 * What is cut from a model surface at a knot of each direction: the model itself, its tangent plane,
 * or its Taylor polynomial.
 */
export type PatchKind = 'sub-surface' | 'plane' | 'bezier';

/**
 * A model cut into nu × nv local patches, of which four are blended between neighbouring knots.
 * Beyond its domain a model goes on as it does by itself; a closed direction evaluates its first
 * patches one period earlier. At most 10 000 patches, and 500 000 Bézier points in all.
 */
export interface BlendingSurfaceSpec {
    type: 'blending-surface';
    /** One for both directions, or one along u and one along v. */
    bFunction: BFunctionSpec | readonly [BFunctionSpec, BFunctionSpec];
    model: SurfaceSpec;
    /** How many patches along u and along v, at least 2 each. */
    locals: readonly [number, number];
    /** Default 'sub-surface'. */
    kind?: PatchKind;
    /** Of 'bezier' along u and along v, 1 … 25; default [3, 3]. */
    degree?: readonly [number, number];
    /** Default: closed where the model is. */
    form?: readonly ['open' | 'closed', 'open' | 'closed'];
    /**
     * Where the patches are centred, along u and along v: as many numbers as patches, and one more,
     * the period after the first, where closed. Default uniform over the model's domain. Two equal
     * knots in a row make a permitted break.
     */
    knots?: readonly [Numbers, Numbers];
    /** Scale, then rotation, both about the patch's own point at its knots, then translation. */
    poses?: readonly ({ local: readonly [number, number] } & Pose)[];
}

/**
 * Three surfaces, the local patches, blended over a triangle. With x and y the parameters of each
 * patch, from 0 at their starts to 1 at their ends, the triangle has the corners (x, y) = (0, 0),
 * (1, 0), (0, 1), in which patch 0, 1 and 2 alone counts, with all derivatives up to the order: half
 * of the rectangle of each patch is used, and three equal patches blend into that half. On the side
 * opposite to its corner a patch has no influence up to the order.
 *
 * The domain is [0, 1] × [0, 1], with x = u (1 − v) and y = u v: u = 0 is all of corner 0, a pole,
 * u = 1 the side opposite to it, v = 0 the side to corner 1 and v = 1 that to corner 2. So grids and
 * triangulations cover the triangle and nothing else, and the normal is that of the patches.
 */
export interface BlendingTriangleSpec {
    type: 'blending-triangle';
    /** Of any type; blends within blends at most 8 deep and 1024 innermost surfaces in all. */
    locals: readonly [SurfaceSpec, SurfaceSpec, SurfaceSpec];
    /** Of the polynomial weights, default 1; with a B-function left out. */
    order?: 1 | 2;
    /**
     * The weights B(λ_k) / (B(λ_0) + B(λ_1) + B(λ_2)) instead, of its order at 0; λ = (1 − x − y, x, y).
     * OUT_OF_RANGE where B(1/3) < 1e-9.
     */
    bFunction?: BFunctionSpec;
}

export type SurfaceSpec =
    | BsplineSurfaceSpec | ParametricSurfaceSpec | BlendingSurfaceSpec | BlendingTriangleSpec;

/** Outside its domain a closed direction wraps; in any other, `u` or `v` is OUT_OF_RANGE. */
export interface Surface extends Disposable {
    /** [[u0, u1], [v0, v1]] */
    readonly domain: [[number, number], [number, number]];
    /**
     * Whether it is periodic along u and along v: not at a pole, and not where it closes turned over,
     * as a Möbius strip does.
     */
    readonly closed: [boolean, boolean];
    point(u: number, v: number): Point3;
    /**
     * The point, its first and its second derivatives; at a knot those from the right, at the end of
     * a direction that is not closed those from the left.
     */
    derivatives(u: number, v: number): {
        S: Point3; Su: Point3; Sv: Point3; Suu: Point3; Suv: Point3; Svv: Point3;
    };
    /**
     * The unit normal, in the direction of Su × Sv. At a pole it is the limit from inside; [0, 0, 0]
     * where there is none, that is where the surface shrinks to a curve or a point.
     */
    normal(u: number, v: number): Point3;
    /**
     * Gaussian and mean curvature and the principal ones, k1 ≥ k2, for the normal above: a sphere
     * whose normal points outwards has mean −1/r. At a pole they are limits; NOT_SUPPORTED where they
     * have none (the tip of a cone).
     */
    curvatures(u: number, v: number): { gaussian: number; mean: number; k1: number; k2: number };
    /**
     * nu × nv points (each at least 2, 4 million in all), uniform in the parameters, both ends
     * included also where the surface is closed: there the last row or column repeats the first to
     * the bit, and the triangles use the first, so that the mesh has no edge at the seam.
     */
    grid(nu: number, nv: number, options?: { into?: Grid }): Grid;
    /**
     * A mesh whose triangles are nowhere farther from the surface than the tolerance (default 0.01),
     * with more of them where it is more curved; without cracks, and without edges at closed seams.
     * TOO_LARGE where that takes more than 262144 vertices.
     */
    triangles(options?: { tolerance?: number }): SurfaceTriangles;
    /**
     * Points of an isoparametric line, along u at a constant v or along v at a constant u: `count`
     * uniform ones, both ends included, or those of a polyline within the tolerance (default 0.001).
     */
    isoline(along: 'u' | 'v', at: number, options?: { count: number } | { tolerance?: number }): Float64Array;
    /** What it was made from, defaults filled in. */
    readonly spec: SurfaceSpec;
}

/** Point (i, j), i along u, is number i · nv + j. */
export interface Grid {
    /** x, y, z triples. */
    positions: Float64Array;
    /** Unit normals, those of normal(u, v). */
    normals: Float64Array;
    /**
     * Triangles, counter-clockwise seen from where the normals point to: 6 (nu − 1)(nv − 1) numbers.
     * They depend on nu, nv and `closed` only, and those of an earlier answer with the same are left
     * as they stand.
     */
    indices: Uint32Array;
}

export interface SurfaceTriangles {
    positions: Float64Array;
    normals: Float64Array;
    /** u, v of every vertex; at a closed seam those of its start. */
    parameters: Float64Array;
    /** Counter-clockwise seen from where the normals point to. */
    indices: Uint32Array;
}

export interface BsplineSurface extends Surface {
    /**
     * The same surface over the full refined vectors along u and along v (one period where closed),
     * each as in refine() of a curve. At most 100 000 points in all.
     */
    refine(knots: readonly [Numbers, Numbers]): BsplineSurface;
    readonly spec: BsplineSurfaceSpec;
}

export interface ParametricSurface extends Surface {
    readonly spec: ParametricSurfaceSpec;
}

export interface BlendingSurface extends Surface {
    /** Where the local patches are centred, along u and along v. */
    readonly knots: [number[], number[]];
    /** Where the own points of all patches stand, posed: x, y, z of patch [i, j] at 3 (i nv + j). */
    readonly localOrigins: Float64Array;
    /**
     * Local patch [i, j] over the rectangle where it takes part, posed. A plane or a Bézier patch is a
     * B-spline surface of one piece.
     */
    local(i: number, j: number): Surface;
    /** The same surface with local patch [i, j] in another pose. */
    withPose(local: readonly [number, number], pose: Pose): BlendingSurface;
    readonly spec: BlendingSurfaceSpec;
}

export interface BlendingTriangle extends Surface {
    /** The local patch of corner 0, 1 or 2, over all of its own rectangle. */
    local(corner: 0 | 1 | 2): Surface;
    /** What each patch counts at (u, v): not negative, 1 in sum. */
    weights(u: number, v: number): [number, number, number];
    readonly spec: BlendingTriangleSpec;
}

export interface ParametricSurfaceModel {
    name: string;
    label: string;
    /** x, y, z; the domain; where it is closed. */
    formula: string;
    closed: [boolean, boolean];
    parameters: ParameterDescription[];
}

// Traces

export type TraceArguments =
    /** The evaluation of a curve at t. */
    | { algorithm: 'de-boor' | 'cox-de-boor' | 'factor-matrices'; curve: BsplineCurveSpec; t: number }
    | { algorithm: 'blend'; curve: BlendingCurveSpec; t: number }
    /** The four patches of a surface at (u, v). */
    | { algorithm: 'blend'; surface: BlendingSurfaceSpec; u: number; v: number }
    /** One more knot. */
    | { algorithm: 'boehm'; curve: BsplineCurveSpec; knot: number }
    /** All knots of the refined curve, of one period where it is closed. */
    | { algorithm: 'oslo'; curve: BsplineCurveSpec; knots: Numbers }
    /** Degree 3, one level, open unless said otherwise. */
    | { algorithm: 'lane-riesenfeld'; points: Points; closed?: boolean; degree?: number; levels?: number }
    /** Tension 1/16, one level, open unless said otherwise. */
    | { algorithm: 'four-point'; points: Points; closed?: boolean; tension?: number; levels?: number }
    /** A mesh; one level unless said otherwise. */
    | { algorithm: 'catmull-clark'; mesh: MeshSpec; levels?: number };

/**
 * The first frame shows where the algorithm begins, the last one its result: the last point of its
 * points, or all of them where the result is a polygon or a mesh.
 */
export interface Trace {
    algorithm: TraceArguments['algorithm'];
    frames: TraceFrame[];
}

export interface TraceFrame {
    title: string;
    /** One sentence that can be spoken: what happens in this step, with its numbers. */
    text: string;
    /** The picture at this step. */
    points: Point3[];
    /** Pairs of indices of points. */
    edges: [number, number][];
    /** Indices of the points that the step is about: active, or new. */
    marked: number[];
    /** Ratios, basis functions or weights of this step. */
    weights?: number[];
    /** By rows. */
    matrix?: number[][];
    /** MathML, with the numbers of this step. */
    formula?: string;
    /** Which sentence `text` is, and the numbers in it, for saying it in another language. */
    key: string;
    values: Record<string, string>;
}

// Scenes

export interface SceneView {
    mode?: '2d' | '3d';
    /** Default all but hodograph and curvature. */
    panes?: readonly Pane[];
    /** Without a centre and a height all is fitted; the angles, in radians, are those of a 3D view. */
    camera?: { center?: Point; height?: number; azimuth?: number; elevation?: number };
}

export interface SubdivisionSurfaceSpec {
    type: 'subdivision-surface';
    /** Default Catmull–Clark. */
    scheme?: MeshScheme;
    /** Default 2. */
    levels?: number;
    mesh: MeshSpec;
    /** A point of the next level, shown with the weights of the vertices that it is made from. */
    stencil?: {
        /** Default a vertex. Of a Doo–Sabin surface, a corner of a face. */
        of?: 'vertex' | 'edge' | 'face' | 'corner';
        /** From 0, default 0; the last one beyond the end. */
        index?: number;
    };
}

export interface PointCloudSpec {
    type: 'point-cloud';
    points: readonly Point[] | Float64Array;
    /** The B-spline curve that comes closest to the points, if one is wanted. */
    fit?: {
        degree: number;
        count: number;
        form?: Form;
        parameters?: 'chord' | 'centripetal' | 'uniform';
        interpolateEnds?: boolean;
        smoothing?: number;
    };
}

/** The graph of a proposed B-function, with the checklist of its axioms. */
export interface BFunctionGraphSpec {
    type: 'b-function';
    bFunction: BFunctionSpec;
    /** The lower left corner of its picture, default the origin. */
    at?: Point;
    /** The side of its picture, default 1. */
    size?: number;
}

export type Shown =
    | 'curve' | 'surface' | 'isolines' | 'wireframe' | 'polygon' | 'points' | 'knots' | 'locals' | 'handles'
    | 'basis' | 'bFunction' | 'comb' | 'hodograph' | 'curvature' | 'osculating' | 'hull' | 'frames' | 'sphere'
    | 'crossings' | 'residuals' | 'labels';

export type SceneObject = (CurveSpec | SurfaceSpec | SubdivisionSurfaceSpec | PointCloudSpec | BFunctionGraphSpec) & {
    id?: string;
    /** `opacity` from 0 to 1; `colourBy` says what the colours of a surface show. */
    style?: {
        colour?: string;
        width?: number;
        opacity?: number;
        colourBy?: 'colour' | 'gaussian' | 'mean';
        /** The curve, and so its B-function. */
        dashed?: boolean;
    };
    show?: Partial<Record<Shown, boolean>>;
    /** Where the curve is measured; the middle of its domain if it is left out. */
    t?: number;
    trace?: ShownTrace;
    /**
     * A point and the direction of a line whose crossings with the curve and its control polygon are
     * counted where `show.crossings` asks for it; through the middle if it is left out then.
     */
    line?: readonly [Point, Point];
};

/** A step of an algorithm that works on objects of this type, as kw.trace() has it. */
export interface ShownTrace {
    algorithm:
        | 'de-boor' | 'cox-de-boor' | 'factor-matrices' | 'boehm' | 'oslo' | 'lane-riesenfeld' | 'four-point'
        | 'blend' | 'catmull-clark';
    /** The object's parameter, or the middle of a surface, if they are left out. */
    t?: number;
    u?: number;
    v?: number;
    knot?: number;
    /** Every span is halved if they are left out. */
    knots?: readonly number[];
    /** The object's own if they are left out. */
    levels?: number;
    /** From 0; the last one beyond the end. */
    frame?: number;
}

/** Pure functions of phase: at 0 and 1 everything stands where it began, exactly. */
export type Effect = {
    /** The id of an object. */
    target: string;
    /** Seconds until everything is back; default 10. */
    period?: number;
    /** There and back; default trigonometric. */
    easing?: BFunctionSpec;
} & (
    /** Of the whole object, or of one local: j of a blending curve, [i, j] of a blending surface. */
    | { kind: 'translate'; by?: Point; local?: number | [number, number] }
    | { kind: 'rotate'; axis?: Point; angle?: number; center?: Point; local?: number | [number, number] }
    | { kind: 'scale'; factor?: number | Point; center?: Point; local?: number | [number, number] }
    | { kind: 'simulate'; translate?: Point; rotate?: { axis?: Point; angle?: number }; seed?: number }
    /** To another curve; of a blending curve each local goes its own way and keeps its pose. */
    | { kind: 'morph'; to?: CurveSpec }
    | { kind: 'colour'; to?: string }
);

export interface SceneDocument {
    knotwork: 1;
    title?: string;
    description?: string;
    view?: SceneView;
    objects?: readonly SceneObject[];
    effects?: readonly Effect[];
}

/** How much farther local curves or patches are moved, turned and made larger. */
export interface PoseChange {
    translate?: Point;
    rotate?: { axis?: Point; angle?: number };
    /** One factor, greater than 0. */
    scale?: number;
    /** The point about which the whole group is turned and scaled; else each about its own. */
    about?: Point;
}

/** A local curve j, or a local patch [i, j]; or several of one object. */
export type PosedLocals =
    | { local: number | readonly [number, number] }
    | { locals: readonly (number | readonly [number, number])[] };

/** Paths as in `objects[0].points[2]`. */
export type SingleCommand =
    /**
     * What depends on a field follows it: knots and weights the points, the degree and the form (a
     * closed curve that is opened does not move), poses the number of locals, fits the data. Setting
     * an object's `type` keeps its id, style and show, and so does setting all of it without them.
     */
    | { set: string; value: unknown }
    /**
     * A point, a vertex (a solid becomes vertices and faces), a knot or a number. A knot within
     * `snap` of another one goes onto it. Of equal knots of a B-spline that one moves which does not
     * pass the others, and the answer names it; equal ones at a clamped end move together. With
     * `recut: false` a knot of a blending curve moves and its local curves stay where they are.
     */
    | { move: string; to: number | Point; recut?: boolean; snap?: number }
    | { move: string; by: number | Point; recut?: boolean; snap?: number }
    /** `objects[2]` or `effects[2]` to another place in its list. */
    | { move: string; to: number }
    /** Several places of objects by the same amount. */
    | { move: readonly string[]; by: number | Point }
    /**
     * Before the element at the path, or after the last one: points, knots, poses, vertices, faces,
     * rows of a net (`points[i]`) and its columns (`points[0][j]`, a list of one point for each
     * row), objects and effects.
     */
    | { insert: string; value: unknown }
    /** Of a net `points[i]` takes out a row and `points[i][j]` a column. */
    | { remove: string }
    | { add: SceneObject }
    /** What is left out of a pose keeps its value. */
    | { pose: { object: string } & PosedLocals & Pose }
    | { pose: { object: string; by: PoseChange } & PosedLocals }
    /**
     * B-splines do not move; blending curves and surfaces get local curves or patches there. A
     * surface needs to know along which parameter. `{ insert: 'objects[0].knots[1]', value }` does
     * the same, and `{ remove: 'objects[0].knots[1][4]' }` takes a knot out with its row or column.
     */
    | { insertKnot: { object: string; at: number; along?: 'u' | 'v' } };

/**
 * Commands of one gesture are one step of history, and so is a list of them, of which all are
 * carried out or none (a refusal's path begins with `all[i]`). `selection` is what is selected from
 * then on: undo brings back what was selected before the step.
 */
export type Command = { gesture?: string; selection?: readonly string[] } & (
    | SingleCommand
    | { all: readonly SingleCommand[] }
);

export type Pane = 'curve' | 'basis' | 'knots' | 'bFunction' | 'hodograph' | 'curvature';

export interface Shape {
    /** The id of the object it belongs to. */
    object: string;
    role: string;
    kind: 'polyline' | 'points' | 'triangles' | 'label';
    /**
     * Positions in `hodograph` are first derivatives; in the panes of plots x is the parameter, in
     * `curvature` y is the curvature.
     */
    pane: Pane;
    /** Which basis function, local curve or order of derivative. */
    index: number;
    /** x, y, z triples. */
    positions: Float64Array;
    /** Of triangles: unit vectors, one a position, on the side from which they go counter-clockwise. */
    normals?: Float64Array;
    /**
     * Of triangles: three positions each. A polyline runs from position to position where it has
     * none; otherwise it consists of separate segments, two positions each.
     */
    indices?: Uint32Array;
    /** `#rrggbb` */
    colour: string;
    opacity: number;
    /** Line width or diameter in CSS pixels. */
    width: number;
    dashed: boolean;
    square: boolean;
    /** The list in the document whose k-th element the k-th position shows; '' for none. */
    path: string;
    /** Of a label. */
    text: string;
    /** Of a label: from its position to the middle of its text in CSS pixels, right and down. */
    offset?: [number, number];
}

export interface Drawing {
    /** Of the curves in world units; null where nothing is drawn. */
    bounds: { min: Point3; max: Point3 } | null;
    /** In painting order. */
    shapes: Shape[];
}

/** All effects at a phase in [0, 1] (default 0), or each where it is at a time in seconds. */
export interface MomentOptions {
    phase?: number;
    time?: number;
}

export interface SvgOptions extends MomentOptions {
    /** In pixels, from 1 to 32768; default 800. */
    width?: number;
    /** Likewise; default 600. */
    height?: number;
    /** Default light. */
    theme?: 'light' | 'dark' | 'contrast';
    /** What the picture is called by those who do not see it; default the document's title. */
    title?: string;
    /** Default the document's description. */
    description?: string;
    /** `theme` (default), `none`, or a colour as `#rrggbb`. */
    background?: string;
    /** Which of the linked views are in it; default the curve alone. */
    panes?: readonly Pane[];
}

export interface ExportOptions extends MomentOptions {
    /**
     * Largest distance of lines and triangles from what they stand for, in units of the scene; by
     * default 1/10000 of the scene's size for curves and 1/1000 for surfaces.
     */
    tolerance?: number;
}

export interface ImportOptions {
    /** What the text is; without it, it is guessed. */
    format?: 'json' | 'csv' | 'obj' | 'svg';
    /** Whether a table is a cloud of points (default) or the control points of a curve. */
    as?: 'points' | 'curve';
    /** The document's title. */
    title?: string;
}

export interface FieldDescription {
    path: string;
    name: string;
    label: string;
    kind: string;
    group: string;
    help: string;
    value: unknown;
    /** The least and the largest value; null for no bound. */
    range: [number | null, number | null];
    min?: number;
    max?: number;
    minOpen?: boolean;
    maxOpen?: boolean;
    low?: number;
    high?: number;
    choices?: { value: string; label: string }[];
}

/** A file that is being written. All its bytes, in order, are what exportAs() answers. */
export interface Exporting extends Disposable {
    /**
     * Goes on by about so many numbers that are written as text (default 8000, which take some
     * milliseconds), and answers whether anything is left to do, how much is done (0 to 1, never less
     * than before), and what has been written since.
     */
    advance(numbers?: number): { more: boolean; fraction: number; bytes: Uint8Array };
}

export interface Scene extends Disposable {
    /** The canonical document: defaults filled in, keys in a fixed order. */
    readonly document: SceneDocument;
    /**
     * The scene with all effects at a phase in [0, 1] (default 0), or each where it is at a time;
     * to a tolerance in world units (default 1e-3), and all panes where they are not named.
     */
    drawing(options?: MomentOptions & { tolerance?: number; panes?: Pane[] }): Drawing;
    /**
     * The picture as SVG: curves as cubic Bézier curves (exact up to degree 3), grouped and named by
     * object and role, without scripts, style sheets or anything to be fetched.
     */
    svg(options?: SvgOptions): string;
    /**
     * The scene for other programs: its picture, its document (`json`), the calls that make its
     * objects (`js`), or the objects at a moment: points in a table (`csv`), lines and faces (`obj`),
     * triangles (`stl`), lines and triangles with colours (`gltf`; `glb` is the same as one file).
     */
    exportAs(format: 'svg', options?: SvgOptions): string;
    exportAs(format: 'json' | 'js' | 'csv' | 'obj' | 'gltf', options?: ExportOptions): string;
    exportAs(format: 'stl' | 'glb', options?: ExportOptions): Uint8Array;
    /**
     * The same in slices, for a thread that has other things to do: of the scene as it is now, whatever
     * becomes of it meanwhile. Disposing of it ends it and leaves nothing.
     */
    exporting(format: 'svg', options?: SvgOptions): Exporting;
    exporting(format: 'json' | 'js' | 'csv' | 'obj' | 'stl' | 'gltf' | 'glb', options?: ExportOptions): Exporting;
    /** Applies a command; one that is refused changes nothing. */
    execute(command: Command): { command: string; path: string };
    /** Takes a step back; false where there is none. */
    undo(): boolean;
    redo(): boolean;
    readonly canUndo: boolean;
    readonly canRedo: boolean;
    /** The fields of each object. */
    readonly schema: { object: string; type: string; label: string; fields: FieldDescription[] }[];
    /** What is selected: paths into the document, without those that lead nowhere any more. */
    readonly selection: string[];
    /** Selects without a step of history; at most 10 000 paths. */
    select(paths: readonly string[]): void;
    /** Grows by one with every change. */
    readonly revision: number;
    /** Its name in the module, for a view that shows it. */
    readonly handle: number;
}

export interface BuiltinScene {
    id: string;
    title: string;
    description: string;
    document: SceneDocument;
}
