#include "properties/generators.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>
#include <utility>

namespace knotwork::test {

namespace {

std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string list(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ", ") + digits(value);
    return '[' + text + ']';
}

std::string point(const Vec3& p) { return list({p.x, p.y, p.z}); }

const char* nameOf(Form form) {
    return form == Form::clamped ? "clamped" : form == Form::open ? "open" : "closed";
}

/// 0, something between 1e-9 and 1e-4, or something ordinary.
double gap(bool nearlyEqual, bool positive) {
    const int kind = *whole(0, 9);
    if (kind >= 8 && nearlyEqual) return (1 + std::abs(*real(8))) * std::pow(10, -*whole(5, 9));
    if (kind >= 5 && !positive) return 0;
    return 0.125 + std::abs(*real(2));
}

struct Limits {
    int first;  // multiplicity up to which the first knot may grow
    int last;   // and the last
    int inner;
};

/// `count` knots, the gap after `ordinary` of them an ordinary one, so that the domain is no point.
std::vector<double> run(int count, int ordinary, const Limits& limits, bool nearlyEqual) {
    std::vector<double> knots{*real(3)};
    int times = 1;
    int most = limits.first;
    for (int i = 1; i < count; ++i) {
        const bool endsRight = i + 1 == count && times >= limits.last;
        const bool positive = times >= most || endsRight || i == ordinary;
        const double step = gap(nearlyEqual && i != ordinary, positive);
        if (step > 0) {
            times = 0;
            most = limits.inner;
        }
        ++times;
        knots.push_back(knots.back() + step);
    }
    return knots;
}

std::vector<double> clampedKnots(int degree, int count, bool nearlyEqual) {
    const int spans = count - degree;
    std::vector<double> knots = run(spans + 1, *whole(1, spans), {1, 1, degree + 1}, nearlyEqual);
    const auto more = static_cast<std::size_t>(degree);
    knots.insert(knots.begin(), more, knots.front());
    knots.insert(knots.end(), more, knots.back());
    return knots;
}

std::vector<double> knotsOf(int d, Form form, int count, bool nearlyEqual) {
    switch (form) {
        case Form::clamped:
            return clampedKnots(d, count, nearlyEqual);
        case Form::open: {
            const int ordinary = *whole(d + 1, count);
            return run(count + d + 1, ordinary, {d + 1, d, d + 1}, nearlyEqual);
        }
        case Form::closed:
            // The seam is one knot: it may be multiple at one end of the period.
            if (*whole(0, 1) == 0) return run(count + 1, count, {d, 1, d + 1}, nearlyEqual);
            return run(count + 1, 1, {1, d, d + 1}, nearlyEqual);
    }
    return {};
}

BFunctionCase made(const Result<BFunction>& function, std::string text) {
    RC_PRE(function.ok());
    return {*function, std::move(text)};
}

std::string field(const char* name, double value) {
    return std::string(", ") + name + ": " + digits(value);
}

double between(double from, double to) { return from + (to - from) * std::abs(*real(1)); }

/// Within (0, most], many of them small.
double positive(double most) { return most * std::pow(10, -between(0, 4)); }

BFunctionCase expoRational(bool wide) {
    const double alpha = wide ? positive(4) : between(0.5, 2);
    const double beta = wide ? positive(100) : between(0.3, 3);
    const double gamma = wide ? positive(4) : between(0.5, 2);
    const double lambda = wide ? between(1e-6, 1 - 1e-6) : between(0.2, 0.8);
    return made(BFunction::makeExpoRational(alpha, beta, gamma, lambda),
                "{ family: 'expo-rational'" + field("alpha", alpha) + field("beta", beta) +
                    field("gamma", gamma) + field("lambda", lambda) + " }");
}

BFunctionCase tabulated() {
    std::vector<double> values{0};
    const int count = *whole(2, 12);
    for (int i = 1; i < count; ++i) {
        values.push_back(values.back() + (*whole(0, 4) == 0 ? 0 : 0.01 + std::abs(*real(1))));
    }
    const double last = values.back();
    if (last == 0) values.back() = 1;
    if (last > 0) {
        for (double& value : values) value /= last;
    }
    values.back() = 1;
    return made(BFunction::makeTabulated(values),
                "{ family: 'tabulated', values: " + list(values) + " }");
}

BFunctionCase family(bool wide) {
    switch (*whole(0, 6)) {
        case 0:
            return {BFunction(), "{ family: 'linear' }"};
        case 1: {
            const int order = *whole(1, wide ? 20 : 4);
            return made(BFunction::makeTrigonometric(order),
                        "{ family: 'trigonometric'" + field("order", order) + " }");
        }
        case 2: {
            const int p = *whole(0, wide ? 20 : 4);
            const int q = *whole(0, wide ? 20 : 4);
            return made(BFunction::makePolynomial(p, q),
                        "{ family: 'polynomial'" + field("p", p) + field("q", q) + " }");
        }
        case 3: {
            const double m =
                *whole(0, 1) == 0 ? *whole(1, wide ? 50 : 5) : between(1, wide ? 50 : 5);
            const double c = wide ? positive(1000) : between(0.25, 4);
            return made(BFunction::makeRational(m, c),
                        "{ family: 'rational'" + field("m", m) + field("c", c) + " }");
        }
        case 4:
            return expoRational(wide);
        case 5: {
            const double c = wide ? positive(1000) : between(0.3, 3);
            return made(BFunction::makeLogistic(c), "{ family: 'logistic'" + field("c", c) + " }");
        }
        default:
            return tabulated();
    }
}

BFunctionCase nested(int depth) {
    const int kind = depth == 0 ? 0 : *whole(0, 6);
    if (kind < 3) return family(false);
    const BFunctionCase a = nested(depth - 1);
    if (kind == 3) {
        return made(BFunction::makeDual(a.function), "{ family: 'dual', of: " + a.spec + " }");
    }
    if (kind == 4) {
        return made(BFunction::makeSymmetrised(a.function),
                    "{ family: 'symmetrised', of: " + a.spec + " }");
    }
    const BFunctionCase b = nested(depth - 1);
    if (kind == 5) {
        return made(BFunction::makeComposed(a.function, b.function),
                    "{ family: 'composed', outer: " + a.spec + ", inner: " + b.spec + " }");
    }
    const double weight = std::abs(*real(1));
    return made(
        BFunction::makeMixed(a.function, b.function, weight),
        "{ family: 'mixed', of: [" + a.spec + ", " + b.spec + ']' + field("weight", weight) + " }");
}

struct Model {
    Curve curve;
    std::string spec;
};

Model anyModel() {
    static constexpr const char* names[] = {"circle",  "ellipse", "lissajous", "heart",
                                            "viviani", "helix",   "butterfly", "trefoil"};
    const std::string name = names[*whole(0, 7)];
    if (name == "butterfly") {  // two turns of it: not closed, and short enough to be gentle
        const Interval domain{0, 12.5};
        return {ParametricCurve::make(name, {}, domain).value(),
                "{ type: 'parametric-curve', name: 'butterfly', domain: [0, 12.5] }"};
    }
    return {ParametricCurve::make(name).value(),
            "{ type: 'parametric-curve', name: '" + name + "' }"};
}

Pose anyPose() {
    Pose pose;
    const int dimension = *whole(0, 3) == 0 ? 3 : 2;
    pose.translate = *spacePoint(1, dimension);
    pose.angle = *real(3);
    if (dimension == 3) pose.axis = {*real(1), *real(1), 1};
    pose.scale = {1 + *real(0.5), 1 + *real(0.5), 1};
    return pose;
}

/// One knot a local (and the end of the period), over the model's domain.
std::vector<double> blendKnots(const Interval& domain, std::size_t number, bool doubleKnots) {
    std::vector<double> steps{0};
    for (std::size_t i = 1; i < number; ++i) {
        const bool again = doubleKnots && i > 1 && i + 1 < number && steps[i - 1] > steps[i - 2] &&
                           *whole(0, 5) == 0;
        steps.push_back(steps.back() + (again ? 0 : 0.25 + std::abs(*real(1))));
    }
    std::vector<double> knots;
    for (const double step : steps) {
        knots.push_back(domain.start + domain.length() * (step / steps.back()));
    }
    knots.back() = domain.end;
    return knots;
}

}  // namespace

