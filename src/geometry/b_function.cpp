#include "geometry/b_function.hpp"

#include "geometry/jet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace knotwork {

namespace {

using namespace b_function;

constexpr std::size_t mostRows = Jet::maxOrder + 1;
constexpr std::size_t mostValues = 100'000;
constexpr int deepest = 32;
constexpr int mostEvaluations = 1024;

const BFamilyDescription& describe(BFamily family) noexcept {
    return bFunctionFamilies()[static_cast<std::size_t>(family)];
}

bool byParametersAlone(const BFamilyDescription& family) noexcept {
    return !family.tabulated && !family.expression && family.operands.empty();
}

/// The first refusal of these values, in the order of the family's parameters.
std::optional<Error> check(BFamily family, std::initializer_list<double> values) {
    const auto parameters = describe(family).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (auto error =
                checkParameter(parameters[i], values.begin()[i], std::string(parameters[i].name))) {
            return error;
        }
    }
    return std::nullopt;
}

/// B inside (0,1), kept in [0,1] against a last bit of rounding; its limits outside.
template <class Family>
double valueOf(const Family& family, double t) noexcept {
    if (!(t > 0)) return 0;
    if (t >= 1) return 1;
    return std::clamp(family.value(t), 0.0, 1.0);
}

template <class Family>
void sampleOf(const Family& family, std::span<const double> ts, std::span<double> out) noexcept {
    for (std::size_t i = 0; i < ts.size(); ++i) out[i] = valueOf(family, ts[i]);
}

void sampleOf(const Polynomial& family, std::span<const double> ts,
              std::span<double> out) noexcept {
    family.sample(ts, out);
}

void sampleOf(const ExpoRational& family, std::span<const double> ts,
              std::span<double> out) noexcept {
    family.sample(ts, out);
}

std::optional<Error> checkValue(std::span<const double> values, std::size_t i) {
    const double value = values[i];
    const auto complain = [&](Code code, const std::string& rule) {
        return refuse(code, indexed("values", i), "value " + formatNumber(value) + " " + rule);
    };
    if (!std::isfinite(value)) return complain(Code::notFinite, "is not a finite number");
    if (i == 0 && value != 0) return complain(Code::outOfRange, "must be 0: it is B(0)");
    if (i + 1 == values.size() && value != 1) {
        return complain(Code::outOfRange, "must be 1: it is B(1)");
    }
    if (i > 0 && value < values[i - 1]) {
        return complain(Code::outOfRange, "is below the one before it, " +
                                              formatNumber(values[i - 1]) +
                                              "; a B-function does not decrease");
    }
    return std::nullopt;
}

constexpr std::string_view noWarning{};

template <class Family>
std::string_view warningOf(const Family&) noexcept {
    return noWarning;
}
std::string_view warningOf(const Rational& family) noexcept {
    return family.integerPowers()
               ? noWarning
               : "m is not an integer: at the ends only derivatives below m exist";
}
std::string_view warningOf(const ExpoRational& family) noexcept {
    return family.smooth()
               ? noWarning
               : "α(1+γ) is not an even integer: at λ only derivatives up to α(1+γ) exist";
}
std::string_view warningOf(const Tabulated&) noexcept {
    return "a tabulated B-function has one continuous derivative";
}
std::string_view warningOf(const UserFormula& family) noexcept { return family.warning(); }
std::string_view firstOf(std::string_view a, std::string_view b) noexcept {
    return a.empty() ? b : a;
}
std::string_view warningOf(const Dual& family) noexcept { return family.of->warning(); }
std::string_view warningOf(const Symmetrised& family) noexcept { return family.of->warning(); }
std::string_view warningOf(const Composed& family) noexcept {
    return firstOf(family.outer->warning(), family.inner->warning());
}
std::string_view warningOf(const Mixed& family) noexcept {
    return firstOf(family.first->warning(), family.second->warning());
}

Operand share(const BFunction& function) { return std::make_shared<const BFunction>(function); }

}  // namespace

BFunction::BFunction(Form form, std::initializer_list<double> parameters) noexcept
    : form_(std::move(form)) {
    std::copy(parameters.begin(), parameters.end(), parameters_.begin());
}

