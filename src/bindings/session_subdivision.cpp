// The part of the session that subdivides polygons.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"

#include <algorithm>

namespace knotwork::bindings {

int Session::subdivision(unsigned bytes) {
    const std::span<const std::uint8_t> given(room_.data(),
                                              std::min<std::size_t>(bytes, room_.size()));
    auto wanted = readUsualSubdivision(given);
    if (!wanted) {
        const auto spec = readCbor(given);
        auto made = spec ? scene::makeSubdivision(*spec) : Result<CurveSubdivision>(spec.error());
        if (!made) {
            refuse(made.error());
            return -1;
        }
        wanted = std::move(*made);
    }
    subdivided_.emplace(*wanted);
    return static_cast<int>(subdivided_->size());
}

bool Session::subdivisionPoints(unsigned first, unsigned count) {
    if (!subdivided_) return false;
    const std::size_t points = std::min<std::size_t>(count, blockPoints);
    subdivided_->points(first, {block_.data(), 3 * points});
    return true;
}

void Session::dropSubdivision() { subdivided_.reset(); }

}  // namespace knotwork::bindings