// Without resizing rapidcheck's numbers would grow with the number of the case.
rc::Gen<int> whole(int from, int to) {
    return rc::gen::resize(100, rc::gen::inRange(from, to + 1));
}

rc::Gen<double> real(double size) {
    constexpr int most = 1 << 30;
    return rc::gen::map(whole(0, most - 1), [size](int k) {
        const double share = static_cast<double>(k / 2) / (most / 2);
        return k % 2 == 0 ? size * share : -size * share;
    });
}

rc::Gen<Vec3> spacePoint(double size, int dimension) {
    return rc::gen::exec([size, dimension] {
        const double x = *real(size);
        const double y = *real(size);
        return Vec3(x, y, dimension == 3 ? *real(size) : 0);
    });
}

std::string text(const std::vector<double>& values) { return list(values); }

std::string text(const Vec3& p) { return point(p); }

std::string text(Form form) { return nameOf(form); }

std::string text(const Pose& pose) {
    return "translate: " + point(pose.translate) + ", rotate: { axis: " + point(pose.axis) +
           ", angle: " + digits(pose.angle) + " }, scale: " + point(pose.scale);
}

rc::Gen<Pose> somePose() {
    return rc::gen::exec([] { return *whole(0, 2) == 0 ? Pose{} : anyPose(); });
}

rc::Gen<std::vector<double>> blendingKnots(const Interval& domain, std::size_t number,
                                           bool doubleKnots) {
    return rc::gen::exec([=] { return blendKnots(domain, number, doubleKnots); });
}

