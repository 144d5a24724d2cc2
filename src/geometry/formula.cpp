#include "geometry/formula.hpp"

#include "geometry/formula_program.hpp"
#include "geometry/formula_tokens.hpp"
#include "geometry/named.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace knotwork {

using namespace formula;

namespace {

constexpr std::size_t mostParameters = 1000;
constexpr std::size_t shallowDepth = 8;
/// Integer exponents up to here are multiplied out; beyond, pow() has fewer roundings.
constexpr double largestMultiplied = 1024;

struct NamedOp {
    std::string_view name;
    Op op;
};
constexpr std::array functions{
    NamedOp{"sin", Op::sin},   NamedOp{"cos", Op::cos},   NamedOp{"tan", Op::tan},
    NamedOp{"asin", Op::asin}, NamedOp{"acos", Op::acos}, NamedOp{"atan", Op::atan},
    NamedOp{"sinh", Op::sinh}, NamedOp{"cosh", Op::cosh}, NamedOp{"tanh", Op::tanh},
    NamedOp{"exp", Op::exp},   NamedOp{"log", Op::log},   NamedOp{"sqrt", Op::sqrt},
    NamedOp{"abs", Op::abs}};

const NamedOp* findFunction(std::string_view name) noexcept {
    return findNamed(functions, &NamedOp::name, name);
}

constexpr std::array otherNames{NamedOp{"ln", Op::log}, NamedOp{"arcsin", Op::asin},
                                NamedOp{"arccos", Op::acos}, NamedOp{"arctan", Op::atan},
                                NamedOp{"tg", Op::tan}};

/// A name of ours that is written otherwise elsewhere, or with other capitals; empty for no such.
std::string_view likelyName(std::string_view name) {
    std::string small(name);
    for (char& c : small) {
        if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    for (const NamedOp& function : functions) {
        const bool elsewhere =
            std::any_of(otherNames.begin(), otherNames.end(), [&](const NamedOp& other) {
                return other.name == small && other.op == function.op;
            });
        if (elsewhere || function.name == small) return function.name;
    }
    for (const std::string_view constant : {"t", "pi", "e"}) {
        if (constant == small) return constant;
    }
    return {};
}

// --- the program ---------------------------------------------------------------------------------

/// Appends instructions in postfix order, and computes at once what does not depend on t.
class Compiler {
public:
    void push(Instruction instruction) {
        starts_.push_back(program_.size());
        program_.push_back(instruction);
    }

    void apply(Op op) {
        const bool known = isNumber(starts_.back(), program_.size());
        program_.push_back({op, 0});
        if (known) fold(starts_.back());
    }

    void join(Op op) {
        const std::size_t right = starts_.back();
        starts_.pop_back();
        const std::size_t left = starts_.back();
        const bool leftKnown = isNumber(left, right);
        if (isNumber(right, program_.size())) {
            const double c = program_.back().number;
            program_.pop_back();
            program_.push_back(withRight(op, c));
            if (leftKnown) fold(left);
        } else if (leftKnown) {
            const double c = program_[left].number;
            program_.erase(program_.begin() + static_cast<std::ptrdiff_t>(left));
            program_.push_back(withLeft(op, c));
        } else {
            program_.push_back({op, 0});
        }
    }

    [[nodiscard]] std::vector<Instruction> take() { return std::move(program_); }

private:
    [[nodiscard]] bool isNumber(std::size_t first, std::size_t end) const noexcept {
        return end == first + 1 && program_[first].op == Op::number;
    }

    /// What stands from `start` on depends on no t: its number instead.
    void fold(std::size_t start) {
        const double value = run<2>(std::span(program_).subspan(start), 0.0);
        program_.resize(start);
        program_.push_back({Op::number, value});
    }

    /// x op c.
    static Instruction withRight(Op op, double c) noexcept {
        switch (op) {
            case Op::add: return {Op::addNumber, c};
            case Op::subtract: return {Op::addNumber, -c};
            case Op::multiply: return {Op::multiplyNumber, c};
            case Op::divide: return {Op::divideNumber, c};
            default: break;
        }
        const bool multiplied = c == std::trunc(c) && std::abs(c) <= largestMultiplied;
        return {multiplied ? Op::integerPower : Op::realPower, c};
    }

    /// c op x.
    static Instruction withLeft(Op op, double c) noexcept {
        switch (op) {
            case Op::add: return {Op::addNumber, c};
            case Op::subtract: return {Op::subtractFrom, c};
            case Op::multiply: return {Op::multiplyNumber, c};
            case Op::divide: return {Op::divideInto, c};
            default: break;
        }
        if (c == std::numbers::e) return {Op::exp, 0};
        return {Op::exponential, c};
    }

    std::vector<Instruction> program_;
    std::vector<std::size_t> starts_;  // of the operands that wait, in program_
};

std::size_t depthOf(std::span<const Instruction> program) noexcept {
    std::size_t depth = 0;
    std::size_t deepest = 0;
    for (const Instruction& instruction : program) {
        if (instruction.op == Op::variable || instruction.op == Op::number) ++depth;
        if (joins(instruction.op)) --depth;
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

// --- the language --------------------------------------------------------------------------------

constexpr std::string_view operandWanted = "a number, a name or \"(\"";
constexpr std::string_view operatorWanted = "one of + - * / ^ or the end";
constexpr std::string_view closeWanted = "one of + - * / ^ or \")\"";

class Parser {
public:
    Parser(std::string_view text, std::string_view path, std::span<const NamedValue> parameters)
        : text_(text), path_(path), parameters_(parameters) {}

    Result<std::vector<Instruction>> read() {
        for (advance();;) {
            if (auto error = readOperand()) return *std::move(error);
            bool more = false;
            if (auto error = readOperator(more)) return *std::move(error);
            if (!more) return compiler_.take();
        }
    }

private:
    using MaybeError = std::optional<Error>;

    /// What waits for its right operand or its closing parenthesis. A function waits below the
    /// parenthesis of its argument.
    struct Pending {
        Op op = Op::number;
        int precedence = 0;  // 0: a parenthesis, and what stands before it
        bool isParenthesis = false;
        std::size_t at = 0;
    };
    static constexpr int signPrecedence = 3;
    static constexpr int powerPrecedence = 4;

    void advance() { token_ = nextToken(text_, token_.at + token_.text.size()); }

    [[nodiscard]] Error wrong(std::string_view expected) const {
        return unexpected(text_, path_, token_, expected);
    }

    /// Signs, parentheses and functions up to a number or a name, and that.
    MaybeError readOperand() {
        for (;; advance()) {
            if (token_.is('+')) continue;
            if (token_.is('-')) {
                pending_.push_back({Op::negate, signPrecedence, false, token_.at});
            } else if (token_.is('(')) {
                pending_.push_back({Op::number, 0, true, token_.at});
            } else if (token_.kind == Token::Kind::number) {
                return readNumber();
            } else if (token_.kind != Token::Kind::name) {
                return wrong(operandWanted);
            } else if (const NamedOp* function = findFunction(token_.text)) {
                pending_.push_back({function->op, 0, false, token_.at});
                advance();
                if (!token_.is('(')) return wrong("\"(\" after " + std::string(function->name));
                pending_.push_back({Op::number, 0, true, token_.at});
            } else {
                return readName();
            }
        }
    }

    MaybeError readNumber() {
        if (!std::isfinite(token_.number)) {
            return refuse(Code::notFinite, std::string(path_),
                          describe(token_) + " at " + columnOf(text_, token_.at) +
                              " is beyond the largest number, 1.8e308.");
        }
        compiler_.push({Op::number, token_.number});
        advance();
        return std::nullopt;
    }

    MaybeError readName() {
        const std::string_view name = token_.text;
        const auto parameter = std::find_if(parameters_.begin(), parameters_.end(),
                                            [&](const NamedValue& p) { return p.first == name; });
        if (name == "t") {
            compiler_.push({Op::variable, 0});
        } else if (name == "pi") {
            compiler_.push({Op::number, std::numbers::pi});
        } else if (name == "e") {
            compiler_.push({Op::number, std::numbers::e});
        } else if (parameter != parameters_.end()) {
            compiler_.push({Op::number, parameter->second});
        } else {
            return unknown();
        }
        advance();
        return std::nullopt;
    }

    [[nodiscard]] Error unknown() const {
        std::string message = "There is no " + describe(token_) + " (" +
                              columnOf(text_, token_.at) + "); there are " + knownNames() + ".";
        if (const auto likely = likelyName(token_.text); !likely.empty()) {
            message += " Did you mean " + std::string(likely) + "?";
        }
        return refuse(Code::unknownName, std::string(path_), message);
    }

    [[nodiscard]] std::string knownNames() const {
        constexpr std::size_t mostListed = 20;
        std::string names = "t, pi, e";
        for (std::size_t i = 0; i < std::min(mostListed, parameters_.size()); ++i) {
            names += ", " + parameters_[i].first;
        }
        if (parameters_.size() > mostListed) names += ", …";
        names += " and the functions";
        for (const NamedOp& function : functions) names += " " + std::string(function.name);
        return names;
    }

    /// Closing parentheses, then an operator or the end; `more` says whether an operand follows.
    MaybeError readOperator(bool& more) {
        while (token_.is(')')) {
            reduce(1);
            if (pending_.empty()) return wrong(operatorWanted);
            pending_.pop_back();
            if (!pending_.empty() && pending_.back().precedence == 0 &&
                !pending_.back().isParenthesis) {
                compiler_.apply(pending_.back().op);
                pending_.pop_back();
            }
            advance();
        }
        if (token_.kind == Token::Kind::end) return finish();
        const auto next = binary();
        if (!next) return wrong(insideParenthesis() ? closeWanted : operatorWanted);
        // To the right of a power stands another one first.
        reduce(next->precedence == powerPrecedence ? powerPrecedence + 1 : next->precedence);
        pending_.push_back(*next);
        advance();
        more = true;
        return std::nullopt;
    }

    MaybeError finish() {
        reduce(1);
        if (pending_.empty()) return std::nullopt;
        return wrong("\")\" for the \"(\" of " + columnOf(text_, pending_.back().at));
    }

    [[nodiscard]] std::optional<Pending> binary() const {
        if (token_.is('+')) return Pending{Op::add, 1, false, token_.at};
        if (token_.is('-')) return Pending{Op::subtract, 1, false, token_.at};
        if (token_.is('*')) return Pending{Op::multiply, 2, false, token_.at};
        if (token_.is('/')) return Pending{Op::divide, 2, false, token_.at};
        if (token_.is('^')) return Pending{Op::power, powerPrecedence, false, token_.at};
        return std::nullopt;
    }

    [[nodiscard]] bool insideParenthesis() const noexcept {
        return std::any_of(pending_.begin(), pending_.end(),
                           [](const Pending& p) { return p.isParenthesis; });
    }

    /// Everything that waits with this precedence or a higher one has its right operand now.
    void reduce(int precedence) {
        while (!pending_.empty() && pending_.back().precedence >= precedence) {
            const Op op = pending_.back().op;
            pending_.pop_back();
            if (op == Op::negate) {
                compiler_.apply(op);
            } else {
                compiler_.join(op);
            }
        }
    }

    std::string_view text_;
    std::string_view path_;
    std::span<const NamedValue> parameters_;
    Token token_;
    std::vector<Pending> pending_;
    Compiler compiler_;
};

bool isIdentifier(std::string_view name) {
    const Token token = nextToken(name, 0);
    return token.kind == Token::Kind::name && token.text.size() == name.size();
}

}  // namespace

Result<Formula> Formula::make(std::string_view text, std::string_view path,
                              std::span<const NamedValue> parameters) {
    if (text.size() > longestText) {
        return refuse(Code::tooLarge, std::string(path),
                      "A formula has " + std::to_string(text.size()) +
                          " characters; the most is " + std::to_string(longestText) + ".");
    }
    auto program = Parser(text, path, parameters).read();
    if (!program) return program.error();
    const std::size_t depth = depthOf(*program);
    if (depth > deepest) {
        return refuse(Code::tooLarge, std::string(path),
                      "The formula needs " + std::to_string(depth) +
                          " intermediate results at once; the most is " +
                          std::to_string(deepest) + ". Nest it less deeply.");
    }
    Formula made;
    made.text_ = text;
    made.program_ = std::move(*program);
    made.shallow_ = depth <= shallowDepth;
    return made;
}

double Formula::value(double t) const noexcept { return run<deepest>(program(), t); }

Jet Formula::jet(const Jet& t, Side side) const noexcept {
    return shallow_ ? run<shallowDepth>(program(), t, side) : run<deepest>(program(), t, side);
}

std::optional<double> Formula::constant() const noexcept {
    if (program_.size() != 1 || program_[0].op != Op::number) return std::nullopt;
    return program_[0].number;
}

std::optional<Error> checkFormulaParameters(std::span<const NamedValue> parameters,
                                            std::string_view parent) {
    if (parameters.size() > mostParameters) {
        return refuse(Code::tooLarge, std::string(parent),
                      "There are " + std::to_string(parameters.size()) +
                          " parameters; the most is " + std::to_string(mostParameters) + ".");
    }
    for (const NamedValue& parameter : parameters) {
        const std::string& name = parameter.first;
        const std::string path = joinPath(parent, name);
        if (!isIdentifier(name)) {
            return refuse(Code::syntax, path,
                          "\"" + name + "\" cannot be the name of a parameter: names have "
                          "letters, digits and _, and no digit first.");
        }
        if (name == "t" || name == "pi" || name == "e" || findFunction(name) != nullptr) {
            return refuse(Code::outOfRange, path,
                          "\"" + name + "\" has a meaning in formulas already; give the parameter "
                          "another name.");
        }
        if (!std::isfinite(parameter.second)) {
            return refuse(Code::notFinite, path,
                          "The parameter " + name + " is " + formatNumber(parameter.second) +
                              "; give a finite number.");
        }
    }
    return std::nullopt;
}

}  // namespace knotwork
