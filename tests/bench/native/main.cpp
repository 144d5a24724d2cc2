// The work of the benchmark done natively: one line of JSON says what, every further line has it done
// once and is answered with { milliseconds, result }, six moments of the numbers that came out. As on
// the other side, it is done in blocks that fit the first cache, which are copied out.
#include "geometry/basis_sampler.hpp"
#include "geometry/curve.hpp"
#include "scene/json.hpp"
#include "scene/specs.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <iostream>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace knotwork;
using scene::Json;

using Work = std::function<void()>;

/// Means of each third number, and of their squares: what is compared.
std::array<double, 6> moments(std::span<const double> numbers) {
    std::array<double, 6> sums{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        sums[i % 3] += numbers[i] / static_cast<double>(numbers.size());
        sums[3 + i % 3] += numbers[i] * numbers[i] / static_cast<double>(numbers.size());
    }
    return sums;
}

std::vector<double> uniformParameters(const Curve& curve, std::size_t count) {
    std::vector<double> ts(count);
    for (std::size_t i = 0; i < count; ++i) ts[i] = uniformParameter(domain(curve), i, count);
    return ts;
}

constexpr std::size_t blockNumbers = 3072;

/// Runs block(first, count, numbers) over all of them, `width` numbers each in `rows` lists one after
/// the other.
template <class Block>
void inBlocks(std::size_t amount, std::size_t width, std::size_t rows, std::vector<double>& out,
              Block block) {
    std::array<double, blockNumbers> numbers;
    const std::size_t most = blockNumbers / (width * rows);
    for (std::size_t first = 0; first < amount; first += most) {
        const std::size_t count = std::min(most, amount - first);
        block(first, count, std::span(numbers).first(count * width * rows));
        for (std::size_t row = 0; row < rows; ++row) {
            std::copy_n(&numbers[row * count * width], count * width,
                        &out[(row * amount + first) * width]);
        }
    }
}

Work derivatives(const Curve& curve, std::size_t amount, std::vector<double>& out) {
    out.resize(9 * amount);
    return [=, ts = uniformParameters(curve, amount), &out] {
        const CurveSampler sampler(curve);
        inBlocks(amount, 3, 3, out, [&](std::size_t first, std::size_t count, auto numbers) {
            sampler.at(std::span(ts).subspan(first, count), 2, numbers);
        });
    };
}

Work basis(const Curve& curve, std::size_t amount, std::vector<double>& out) {
    const KnotVector knots = curve.as<BsplineCurve>()->knotVector();
    const auto width = static_cast<std::size_t>(knots.degree() + 1);
    out.resize(width * amount);
    return [=, ts = uniformParameters(curve, amount), firsts = std::vector<std::int32_t>(amount),
            &out]() mutable {
        inBlocks(amount, width, 1, out, [&](std::size_t first, std::size_t count, auto numbers) {
            activeBasis(knots, std::span(ts).subspan(first, count), numbers,
                        std::span(firsts).subspan(first, count));
        });
    };
}

Work samples(const Curve& curve, std::size_t amount, std::vector<double>& out) {
    out.resize(3 * amount);
    return [=, &out] {
        const CurveSampler sampler(curve);
        inBlocks(amount, 3, 1, out, [&](std::size_t first, std::size_t count, auto numbers) {
            sampler.uniform(first, count, amount, numbers);
        });
    };
}

Work makeWork(const std::string& task, const Curve& curve, std::size_t amount,
              std::vector<double>& out) {
    if (task == "derivatives") return derivatives(curve, amount, out);
    if (task == "basis") return basis(curve, amount, out);
    return samples(curve, amount, out);
}

void answer(const Work& work, const std::vector<double>& numbers) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    std::cout << scene::dumpJson(Json{{"milliseconds", elapsed.count()},
                                      {"result", moments(numbers)}})
              << std::endl;
}

}  // namespace

int main() {
    std::string line;
    std::getline(std::cin, line);
    const auto given = scene::parseJson(line);
    auto made = given ? scene::makeCurve(*scene::member(*given, "curve"))
                      : Result<scene::Made<Curve>>(given.error());
    if (!made) {
        std::cerr << made.error().message << '\n';
        return 1;
    }
    std::vector<double> numbers;
    const auto amount = static_cast<std::size_t>(scene::numberOr(*given, "amount", 0));
    const Work work =
        makeWork(scene::stringOr(*given, "task", ""), made->value, amount, numbers);
    while (std::getline(std::cin, line)) answer(work, numbers);
}
