// Any text as a formula: refused at a column of the text, or a program whose every step has on jets
// the value that it has on numbers, and which parentheses around the text do not change.
#include "fuzz/input.hpp"

#include "geometry/formula.hpp"
#include "geometry/formula_program.hpp"

#include <cctype>
#include <limits>
#include <string_view>

using namespace knotwork;
using formula::Instruction;
using formula::Op;

namespace {

constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of one step, relative
constexpr int order = 4;

const std::vector<NamedValue>& parameters() {
    static const std::vector<NamedValue> two{{"a", 2.5}, {"b_2", -1}};
    return two;
}

bool same(double a, double b) noexcept { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Every "column N" of the message is one of the text, or the one behind it.
void checkColumns(const std::string& message, std::string_view text, bool needed) {
    constexpr std::string_view word = "column ";
    std::size_t found = 0;
    for (std::size_t at = message.find(word); at != std::string::npos;
         at = message.find(word, at + 1)) {
        if (std::isdigit(static_cast<unsigned char>(message[at + word.size()])) == 0) continue;
        const double column = std::atof(message.c_str() + at + word.size());
        fuzz::check(column >= 1, "columns count from one", column);
        fuzz::checkWithin(column, static_cast<double>(text.size() + 1), "a column of the text");
        ++found;
    }
    fuzz::check(!needed || found > 0, "a refusal says the column");
}

void checkRefusal(const Error& error, std::string_view text) {
    fuzz::check(error.path == "x", "a refusal has the path that was given");
    fuzz::check(error.message.size() > 10, "a refusal says why");
    checkColumns(error.message, text, error.code != Code::tooLarge);
}

/// x/c on jets is x·(1/c), which is not to be had where 1/c leaves the normal numbers.
bool isHarmless(const Instruction& instruction) noexcept {
    const double c = std::abs(instruction.number);
    return instruction.op != Op::divideNumber || (1e-300 < c && c < 1e300);
}

void checkStep(double number, double jet, bool harmless) {
    if (!harmless || !std::isfinite(number) || std::abs(number) < 1e-290) return;
    fuzz::checkWithin(std::abs(jet - number) / std::abs(number), rounding,
                      "a step on jets has the value that it has on numbers");
}

/// The program on jets, each step beside the same on numbers: nothing that rounding has become
/// larger by on the way counts.
Jet runBeside(const Formula& read, const Jet& t, Side side) {
    std::vector<Jet> stack;
    for (const Instruction& instruction : read.program()) {
        if (instruction.op == Op::variable) {
            stack.push_back(t);
        } else if (instruction.op == Op::number) {
            stack.push_back(Jet::constant(instruction.number, t.order()));
        } else if (formula::joins(instruction.op)) {
            const Jet second = stack.back();
            stack.pop_back();
            Jet& first = stack.back();
            const double number =
                formula::joined(instruction.op, first.value(), second.value(), side);
            first = formula::joined(instruction.op, first, second, side);
            checkStep(number, first.value(), true);
        } else {
            Jet& top = stack.back();
            const double number = formula::applied(instruction, top.value(), side);
            top = formula::applied(instruction, top, side);
            checkStep(number, top.value(), isHarmless(instruction));
        }
    }
    fuzz::check(stack.size() == 1, "a program leaves one number");
    return stack.back();
}

void checkValues(const Formula& read, const Formula& enclosed, double t) {
    fuzz::check(same(enclosed.value(t), read.value(t)), "parentheses change nothing", t);
    for (const Side side : {Side::left, Side::right}) {
        const Jet variable = Jet::variable(t, order);
        const Jet jet = read.jet(variable, side);
        const Jet beside = runBeside(read, variable, side);
        fuzz::check(jet.order() == order, "a jet has the order of its variable");
        for (int k = 0; k <= order; ++k) {
            fuzz::check(same(jet[k], beside[k]), "a program is run step by step", t);
        }
    }
    if (const auto constant = read.constant()) {
        fuzz::check(same(*constant, read.value(t)), "a constant is its value everywhere", t);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto read = Formula::make(text, "x", parameters());
    if (!read) {
        checkRefusal(read.error(), text);
        return 0;
    }
    fuzz::check(read->text() == text, "a formula keeps its text");
    const auto enclosed = Formula::make("(" + text + ")", "x", parameters());
    fuzz::check(enclosed.ok() || enclosed.error().code == Code::tooLarge,
                "what can be read can be read in parentheses");
    for (const double t : {-2.0, -1.0, 0.0, 0.3, 1.0, 2.5, 1e3}) {
        checkValues(*read, enclosed.ok() ? *enclosed : *read, t);
    }
    return 0;
}