Result<BFunction> BFunction::makeTrigonometric(double order) {
    if (auto error = check(BFamily::trigonometric, {order})) return *std::move(error);
    return BFunction(Trigonometric(static_cast<int>(order)), {order});
}

Result<BFunction> BFunction::makePolynomial(double p, double q) {
    if (auto error = check(BFamily::polynomial, {p, q})) return *std::move(error);
    return BFunction(Polynomial{static_cast<int>(p), static_cast<int>(q)}, {p, q});
}

Result<BFunction> BFunction::makeRational(double m, double c) {
    if (auto error = check(BFamily::rational, {m, c})) return *std::move(error);
    return BFunction(Rational{m, c}, {m, c});
}

Result<BFunction> BFunction::makeExpoRational(double alpha, double beta, double gamma,
                                              double lambda) {
    if (auto error = check(BFamily::expoRational, {alpha, beta, gamma, lambda})) {
        return *std::move(error);
    }
    return BFunction(ExpoRational(alpha, beta, gamma, lambda), {alpha, beta, gamma, lambda});
}

Result<BFunction> BFunction::makeLogistic(double c) {
    if (auto error = check(BFamily::logistic, {c})) return *std::move(error);
    return BFunction(Logistic{c}, {c});
}

Result<BFunction> BFunction::make(std::string_view family, std::span<const NamedValue> parameters) {
    const BFamilyDescription* description = findBFamily(family);
    if (description == nullptr || !byParametersAlone(*description)) {
        std::string known;
        for (const BFamilyDescription& each : bFunctionFamilies()) {
            if (!byParametersAlone(each)) continue;
            known += (known.empty() ? "" : ", ") + std::string(each.name);
        }
        return refuse(Code::unknownName, "family",
                      "\"" + std::string(family) +
                          "\" is not a family given by parameters alone; "
                          "known: " +
                          known);
    }
    const auto values = readParameters(description->parameters, parameters, "");
    if (!values) return values.error();
    const std::vector<double>& v = *values;
    switch (description->family) {
        case BFamily::trigonometric:
            return makeTrigonometric(v[0]);
        case BFamily::polynomial:
            return makePolynomial(v[0], v[1]);
        case BFamily::rational:
            return makeRational(v[0], v[1]);
        case BFamily::expoRational:
            return makeExpoRational(v[0], v[1], v[2], v[3]);
        case BFamily::logistic:
            return makeLogistic(v[0]);
        default:
            return BFunction();
    }
}

Result<BFunction> BFunction::makeTabulated(std::span<const double> values) {
    if (values.size() < 2) {
        return refuse(Code::wrongLength, "values",
                      "a table has " + std::to_string(values.size()) + " values and needs 2");
    }
    if (values.size() > mostValues) {
        return refuse(Code::tooLarge, "values",
                      "a table has " + std::to_string(values.size()) + " values, the most is " +
                          std::to_string(mostValues));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (auto error = checkValue(values, i)) return *std::move(error);
    }
    return BFunction(Tabulated(values), {});
}

Result<BFunction> BFunction::makeFormula(std::string_view expression) {
    auto made = UserFormula::make(expression);
    if (!made) return made.error();
    return BFunction(*std::move(made), {});
}

Result<BFunction> BFunction::nest(Form form, std::initializer_list<double> parameters,
                                  std::span<const BFunction* const> operands) {
    BFunction nested(std::move(form), parameters);
    nested.evaluations_ = 0;
    for (const BFunction* operand : operands) {
        nested.depth_ = std::max(nested.depth_, operand->depth_ + 1);
        nested.evaluations_ += operand->evaluations_;
    }
    if (nested.depth_ > deepest) {
        return refuse(Code::tooLarge, "", "B-functions are nested deeper than 32");
    }
    if (nested.evaluations_ > mostEvaluations) {
        return refuse(Code::tooLarge, "",
                      "one value would take more than 1024 evaluations of nested B-functions");
    }
    return nested;
}

Result<BFunction> BFunction::makeDual(const BFunction& of) {
    const std::array operands{&of};
    return nest(Dual{share(of)}, {}, operands);
}

Result<BFunction> BFunction::makeSymmetrised(const BFunction& of) {
    const std::array operands{&of, &of};
    return nest(Symmetrised{share(of)}, {}, operands);
}

