// Subdivision of polygons, pass by pass: Lane and Riesenfeld's doubling and averaging (A
// theoretical development for the computer generation and display of piecewise polynomial surfaces,
// 1980), and the four-point scheme (N. Dyn, D. Levin, J. Gregory, A 4-point interpolatory subdivision scheme
// for curve design, 1987).
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_parts.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

constexpr Sentence laneBegin{
    "lane-riesenfeld.begin", "A polygon of {count} points",
    "The {form} polygon has {count} points; every level puts a point into the middle of each "
    "leg and then replaces the points by the middles of the legs, one time less often than the "
    "degree, {degree}."};
constexpr Sentence laneDouble{
    "lane-riesenfeld.double", "Level {level}: doubling",
    "Doubling at level {level}: the middle of each leg becomes a point between its ends, which "
    "makes {after} points of {before} and is all that degree 1 needs; the first one is {point}."};
constexpr Sentence laneAverage{
    "lane-riesenfeld.average", "Level {level}: averaging pass {pass} of {passes}",
    "Averaging pass {pass} of {passes} at level {level}: the {after} middles of the legs take the "
    "place of the {before} points and raise the degree to {reached}; the first one is {point}."};
constexpr Sentence laneLevel{
    "lane-riesenfeld.level", "Level {level} of {levels}",
    "After level {level} of {levels} the polygon has {after} points; all in all, each is a mix "
    "of the points before with every other one of the weights {mask}."};

constexpr Sentence fourBegin{
    "four-point.begin", "A polygon of {count} points",
    "The {form} polygon has {count} points, which all stay; every level puts a new point on "
    "each leg, made of the four points around with the tension {tension}."};
constexpr Sentence fourNew{
    "four-point.new", "Level {level}: new points",
    "New points at level {level}: the two ends of each leg count {near} each and their outer "
    "neighbours {far} each, which makes {made} new points; the first one is {point}."};
constexpr Sentence fourLevel{
    "four-point.level", "Level {level} of {levels}",
    "After level {level} of {levels} the polygon has {after} points, every other one of them a "
    "point of the polygon before."};

using Polygon = std::vector<Vec3>;

/// How points of this polygon are read.
struct Reader {
    explicit Reader(const CurveSubdivision& input)
        : places(readingOf(input.points)),
          dimension(std::all_of(input.points.begin(), input.points.end(),
                                [](const Vec3& point) { return point.z == 0; })
                        ? 2
                        : 3) {}
    std::string text(const Vec3& point) const { return readable(point, dimension, places); }
    std::string note(const Vec3& point) const { return noted(point, dimension, places); }

    Reading places;
    int dimension;
};

/// The middles of the legs.
Polygon averaged(const Polygon& points, bool closed) {
    Polygon middles;
    const std::size_t legs = closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < legs; ++i) {
        middles.push_back(0.5 * (points[i] + points[(i + 1) % points.size()]));
    }
    return middles;
}

/// The points with others between them.
Polygon interleaved(const Polygon& points, const Polygon& between) {
    Polygon all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        all.push_back(points[i]);
        if (i < between.size()) all.push_back(between[i]);
    }
    return all;
}

std::string point(std::string_view letter, std::size_t i) { return indexedTerm(letter, i); }

/// Q_{first + step i} = (P_i + P_{i+1}) / 2 with its numbers.
std::string averageFormula(const Reader& reader, const Polygon& before, const Polygon& middles,
                           std::size_t first, std::size_t step) {
    NotedRows rows;
    for (std::size_t i = 0; i < middles.size(); ++i) {
        const std::size_t next = (i + 1) % before.size();
        rows.add(point("Q", first + step * i) + "&=&" +
                 fraction(point("P", i) + "+" + point("P", next), "2") + "=" +
                 fraction(reader.note(before[i]) + "+" + reader.note(before[next]), "2") + "=" +
                 reader.note(middles[i]));
    }
    return mathml(rows.table());
}

