// Running the program of a formula on any scalar: double, Jet or std::complex<double>.
#pragma once

#include "geometry/formula.hpp"

#include <array>
#include <cmath>
#include <complex>

namespace knotwork::formula {

// What is one-sided on jets, or is not analytic, for the scalars that have no sides.
inline double absolute(double x, Side) noexcept { return std::abs(x); }
inline double root(double x, Side) noexcept { return std::sqrt(x); }
inline double inverseSine(double x, Side) noexcept { return std::asin(x); }
inline double inverseCosine(double x, Side) noexcept { return std::acos(x); }
inline double raise(double x, double exponent, Side) noexcept { return std::pow(x, exponent); }

inline Jet absolute(const Jet& x, Side side) noexcept { return abs(x, side); }
inline Jet root(const Jet& x, Side side) noexcept { return sqrt(x, side); }
inline Jet inverseSine(const Jet& x, Side side) noexcept { return asin(x, side); }
inline Jet inverseCosine(const Jet& x, Side side) noexcept { return acos(x, side); }
inline Jet raise(const Jet& x, double exponent, Side side) noexcept {
    return pow(x, exponent, side);
}
inline Jet raise(const Jet& x, const Jet& exponent, Side side) noexcept {
    return pow(x, exponent, side);
}

using Complex = std::complex<double>;
inline Complex absolute(const Complex& x, Side) noexcept { return x.real() < 0 ? -x : x; }
inline Complex root(const Complex& x, Side) noexcept { return std::sqrt(x); }
inline Complex inverseSine(const Complex& x, Side) noexcept { return std::asin(x); }
inline Complex inverseCosine(const Complex& x, Side) noexcept { return std::acos(x); }
template <class Exponent>
inline Complex raise(const Complex& x, const Exponent& exponent, Side) noexcept {
    return std::pow(x, exponent);
}

/// c in the kind and order of `like`.
inline double numberLike(double, double c) noexcept { return c; }
inline Jet numberLike(const Jet& like, double c) noexcept { return Jet::constant(c, like.order()); }
inline Complex numberLike(const Complex&, double c) noexcept { return c; }

template <class Scalar>
Scalar raiseToInteger(const Scalar& x, double exponent) noexcept {
    const Scalar power = integerPower(x, static_cast<unsigned>(std::abs(exponent)));
    return exponent < 0 ? 1.0 / power : power;
}

/// f(x) for an instruction that replaces the top.
template <class Scalar>
Scalar applied(const Instruction& instruction, const Scalar& x, Side side) noexcept {
    using std::atan, std::cos, std::cosh, std::exp, std::log, std::pow, std::sin, std::sinh;
    using std::tan, std::tanh;
    const double c = instruction.number;
    switch (instruction.op) {
        case Op::addNumber: return x + c;
        case Op::subtractFrom: return c - x;
        case Op::multiplyNumber: return c * x;
        case Op::divideNumber: return x / c;
        case Op::divideInto: return c / x;
        case Op::integerPower: return raiseToInteger(x, c);
        case Op::realPower: return raise(x, c, side);
        case Op::exponential: return pow(c, x);
        case Op::negate: return -x;
        case Op::sin: return sin(x);
        case Op::cos: return cos(x);
        case Op::tan: return tan(x);
        case Op::asin: return inverseSine(x, side);
        case Op::acos: return inverseCosine(x, side);
        case Op::atan: return atan(x);
        case Op::sinh: return sinh(x);
        case Op::cosh: return cosh(x);
        case Op::tanh: return tanh(x);
        case Op::exp: return exp(x);
        case Op::log: return log(x);
        case Op::sqrt: return root(x, side);
        case Op::abs: return absolute(x, side);
        default: return x;  // not reached: what pushes or joins is run elsewhere
    }
}

template <class Scalar>
Scalar joined(Op op, const Scalar& a, const Scalar& b, Side side) noexcept {
    switch (op) {
        case Op::add: return a + b;
        case Op::subtract: return a - b;
        case Op::multiply: return a * b;
        case Op::divide: return a / b;
        default: return raise(a, b, side);
    }
}

constexpr bool joins(Op op) noexcept { return Op::add <= op && op <= Op::power; }

/// The value of a program that never holds more than `Depth` numbers, at t.
template <std::size_t Depth, class Scalar>
Scalar run(std::span<const Instruction> program, const Scalar& t,
           Side side = Side::right) noexcept {
    std::array<Scalar, Depth> stack;
    stack[0] = t;
    std::size_t top = 0;  // numbers on the stack
    for (const Instruction& instruction : program) {
        if (instruction.op == Op::variable) {
            stack[top++] = t;
        } else if (instruction.op == Op::number) {
            stack[top++] = numberLike(t, instruction.number);
        } else if (joins(instruction.op)) {
            --top;
            stack[top - 1] = joined(instruction.op, stack[top - 1], stack[top], side);
        } else {
            stack[top - 1] = applied(instruction, stack[top - 1], side);
        }
    }
    return stack[0];
}

}  // namespace knotwork::formula
