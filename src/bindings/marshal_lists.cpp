#include "bindings/marshal_lists.hpp"

namespace knotwork::bindings {

using Kind = CborItem::Kind;

bool readNumbers(const CborItem& item, std::size_t most, std::vector<double>& numbers) {
    if (item.kind != Kind::numbers || item.length > most) return false;
    numbers.resize(item.length);
    if (!numbers.empty()) std::memcpy(numbers.data(), item.bytes.data(), item.bytes.size());
    return true;
}

// Zero times whatever is not finite is NaN.
bool allFinite(std::span<const double> numbers) noexcept {
    double sum = 0;
    for (const double number : numbers) sum += 0 * number;
    return sum == 0;
}

bool allFinite(std::span<const Vec3> points) noexcept {
    double sum = 0;
    for (const Vec3& point : points) sum += 0 * point.x + 0 * point.y + 0 * point.z;
    return sum == 0;
}

std::optional<Form> formNamed(std::string_view name) noexcept {
    if (name == "clamped") return Form::clamped;
    if (name == "open") return Form::open;
    if (name == "closed") return Form::closed;
    return std::nullopt;
}

}  // namespace knotwork::bindings