/// The weights of a whole level, binomial(d+1, i) / 2^d.
std::vector<double> levelMask(int degree) {
    std::vector<double> mask{1, 1};
    for (int k = 1; k <= degree; ++k) {
        mask.push_back(0);
        for (std::size_t i = mask.size() - 1; i > 0; --i) mask[i] = 0.5 * (mask[i] + mask[i - 1]);
        mask[0] *= 0.5;
    }
    return mask;
}

/// Q_{2i} and Q_{2i+1}, each with every other weight.
std::string maskFormula(std::span<const double> mask) {
    std::string even = "Q_{2i}&=&";
    std::string odd = "Q_{2i+1}&=&";
    for (std::size_t k = 0; k < mask.size(); ++k) {
        std::string& text = k % 2 == 0 ? odd : even;
        const std::string later = k < 2 ? "" : '+' + std::to_string(k / 2);
        text += (k < 2 ? "" : "+") + noted(mask[k]) + "P_{i" + later + '}';
    }
    return mathml("\\table{" + even + "\\\\" + odd + '}');
}

std::string counted(int number) { return std::to_string(number); }

TraceFrame beginFrame(const Sentence& sentence, const CurveSubdivision& input,
                      SentenceValues values) {
    values.insert(values.end(), {{"form", input.closed ? "closed" : "open"},
                                 {"count", readable(input.points.size())}});
    TraceFrame frame = tell(sentence, std::move(values));
    addPolygon(frame, input.points, input.closed);
    return frame;
}

TraceFrame levelFrame(const Sentence& sentence, const CurveSubdivision& input, int level,
                      const Polygon& points, SentenceValues values) {
    values.insert(values.end(), {{"level", counted(level)},
                                 {"levels", counted(input.levels)},
                                 {"after", readable(points.size())}});
    TraceFrame frame = tell(sentence, std::move(values));
    addPolygon(frame, points, input.closed);
    return frame;
}

TraceFrame doubleFrame(const CurveSubdivision& input, const Reader& reader, int level,
                       const Polygon& before, const Polygon& middles) {
    TraceFrame frame = tell(laneDouble, {{"level", counted(level)},
                                         {"before", readable(before.size())},
                                         {"after", readable(before.size() + middles.size())},
                                         {"point", reader.text(middles.front())}});
    addPolygon(frame, interleaved(before, middles), input.closed);
    for (std::size_t i = 0; i < middles.size(); ++i) frame.marked.push_back(2 * i + 1);
    frame.weights = {0.5, 0.5};
    frame.formula = averageFormula(reader, before, middles, 1, 2);
    return frame;
}

TraceFrame averageFrame(const CurveSubdivision& input, const Reader& reader,
                        SentenceValues values, const Polygon& before, const Polygon& middles) {
    values.insert(values.end(), {{"before", readable(before.size())},
                                 {"after", readable(middles.size())},
                                 {"point", reader.text(middles.front())}});
    TraceFrame frame = tell(laneAverage, std::move(values));
    addPolygon(frame, before, input.closed);
    addMarked(frame, middles, input.closed);
    frame.weights = {0.5, 0.5};
    frame.formula = averageFormula(reader, before, middles, 0, 1);
    return frame;
}

Polygon fourPointMiddles(const Polygon& points, bool closed, double tension) {
    const std::size_t n = points.size();
    const auto at = [&](std::size_t i, int by) {
        const std::size_t k = by < 0 ? i + n - 1 : i + static_cast<std::size_t>(by);
        if (closed || (by < 0 && i > 0)) return points[k % n];
        if (by < 0) return 2.0 * points[0] - points[1];
        return k < n ? points[k] : 2.0 * points[n - 1] - points[n - 2];
    };
    Polygon middles;
    for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
        middles.push_back((0.5 + tension) * (points[i] + at(i, 1)) -
                          tension * (at(i, -1) + at(i, 2)));
    }
    return middles;
}

