// The basis functions at a parameter: by the recurrence of Cox and de Boor, and as a product of
// matrices (T. Lyche, K. Mørken, Spline Methods, ch. 2).
#include "geometry/bspline_kernels.hpp"
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_spline.hpp"

namespace knotwork::scene {

namespace {

constexpr Sentence coxBegin{
    "cox-de-boor.begin", "Degree 0",
    "The parameter {t} lies between the knots {from} and {to}, so that of the "
    "functions of degree 0 the one of this span is 1 and all others are 0."};
constexpr Sentence coxDegree{
    "cox-de-boor.degree", "Degree {k}",
    "Each function of degree {k} is made of two neighbours of one degree less; at {t} those "
    "with the numbers {numbers} are {weights}, and all others are 0."};
constexpr Sentence coxResult{
    "cox-de-boor.result", "Degree {k}: the basis",
    "At {t} the functions of degree {k} with the numbers {numbers} are {weights}; together they "
    "are 1, and they mix the control points into the point {point}."};
constexpr Sentence coxWeightedResult{
    "cox-de-boor.weighted-result", "Degree {k}: the basis",
    "At {t} the functions of degree {k} with the numbers {numbers} are {weights}; together they "
    "are 1, and they mix the control points with their weights into the point {point}."};

constexpr Sentence factorBegin{
    "factor-matrices.begin", "The factors at {t}",
    "The parameter {t} lies between the knots {from} and {to}; the curve is there a product of "
    "as many matrices as its degree, {degree}, and of the {active} active control points, "
    "number {first} to number {last}."};
constexpr Sentence factorStep{
    "factor-matrices.factor", "Factor {k} of {degree}",
    "Factor {k} of {degree} has {k} rows and {columns} columns, in each row one minus w and w, "
    "with w being {ratios}; the product of the factors so far is the row {row}."};
constexpr Sentence factorResult{
    "factor-matrices.result", "The product",
    "The product of all factors is the row of the basis functions, {row}, and times the active "
    "control points it is the point of the curve at {t}, {point}; multiplied from the right "
    "instead, each factor is a level of de Boor's algorithm."};

using Row = std::vector<double>;

/// The k+1 functions of degree k that live on the span, for k = 0 … d.
std::vector<Row> triangleOf(const SplineSpan& span) {
    Row values(span.degree + 1);
    values[0] = 1;
    std::vector<Row> triangle{{1}};
    for (std::size_t k = 1; k <= span.degree; ++k) {
        kernels::raiseBasis(span.knots, span.index, k, span.t, std::span<double>(values));
        triangle.emplace_back(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k + 1));
    }
    return triangle;
}

/// In the row of all functions of degree k: n+d-k of them, or n where they are periodic.
Row amongAll(const SplineSpan& span, std::size_t k, const Row& values) {
    const std::size_t n = span.curve->points().size();
    Row all(span.curve->closed() ? n : n + span.degree - k, 0.0);
    for (std::size_t j = 0; j <= k; ++j) all[(span.index - k + j) % all.size()] = values[j];
    return all;
}

std::vector<std::string> numbersOnSpan(const SplineSpan& span, std::size_t k) {
    std::vector<std::string> numbers;
    const std::size_t n = span.curve->points().size();
    for (std::size_t i = span.index - k; i <= span.index; ++i) {
        numbers.push_back(readable(span.curve->closed() ? i % n : i));
    }
    return numbers;
}

/// b_{k,i} = w_{k,i} b_{k-1,i} + (1 - w_{k,i+1}) b_{k-1,i+1}, without a term that is 0 on the span.
std::string recurrenceRow(const SplineSpan& span, std::size_t k, std::size_t j, const Row& lower,
                          double value) {
    const std::size_t i = span.index - k + j;
    const auto knot = [&](std::size_t at) { return span.knots[at]; };
    const auto minus = [&](double a, double b) { return notedDifference(a, b, span.parameters); };
    std::string symbols;
    std::string numbers;
    if (j > 0) {
        symbols = ratioSymbols(k, i) + indexedTerm("b", k - 1, i);
        numbers = ratioNumbers(span.knots, k, i, span.t, span.parameters) + "\\cdot " +
                  noted(lower[j - 1]);
    }
    if (j > 0 && j < k) {
        symbols += '+';
        numbers += '+';
    }
    if (j < k) {
        const std::string right = indexedTerm("t", i + k + 1);
        symbols += fraction(right + "-t", right + '-' + indexedTerm("t", i + 1)) +
                   indexedTerm("b", k - 1, i + 1);
        numbers += fraction(minus(knot(i + k + 1), span.t), minus(knot(i + k + 1), knot(i + 1))) +
                   "\\cdot " + noted(lower[j]);
    }
    return indexedTerm("b", k, i) + "&=&" + symbols + "&=&" + numbers + "&=&" + noted(value);
}

std::string recurrenceFormula(const SplineSpan& span, std::size_t k,
                              std::span<const Row> triangle) {
    if (k == 0) return mathml(indexedTerm("b", 0, span.index) + "=1");
    NotedRows rows;
    for (std::size_t j = 0; j <= k; ++j) {
        rows.add(recurrenceRow(span, k, j, triangle[k - 1], triangle[k][j]));
    }
    return mathml(rows.table());
}

/// The point that a row of basis functions makes of the active points.
Vec3 mixed(const Row& row, std::span<const Homogeneous> active, bool weighted) {
    Homogeneous sum(0);
    for (std::size_t j = 0; j < row.size(); ++j) sum += row[j] * active[j];
    return drawn(sum, weighted);
}

/// The active points, and the point of the curve joined to each of them.
void drawMix(TraceFrame& frame, std::span<const Vec3> active, const Vec3& point) {
    const std::size_t first = addPolygon(frame, active);
    const std::size_t made = addMarked(frame, {&point, 1});
    for (std::size_t j = 0; j < active.size(); ++j) frame.edges.push_back({first + j, made});
}

TraceFrame degreeFrame(const SplineSpan& span, std::size_t k, std::span<const Row> triangle) {
    const bool weighted = span.curve->rational();
    const std::vector<Homogeneous> active = span.activePoints();
    const Vec3 point = mixed(triangle[span.degree], active, weighted);
    const bool last = k == span.degree;
    SentenceValues values = span.values();
    values.insert(values.end(), {{"k", readable(k)},
                                 {"numbers", spoken(numbersOnSpan(span, k))},
                                 {"weights", spoken(triangle[k])}});
    if (last) values.emplace_back("point", span.text(point));
    TraceFrame frame = tell(k == 0 ? coxBegin
                            : !last ? coxDegree
                                    : weighted ? coxWeightedResult : coxResult,
                            std::move(values));
    if (k == 0) {
        drawPolygon(frame, span);
    } else if (!last) {
        addPolygon(frame, drawn(active, weighted));
    } else {
        drawMix(frame, drawn(active, weighted), point);
    }
    frame.weights = amongAll(span, k, triangle[k]);
    frame.formula = recurrenceFormula(span, k, triangle);
    return frame;
}

/// T_k at t: row r has 1-w and w in columns r and r+1, w = w_{k,l-k+1+r}.
std::vector<Row> factorMatrix(const SplineSpan& span, std::size_t k) {
    std::vector<Row> matrix(k, Row(k + 1, 0.0));
    for (std::size_t r = 0; r < k; ++r) {
        const double w = span.weight(k, span.index + 1 + r - k);
        matrix[r][r] = 1 - w;
        matrix[r][r + 1] = w;
    }
    return matrix;
}

Row timesMatrix(const Row& row, const std::vector<Row>& matrix) {
    Row product(matrix.front().size(), 0.0);
    for (std::size_t r = 0; r < row.size(); ++r) {
        for (std::size_t c = 0; c < product.size(); ++c) product[c] += row[r] * matrix[r][c];
    }
    return product;
}

std::string productUpTo(std::size_t k) {
    if (k == 1) return "T_{1}";
    return (k == 2 ? "T_{1}" : "T_{1}\\cdots ") + indexedTerm("T", k);
}

TraceFrame factorFrame(const SplineSpan& span, std::size_t k, std::vector<Row> matrix,
                       const Row& product) {
    std::vector<double> ratios;
    std::string symbols = "\\matrix{";
    for (std::size_t r = 0; r < k; ++r) {
        ratios.push_back(matrix[r][r + 1]);
        const std::string w = indexedTerm("w", k, span.index + 1 + r - k);
        for (std::size_t c = 0; c <= k; ++c) {
            symbols += c == 0 ? (r == 0 ? "" : "\\\\") : "&";
            symbols += c == r ? "1-" + w : c == r + 1 ? w : "0";
        }
    }
    SentenceValues values = span.values();
    values.insert(values.end(), {{"k", readable(k)},
                                 {"columns", readable(k + 1)},
                                 {"ratios", spoken(ratios)},
                                 {"row", spoken(product)}});
    TraceFrame frame = tell(factorStep, std::move(values));
    addPolygon(frame, drawn(span.activePoints(), span.curve->rational()));
    frame.weights = product;
    const std::vector<Row> row{product};
    frame.formula = mathml("\\table{" + indexedTerm("T", k) + "&=&" + symbols + "}=" +
                           notedMatrix(matrix) + "\\\\" + productUpTo(k) + "&=&" +
                           notedMatrix(row) + '}');
    frame.matrix = std::move(matrix);
    return frame;
}

std::string productFormula(const SplineSpan& span, const Row& product, const Vec3& point) {
    std::string points = "\\matrix{";
    for (std::size_t i = span.index - span.degree; i <= span.index; ++i) {
        points += indexedTerm("c", span.pointOf(i)) + (i < span.index ? "\\\\" : "}");
    }
    const std::vector<Row> row{product};
    return mathml("c(t)=" + productUpTo(span.degree) + points + "=" + notedMatrix(row) + points +
                  "=" + noted(point, span.curve->dimension(), span.places));
}

TraceFrame productFrame(const SplineSpan& span, const Row& product) {
    const bool weighted = span.curve->rational();
    const auto levels = span.levels();
    const Vec3 point = mixed(product, levels[0], weighted);
    SentenceValues values = span.values();
    values.insert(values.end(), {{"row", spoken(product)}, {"point", span.text(point)}});
    TraceFrame frame = tell(factorResult, std::move(values));
    for (std::size_t r = 0; r < span.degree; ++r) addPolygon(frame, drawn(levels[r], weighted));
    addMarked(frame, {&point, 1});
    frame.weights = product;
    frame.formula = productFormula(span, product, point);
    return frame;
}

}  // namespace

Result<Trace> traceCoxDeBoor(const BsplineCurve& curve, double t) {
    const SplineSpan span(curve, t);
    const std::vector<Row> triangle = triangleOf(span);
    TraceWriter writer("cox-de-boor");
    for (std::size_t k = 0; k <= span.degree; ++k) writer.add(degreeFrame(span, k, triangle));
    return std::move(writer).finish("curve.points");
}

Result<Trace> traceFactorMatrices(const BsplineCurve& curve, double t) {
    const SplineSpan span(curve, t);
    TraceWriter writer("factor-matrices");
    TraceFrame first = tell(factorBegin, span.values());
    drawPolygon(first, span);
    first.formula = mathml("c(t)=" + productUpTo(span.degree) + "c");
    writer.add(std::move(first));
    Row product{1};
    for (std::size_t k = 1; k <= span.degree; ++k) {
        std::vector<Row> matrix = factorMatrix(span, k);
        product = timesMatrix(product, matrix);
        writer.add(factorFrame(span, k, std::move(matrix), product));
    }
    writer.add(productFrame(span, product));
    return std::move(writer).finish("curve.points");
}

}  // namespace knotwork::scene