Result<BFunction> BFunction::makeComposed(const BFunction& outer, const BFunction& inner) {
    const std::array operands{&outer, &inner};
    return nest(Composed{share(outer), share(inner)}, {}, operands);
}

Result<BFunction> BFunction::makeMixed(const BFunction& first, const BFunction& second,
                                       double weight) {
    if (auto error = check(BFamily::mixed, {weight})) return *std::move(error);
    const std::array operands{&first, &second};
    return nest(Mixed{share(first), share(second), weight}, {weight}, operands);
}

double BFunction::value(double t) const noexcept {
    return std::visit([t](const auto& family) { return valueOf(family, t); }, form_);
}

void BFunction::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.empty()) return;
    std::fill(rows.begin(), rows.end(), 0.0);
    if (t >= 0 && t <= 1) {
        const auto computed = rows.first(std::min(rows.size(), mostRows));
        std::visit([&](const auto& family) { family.derivatives(t, computed); }, form_);
        for (double& row : computed) {
            if (!std::isfinite(row)) row = 0;
        }
    }
    rows[0] = value(t);
}

void BFunction::sample(std::span<const double> ts, std::span<double> values) const noexcept {
    const auto inputs = ts.first(std::min(ts.size(), values.size()));
    std::visit([&](const auto& family) { sampleOf(family, inputs, values); }, form_);
}

void BFunction::sampleUniform(std::span<double> values) const noexcept {
    const double last = values.size() > 1 ? static_cast<double>(values.size() - 1) : 1;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) / last;
    sample(values, values);
}

void BFunction::sampleDerivatives(std::span<const double> ts,
                                  std::span<double> rows) const noexcept {
    if (ts.empty()) return;
    const std::size_t count = std::min(rows.size() / ts.size(), mostRows);
    std::array<double, mostRows> buffer;
    const auto one = std::span(buffer).first(count);
    for (std::size_t i = 0; i < ts.size(); ++i) {
        derivatives(ts[i], one);
        for (std::size_t k = 0; k < count; ++k) rows[k * ts.size() + i] = one[k];
    }
}

std::array<double, 2> BFunction::powers() const noexcept {
    return std::visit([](const auto& family) { return family.powers(); }, form_);
}

std::array<double, 2> BFunction::order() const noexcept {
    const auto [atStart, atEnd] = powers();
    return {std::ceil(atStart) - 1, std::ceil(atEnd) - 1};
}

bool BFunction::symmetric() const noexcept {
    return std::visit([](const auto& family) { return family.symmetric(); }, form_);
}

bool BFunction::smooth() const noexcept { return warning().empty(); }

std::string_view BFunction::warning() const noexcept {
    return std::visit([](const auto& family) { return warningOf(family); }, form_);
}

const BFamilyDescription& BFunction::description() const noexcept { return describe(family()); }

std::span<const double> BFunction::parameters() const noexcept {
    return std::span(parameters_).first(description().parameters.size());
}

std::span<const double> BFunction::values() const noexcept {
    const auto* tabulated = std::get_if<Tabulated>(&form_);
    return tabulated != nullptr ? tabulated->values() : std::span<const double>();
}

std::string_view BFunction::expression() const noexcept {
    const auto* formula = std::get_if<UserFormula>(&form_);
    return formula != nullptr ? formula->expression() : std::string_view();
}

std::vector<BFunction> BFunction::operands() const {
    if (const auto* dual = std::get_if<Dual>(&form_)) return {*dual->of};
    if (const auto* symmetrised = std::get_if<Symmetrised>(&form_)) return {*symmetrised->of};
    if (const auto* composed = std::get_if<Composed>(&form_)) {
        return {*composed->outer, *composed->inner};
    }
    if (const auto* mixed = std::get_if<Mixed>(&form_)) return {*mixed->first, *mixed->second};
    return {};
}

bool operator==(const BFunction& a, const BFunction& b) noexcept {
    if (a.family() != b.family() || a.parameters_ != b.parameters_) return false;
    if (a.expression() != b.expression()) return false;
    const auto valuesA = a.values();
    const auto valuesB = b.values();
    return std::equal(valuesA.begin(), valuesA.end(), valuesB.begin(), valuesB.end()) &&
           a.operands() == b.operands();
}

}  // namespace knotwork