std::string fourPointFormula(const Reader& reader, const Polygon& middles, std::size_t count,
                             bool closed, double tension) {
    NotedRows rows;
    const auto number = [&](std::size_t i, std::size_t by) {
        if (closed) return point("P", (i + by + count - 1) % count);
        return i + by == 0 ? std::string("P_{-1}") : point("P", i + by - 1);
    };
    for (std::size_t i = 0; i < middles.size(); ++i) {
        rows.add(point("Q", 2 * i + 1) + "&=&" + noted(0.5 + tension) + "(" + number(i, 1) + "+" +
                 number(i, 2) + ")" + (tension < 0 ? "+" + noted(-tension) : "-" + noted(tension)) +
                 "(" + number(i, 0) + "+" + number(i, 3) + ")=" + reader.note(middles[i]));
    }
    return mathml(rows.table());
}

/// The polygon, and over each leg the two legs by way of its new point.
TraceFrame newPointsFrame(const CurveSubdivision& input, const Reader& reader,
                          const Polygon& points, const Polygon& middles, int level) {
    const double tension = input.tension;
    TraceFrame frame = tell(fourNew, {{"level", counted(level)},
                                      {"near", readable(0.5 + tension)},
                                      {"far", readable(-tension)},
                                      {"made", readable(middles.size())},
                                      {"point", reader.text(middles.front())}});
    const std::size_t count = points.size();
    addPolygon(frame, points, input.closed);
    for (std::size_t i = 0; i < middles.size(); ++i) {
        frame.marked.push_back(frame.points.size());
        frame.points.push_back(middles[i]);
        frame.edges.push_back({i, count + i});
        frame.edges.push_back({count + i, (i + 1) % count});
    }
    frame.weights = {-tension, 0.5 + tension, 0.5 + tension, -tension};
    frame.formula = fourPointFormula(reader, middles, count, input.closed, tension);
    return frame;
}

}  // namespace

Result<Trace> traceLaneRiesenfeld(const CurveSubdivision& input) {
    if (auto checked = checkSubdivision(input, mostTracedPoints); !checked) return checked.error();
    const Reader reader(input);
    const int degree = input.degree;
    const std::vector<double> mask = levelMask(degree);
    Polygon points = input.points;
    TraceWriter writer("lane-riesenfeld");
    writer.add(beginFrame(laneBegin, input, {{"degree", counted(degree)}}));
    for (int level = 1; level <= input.levels && !writer.full(); ++level) {
        const Polygon middles = averaged(points, input.closed);
        writer.add(doubleFrame(input, reader, level, points, middles));
        points = interleaved(points, middles);
        for (int pass = 1; pass < degree && !writer.full(); ++pass) {
            Polygon next = averaged(points, input.closed);
            writer.add(averageFrame(input, reader,
                                    {{"level", counted(level)}, {"pass", counted(pass)},
                                     {"passes", counted(degree - 1)},
                                     {"reached", counted(pass + 1)}},
                                    points, next));
            points = std::move(next);
        }
        TraceFrame done = levelFrame(laneLevel, input, level, points, {{"mask", spoken(mask)}});
        done.weights = mask;
        done.formula = maskFormula(mask);
        writer.add(std::move(done));
    }
    return std::move(writer).finish("levels");
}

Result<Trace> traceFourPoint(const CurveSubdivision& input) {
    if (auto checked = checkSubdivision(input, mostTracedPoints); !checked) return checked.error();
    const Reader reader(input);
    Polygon points = input.points;
    TraceWriter writer("four-point");
    writer.add(beginFrame(fourBegin, input, {{"tension", readable(input.tension)}}));
    for (int level = 1; level <= input.levels && !writer.full(); ++level) {
        const Polygon middles = fourPointMiddles(points, input.closed, input.tension);
        writer.add(newPointsFrame(input, reader, points, middles, level));
        points = interleaved(points, middles);
        writer.add(levelFrame(fourLevel, input, level, points, {}));
    }
    return std::move(writer).finish("levels");
}

}  // namespace knotwork::scene
