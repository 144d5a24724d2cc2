#include "scene/json_values.hpp"

namespace knotwork::scene {

Vec3 vec3Of(const Json& point) noexcept {
    return {point[0].get<double>(), point[1].get<double>(),
            point.size() > 2 ? point[2].get<double>() : 0.0};
}

std::vector<double> numbersOf(const Json& list) {
    std::vector<double> numbers;
    numbers.reserve(list.size());
    for (const Json& item : list) numbers.push_back(item.get<double>());
    return numbers;
}

Json listOf(std::span<const double> numbers) {
    Json list = Json::array();
    for (const double number : numbers) list.push_back(number);
    return list;
}

Json pointJson(const Vec3& point, int dimension) {
    if (dimension == 2) return Json::array({point.x, point.y});
    return Json::array({point.x, point.y, point.z});
}

Pose poseOf(const Json& pose) noexcept {
    Pose made;
    if (const Json* translate = member(pose, "translate")) made.translate = vec3Of(*translate);
    if (const Json* rotate = member(pose, "rotate")) {
        if (const Json* axis = member(*rotate, "axis")) made.axis = vec3Of(*axis);
        made.angle = numberOr(*rotate, "angle", 0);
    }
    if (const Json* scale = member(pose, "scale")) {
        made.scale = scale->is_number() ? Vec3(scale->get<double>()) : vec3Of(*scale);
        // A planar pair of factors leaves the third direction alone.
        if (scale->is_array() && scale->size() == 2) made.scale.z = 1;
    }
    return made;
}

}  // namespace knotwork::scene
