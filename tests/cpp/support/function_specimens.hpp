// B-functions of every family and of every corner of the parameters' ranges.
#pragma once

#include "geometry/b_function.hpp"

#include <string>
#include <vector>

namespace knotwork::test {

struct Specimen {
    std::string name;
    BFunction function;
};

inline std::string numbers(std::initializer_list<double> values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ", ") + formatNumber(value);
    return "(" + text + ")";
}

/// Values of x³(10 − 15x + 6x²) on a grid: monotone, flat at both ends.
inline std::vector<double> smoothTable(int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        const double x = static_cast<double>(i) / (count - 1);
        values.push_back(x * x * x * (10 - 15 * x + 6 * x * x));
    }
    values.back() = 1;
    return values;
}

inline std::vector<Specimen> polynomialSpecimens() {
    std::vector<Specimen> all;
    for (const int p : {0, 1, 2, 3, 7, 20}) {
        for (const int q : {0, 1, 2, 5, 20}) {
            all.push_back({"polynomial" + numbers({double(p), double(q)}),
                           BFunction::makePolynomial(p, q).value()});
        }
    }
    return all;
}

inline std::vector<Specimen> closedFormSpecimens() {
    std::vector<Specimen> all = polynomialSpecimens();
    all.push_back({"linear", BFunction()});
    for (int m = 1; m <= 20; ++m) {
        all.push_back(
            {"trigonometric" + numbers({double(m)}), BFunction::makeTrigonometric(m).value()});
    }
    for (const double m : {1.0, 1.5, 2.0, 3.0, 7.25, 50.0}) {
        for (const double c : {1e-6, 0.3, 1.0, 1000.0}) {
            all.push_back({"rational" + numbers({m, c}), BFunction::makeRational(m, c).value()});
        }
    }
    for (const double c : {1e-9, 0.1, 1.0, 30.0, 1000.0}) {
        all.push_back({"logistic" + numbers({c}), BFunction::makeLogistic(c).value()});
    }
    return all;
}

inline std::vector<Specimen> expoRationalSpecimens() {
    std::vector<Specimen> all;
    const auto add = [&all](double alpha, double beta, double gamma, double lambda) {
        all.push_back({"expo-rational" + numbers({alpha, beta, gamma, lambda}),
                       BFunction::makeExpoRational(alpha, beta, gamma, lambda).value()});
    };
    add(1, 1, 1, 0.5);
    for (const double alpha : {1e-3, 0.3, 4.0}) {
        for (const double beta : {1e-3, 2.0, 100.0}) {
            for (const double gamma : {1e-3, 4.0}) {
                for (const double lambda : {0.001, 0.5, 0.999}) add(alpha, beta, gamma, lambda);
            }
        }
    }
    add(0.027, 100, 1e-3, 0.5);  // nearly all of the mass within 1e-15 of λ
    add(1e-300, 1, 1, 0.5);
    add(1, 1e-300, 1, 0.5);
    add(1, 1, 1e-300, 0.5);
    add(1, 1, 1, 1e-300);
    add(4, 100, 4, 1e-300);
    add(1, 1, 1, 1 - 0x1p-53);
    return all;
}

inline std::vector<Specimen> nestedSpecimens() {
    const BFunction erb = BFunction::makeExpoRational(1.2, 0.7, 2, 0.4).value();
    const BFunction skew = BFunction::makePolynomial(1, 3).value();
    const BFunction root = BFunction::makeRational(1.5, 2).value();
    return {
        {"dual", BFunction::makeDual(skew).value()},
        {"dual of expo-rational", BFunction::makeDual(erb).value()},
        {"symmetrised", BFunction::makeSymmetrised(skew).value()},
        {"composed", BFunction::makeComposed(skew, root).value()},
        {"composed with expo-rational", BFunction::makeComposed(erb, skew).value()},
        {"mixed", BFunction::makeMixed(erb, skew, 0.3).value()},
        {"mixed, the first alone", BFunction::makeMixed(erb, skew, 1).value()},
        {"tabulated, linear", BFunction::makeTabulated(std::vector{0.0, 1.0}).value()},
        {"tabulated, smooth", BFunction::makeTabulated(smoothTable(12)).value()},
        {"tabulated, steep beside nearly flat",
         BFunction::makeTabulated(std::vector{0.0, 0.4, 0.41, 0.95, 0.96, 1.0}).value()},
        {"tabulated, with a cliff and plateaus",
         BFunction::makeTabulated(std::vector{0.0, 0.0, 1e-9, 0.9, 0.9, 0.95, 1.0, 1.0}).value()}};
}

inline std::vector<Specimen> formulaSpecimens() {
    std::vector<Specimen> all;
    for (const char* expression :
         {"t^2*(3-2*t)", "sin(pi*t/2)^2", "t^1.5/(t^1.5+2*(1-t)^1.5)", "t^3/(t^3+4*(1-t)^3)",
          "1/(1+exp(1/t-1/(1-t)))", "(1+tanh(log(t/(1-t))))/2"}) {
        all.push_back({expression, BFunction::makeFormula(expression).value()});
    }
    return all;
}

inline std::vector<Specimen> everySpecimen() {
    std::vector<Specimen> all = closedFormSpecimens();
    for (const auto& more : {expoRationalSpecimens(), nestedSpecimens(), formulaSpecimens()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace knotwork::test
