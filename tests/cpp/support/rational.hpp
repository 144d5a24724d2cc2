// Exact fractions of 128-bit integers, for running the kernels without rounding.
#pragma once

#include <cstdlib>
#include <ostream>
#include <string>

namespace knotwork::test {

class Rational {
    __extension__ using Wide = __int128;

public:
    constexpr Rational(long long numerator = 0, long long denominator = 1)
        : Rational(Reduced{}, numerator, denominator) {}

    /// `247/288` or `-3`.
    static Rational parse(const std::string& text) {
        const auto slash = text.find('/');
        const long long numerator = std::stoll(text.substr(0, slash));
        return slash == std::string::npos ? Rational(numerator)
                                          : Rational(numerator, std::stoll(text.substr(slash + 1)));
    }

    [[nodiscard]] constexpr double value() const {
        return static_cast<double>(numerator_) / static_cast<double>(denominator_);
    }

    friend constexpr Rational operator+(const Rational& a, const Rational& b) {
        return {Reduced{}, a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
                a.denominator_ * b.denominator_};
    }
    friend constexpr Rational operator-(const Rational& a, const Rational& b) {
        return {Reduced{}, a.numerator_ * b.denominator_ - b.numerator_ * a.denominator_,
                a.denominator_ * b.denominator_};
    }
    friend constexpr Rational operator*(const Rational& a, const Rational& b) {
        return {Reduced{}, a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
    }
    friend constexpr Rational operator/(const Rational& a, const Rational& b) {
        return {Reduced{}, a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
    }
    friend constexpr bool operator==(const Rational&, const Rational&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Rational& r) {
        return out << static_cast<long long>(r.numerator_) << '/'
                   << static_cast<long long>(r.denominator_);
    }

private:
    struct Reduced {};

    constexpr Rational(Reduced, Wide numerator, Wide denominator) {
        // A division by zero must not pass for a number.
        if (denominator == 0) std::abort();
        const Wide divisor = commonDivisor(numerator, denominator) * (denominator < 0 ? -1 : 1);
        numerator_ = numerator / divisor;
        denominator_ = denominator / divisor;
    }

    static constexpr Wide commonDivisor(Wide a, Wide b) {
        if (a < 0) a = -a;
        if (b < 0) b = -b;
        while (b != 0) {
            const Wide rest = a % b;
            a = b;
            b = rest;
        }
        return a;
    }

    Wide numerator_ = 0;
    Wide denominator_ = 1;
};

}  // namespace knotwork::test
