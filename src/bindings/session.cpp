#include "bindings/session.hpp"

#include "bindings/marshal.hpp"
#include "geometry/uniform_parameters.hpp"

#include <algorithm>

namespace knotwork::bindings {

using scene::Json;
using scene::Made;

namespace {

// A handle is an index (20 bits) below the generation of its slot (10 bits, never 0), so that a
// handle that was released does not name what stands in its slot next.
constexpr unsigned indexBits = 20;
constexpr unsigned indexMask = (1U << indexBits) - 1;
constexpr unsigned lastGeneration = (1U << 10) - 1;

template <class T>
Session::Address addressOf(const T* data) noexcept {
    return reinterpret_cast<Session::Address>(data);
}

}  // namespace

std::string Session::error() const { return errorJson(error_); }

Session::Address Session::room(unsigned bytes) {
    if (bytes > room_.size()) room_.resize(bytes);
    return addressOf(room_.data());
}

Session::Address Session::block() const { return addressOf(block_.data()); }
Session::Address Session::normals() const { return addressOf(normals_.data()); }
Session::Address Session::parameters() const { return addressOf(parameters_.data()); }
Session::Address Session::integers() const { return addressOf(integers_.data()); }
Session::Address Session::bulk() const { return addressOf(list_); }
void Session::dropBulk() {
    bulk_ = {};
    list_ = nullptr;
    bulkIndices_ = {};
}

int Session::refuse(Error error) {
    error_ = std::move(error);
    return 0;
}

Result<Json> Session::input(unsigned bytes) const {
    return readCbor(inputBytes(bytes));
}

std::span<const std::uint8_t> Session::inputBytes(unsigned bytes) const {
    return {room_.data(), std::min<std::size_t>(bytes, room_.size())};
}

std::string Session::inputText(unsigned bytes) {
    auto given = input(bytes);
    if (given) return scene::dumpJson(*given);
    refuse(given.error());
    return {};
}

int Session::leave(std::vector<double> numbers, std::size_t count) {
    bulk_ = std::move(numbers);
    list_ = bulk_.data();
    return static_cast<int>(count);
}

int Session::hold(Value value) {
    if (free_.empty()) {
        if (slots_.size() > indexMask) {
            return refuse({Code::tooLarge, "",
                           "A million values are held; dispose() of those not needed any more."});
        }
        free_.push_back(static_cast<unsigned>(slots_.size()));
        slots_.emplace_back();
    }
    const unsigned index = free_.back();
    free_.pop_back();
    Slot& slot = slots_[index];
    slot.value = std::move(value);
    ++held_;
    return static_cast<int>(slot.generation << indexBits | index);
}

const Session::Slot* Session::slot(int handle) const {
    const auto bits = static_cast<unsigned>(handle);
    const std::size_t index = bits & indexMask;
    if (index >= slots_.size() || slots_[index].generation != bits >> indexBits) return nullptr;
    return &slots_[index];
}

void Session::release(int handle) {
    if (!slot(handle)) return;
    const unsigned index = static_cast<unsigned>(handle) & indexMask;
    if (handle == drawn_) drawings_.forget();
    Slot& released = slots_[index];
    released.value = std::monostate{};
    released.generation = released.generation % lastGeneration + 1;
    free_.push_back(index);
    --held_;
}

template <class T>
T* Session::find(int handle) {
    if (const Slot* found = slot(handle)) {
        if constexpr (std::is_same_v<T, scene::Scene>) {
            if (auto* held = std::get_if<std::shared_ptr<T>>(&found->value)) return held->get();
        } else {
            if (auto* held = std::get_if<std::unique_ptr<T>>(&found->value)) return held->get();
        }
    }
    refuse({Code::disposed, "", "The value was disposed of; make a new one."});
    return nullptr;
}

template Made<BFunction>* Session::find<Made<BFunction>>(int);
template Session::CurveValue* Session::find<Session::CurveValue>(int);
template Session::SurfaceValue* Session::find<Session::SurfaceValue>(int);
template Session::MeshValue* Session::find<Session::MeshValue>(int);
template drawing::SceneExport* Session::find<drawing::SceneExport>(int);
template scene::Scene* Session::find<scene::Scene>(int);

// B-functions.

int Session::bFunction(unsigned bytes) {
    auto spec = input(bytes);
    if (!spec) return refuse(spec.error());
    auto made = scene::makeBFunction(*spec);
    if (!made) return refuse(made.error());
    return hold(std::make_unique<Made<BFunction>>(std::move(*made)));
}

std::string Session::bFunctionSpec(int handle) {
    const auto* held = find<Made<BFunction>>(handle);
    return held ? scene::dumpJson(held->spec) : std::string();
}

bool Session::bFunctionTraits(int handle) {
    const auto* held = find<Made<BFunction>>(handle);
    if (!held) return false;
    const std::array<double, 2> order = held->value.order();
    block_[0] = order[0];
    block_[1] = order[1];
    block_[2] = held->value.symmetric() ? 1 : 0;
    block_[3] = held->value.smooth() ? 1 : 0;
    return true;
}

std::string Session::bFunctionWarning(int handle) {
    const auto* held = find<Made<BFunction>>(handle);
    return held ? std::string(held->value.warning()) : std::string();
}

bool Session::bFunctionDerivatives(int handle, double t, int n) {
    const auto* held = find<Made<BFunction>>(handle);
    if (!held) return false;
    if (auto order = checkDerivative(n, "n"); !order) return refuse(order.error());
    if (auto inside = checkUnit(t); !inside) return refuse(inside.error());
    held->value.derivatives(t, {block_.data(), static_cast<std::size_t>(n) + 1});
    return true;
}

bool Session::bFunctionSample(int handle, unsigned first, unsigned count, unsigned total) {
    const auto* held = find<Made<BFunction>>(handle);
    if (!held) return false;
    const std::size_t samples = std::min<std::size_t>(count, blockPoints);
    uniformParameters({0, 1}, first, total, {parameters_.data(), samples});
    held->value.sample({parameters_.data(), samples}, {block_.data(), samples});
    return true;
}

std::string Session::bFunctions() const { return scene::dumpJson(scene::describeBFunctions()); }

}  // namespace knotwork::bindings