KnotVector KnotsCase::knotVector() const {
    auto made = KnotVector::make(knots, degree, count, form);
    if (!made.ok()) RC_FAIL(made.error().path + ": " + made.error().message);
    return std::move(made).value();
}

rc::Gen<KnotsCase> anyKnots(int maxDegree, int maxSpans, bool nearlyEqual) {
    return rc::gen::exec([=] {
        const int degree = *whole(1, maxDegree);
        const auto form = static_cast<Form>(*whole(0, 2));
        const int count = degree + *whole(1, maxSpans);
        return KnotsCase{degree, form, count, knotsOf(degree, form, count, nearlyEqual)};
    });
}

KnotVector SplineCase::knotVector() const {
    return KnotsCase{degree, form, static_cast<int>(points.size()), knots}.knotVector();
}

BsplineCurve SplineCase::curve() const {
    auto made = BsplineCurve::make(knotVector(), points, dimension, weights);
    if (!made.ok()) RC_FAIL(made.error().path + ": " + made.error().message);
    return std::move(made).value();
}

void showValue(const SplineCase& spline, std::ostream& out) {
    out << "{ type: 'bspline-curve', degree: " << spline.degree << ", form: '"
        << nameOf(spline.form) << "', points: [";
    for (const Vec3& p : spline.points) out << point(p) << ", ";
    out << "], knots: " << list(spline.knots);
    if (!spline.weights.empty()) out << ", weights: " << list(spline.weights);
    out << " }";
}

rc::Gen<SplineCase> anySpline(const SplineOptions& options) {
    return rc::gen::exec([options] {
        SplineCase spline;
        spline.degree = *whole(1, options.maxDegree);
        spline.form = static_cast<Form>(*whole(0, 2));
        spline.dimension = *whole(2, 3);
        const int count = spline.degree + *whole(1, 10);
        spline.knots = knotsOf(spline.degree, spline.form, count, options.nearlyEqualKnots);
        const bool rational = options.rational && *whole(0, 2) == 2;
        for (int i = 0; i < count; ++i) {
            spline.points.push_back(*spacePoint(options.size, spline.dimension));
            if (rational) spline.weights.push_back(0.25 + std::abs(*real(2.75)));
        }
        return spline;
    });
}

void showValue(const BFunctionCase& blend, std::ostream& out) { out << blend.spec; }

rc::Gen<BFunctionCase> anyFamily() {
    return rc::gen::exec([] { return family(true); });
}

rc::Gen<BFunctionCase> anyBFunction(int depth) {
    return rc::gen::exec([depth] { return nested(depth); });
}

BlendingCurve BlendingCase::curve() const {
    auto made = BlendingCurve::fromModel(model, count, form, blend.function, knots, poses);
    if (!made.ok()) RC_FAIL(made.error().path + ": " + made.error().message);
    return std::move(made).value();
}

void showValue(const BlendingCase& blending, std::ostream& out) {
    out << "{ type: 'blending-curve', bFunction: " << blending.blend.spec
        << ", model: " << blending.modelSpec << ", locals: { count: " << blending.count
        << ", kind: 'sub-curve' }, form: '"
        << (blending.form == BlendForm::open ? "open" : "closed")
        << "', knots: " << list(blending.knots) << ", poses: [";
    for (std::size_t j = 0; j < blending.poses.size(); ++j) {
        out << "{ local: " << j << ", " << text(blending.poses[j]) << " }, ";
    }
    out << "] }";
}

rc::Gen<BlendingCase> anyBlending(bool doubleKnots) {
    return rc::gen::exec([doubleKnots] {
        Model model = anyModel();
        const auto count = static_cast<std::size_t>(*whole(2, 7));
        const BlendForm form = *whole(0, 1) == 0 ? BlendForm::open : BlendForm::closed;
        const std::size_t number = form == BlendForm::closed ? count + 1 : count;
        BFunctionCase blend = nested(1);
        std::vector<double> knots = blendKnots(domain(model.curve), number, doubleKnots);
        std::vector<Pose> poses;
        for (std::size_t j = 0; j < count; ++j) {
            poses.push_back(*whole(0, 2) == 0 ? Pose{} : anyPose());
        }
        return BlendingCase{std::move(model.curve), std::move(model.spec), count,           form,
                            std::move(blend),       std::move(knots),      std::move(poses)};
    });
}

rc::Gen<std::vector<double>> parametersOf(const Interval& domain, std::vector<double> knots,
                                          int between) {
    return rc::gen::exec([domain, knots, between] {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        std::vector<double> ts{domain.start, domain.end};
        for (const double knot : knots) {
            for (const double t :
                 {std::nextafter(knot, -infinity), knot, std::nextafter(knot, infinity)}) {
                if (domain.contains(t)) ts.push_back(t);
            }
        }
        for (int i = 0; i < between; ++i) {
            ts.push_back(domain.start + domain.length() * std::abs(*real(1)));
        }
        std::sort(ts.begin(), ts.end());
        ts.erase(std::unique(ts.begin(), ts.end()), ts.end());
        return ts;
    });
}

}  // namespace knotwork::test
