// Mistakes that somebody could make, each with the test that must see it. `find` stands exactly
// once in `file`; where it does not any more, the mutant has to be written anew.

/** @typedef {{ name: string, file: string, find: string, replace: string, test: string }} Mutant */

/** @type {Mutant[]} */
export const mutants = [
    {
        name: 'right end: the last parameter belongs to no span',
        file: 'knot_vector.cpp',
        find: 'const bool fromLeft = t >= all.end ||',
        replace: 'const bool fromLeft = t > all.end ||',
        test: 'KnotVector.FindsTheSpanOnEitherSideOfEveryKnot',
    },
    {
        name: 'shifted index: an inserted knot blends the neighbours to the right',
        file: 'boehm.cpp',
        find: 'blend(before, points[i % n],',
        replace: 'blend(points[i % n], points[(i + 1) % n],',
        test: 'RefinementProperty.InsertingAKnotDoesNotMoveTheCurve',
    },
    {
        name: 'missing 1/2: B plus its dual is not halved',
        file: 'b_function_algebra.cpp',
        find: 'rows[k] = 0.5 * (rows[k] + mirrored[k])',
        replace: 'rows[k] = rows[k] + mirrored[k]',
        test: 'BFunctionProperty.DifferencesAreIntegralsOfTheDerivatives',
    },
    {
        name: 'degree for order: the factor of a derivative',
        file: 'bspline_kernels.hpp',
        find: 'values[j] * Knot(static_cast<int>(k)) /',
        replace: 'values[j] * Knot(static_cast<int>(k) + 1) /',
        test: 'SplineProperty.FirstDerivativesAgreeWithTheComplexStepThroughDeBoorsAlgorithm',
    },
    {
        name: 'Oslo’s argument order: the blossom takes its arguments in ascending order',
        file: 'oslo_kernels.hpp',
        find: 'arguments[degree - r]',
        replace: 'arguments[r - 1]',
        test: 'OperationProperty.AllRefinementsAgreeAndKeepTheCurve',
    },
    {
        name: 'sin²(πt) instead of sin²(πt/2)',
        file: 'b_function_families.cpp',
        find: 'const double s = std::sin(0.5 * pi * t);\n        const double c = std::cos(0.5 * pi * t);',
        replace: 'const double s = std::sin(pi * t);\n        const double c = std::cos(pi * t);',
        test: 'BFunctionProperty.RisesFromZeroToOneAndNeverLeavesThem',
    },
    {
        name: 'B′ without 1/h: derivatives of a blend forget the length of the span',
        file: 'blending_curve.cpp',
        find: 'power /= span.length;',
        replace: 'power /= 1;',
        test: 'BlendingProperty.DifferencesWithinASpanAreIntegralsOfTheDerivatives',
    },
    {
        name: 'closed local not shifted: the last span takes the first local where it stands',
        file: 'blending_curve.cpp',
        find: 'wraps ? period : 0, t};',
        replace: 'wraps ? 0 * period : 0, t};',
        test: 'BlendingCurve.AClosedCurveEvaluatesItsFirstLocalOnePeriodEarlierInTheLastSpan',
    },
    {
        name: 'tolerance ignored: every polyline is as coarse as one hundredth',
        file: 'tessellation.cpp',
        find: 'tolerance_(share * tolerance), most_(most),',
        replace: 'tolerance_(share * (0.01 + 0 * tolerance)), most_(most),',
        test: 'Polyline.HonoursItsToleranceFromOneToTenBillionthsOnEveryCurve',
    },
    {
        name: 'wrong side at a knot: derivatives from the left are those from the right',
        file: 'bspline_curve.cpp',
        find: 'const std::size_t span = knots_.findSpan(inside, side);',
        replace: 'const std::size_t span = knots_.findSpan(inside);',
        test: 'SplineProperty.TheBasisFormAgreesWithDeBoorsAlgorithmFromBothSides',
    },
    {
        name: 'stale slot: half-edges of different buckets meet',
        file: 'mesh_edges.hpp',
        find: 'if (slot.smaller != smaller) slot =',
        replace: 'if (slot.smaller == noFace) slot =',
        test: 'Mesh.HasTheEdgesInTheOrderOfItsFaces',
    },
    {
        name: 'notch turned round: the inner angle of a concave corner is less than a half turn',
        file: 'mesh_normals.cpp',
        find: 'glm::dot(across, normal) < 0 ?',
        replace: 'false && glm::dot(across, normal) < 0 ?',
        test: 'MeshNormals.WeighConcaveCornersByTheirInnerAngle',
    },
    {
        name: 'halves swapped: the second face of an edge takes its halves the wrong way round',
        file: 'mesh_level.hpp',
        find: 'return half(2 * std::size_t{edge} + (isNew ? 1 : 0), isNew);',
        replace: 'return half(2 * std::size_t{edge} + 1, isNew);',
        test: 'MeshSubdivision.LevelsAtOnceAreLevelsOneByOneToTheBit',
    },
    {
        name: 'bow tie pulled twice: fans that meet on a boundary are not averaged',
        file: 'mesh_level.cpp',
        find: '(0.125 / edge.fans)',
        replace: '0.125',
        test: 'MeshSubdivision.CatmullClarkIsTheTextbooks',
    },
    {
        name: 'regular by mistake: triangles around a boundary apex are not counted again',
        file: 'mesh_sqrt3.cpp',
        find: '++finer.valences[t.corners[previous(edge.corner)]];',
        replace: '(void)edge;',
        test: 'MeshSubdivision.LevelsAtOnceAreLevelsOneByOneToTheBit',
    },
    {
        name: 'wave the wrong way: the bend of the Butterfly on a boundary',
        file: 'mesh_butterfly.cpp',
        find: '0.25 * std::cos(angle) - bend * std::sin(2 * angle)',
        replace: '0.25 * std::cos(angle) + bend * std::sin(2 * angle)',
        test: 'MeshSubdivision.ButterflyIsTheTextbooks',
    },
    {
        name: 'one mask for all: the second ring of the Butterfly counts a little less',
        file: 'mesh_limit.cpp',
        find: '(-root3 / 6)',
        replace: '(-root3 / 6.1)',
        test: 'MeshLimit.OfTheButterflyOverAGridHasTheNormalsOfTheCubicThatItReproduces',
    },
    {
        name: 'eigenvector of another row: outer neighbours on a boundary',
        file: 'mesh_limit.cpp',
        find: '(ratio + 2) * sum / 8',
        replace: '(ratio + 1) * sum / 8',
        test: 'MeshLimit.OnTheBoundaryOfAGridOfQuadsLooksAlongAndAcross',
    },
];
