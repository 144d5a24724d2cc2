#include "scene/parameter_fields.hpp"

namespace knotwork::scene {

Field fieldOf(const ParameterDescription& parameter) {
    return {.name = parameter.name, .label = parameter.label,
            .kind = parameter.integer ? FieldKind::integer : FieldKind::number,
            .help = parameter.help, .min = parameter.min, .max = parameter.max,
            .minOpen = parameter.minOpen, .maxOpen = parameter.maxOpen,
            .defaultNumber = parameter.defaultValue,
            .slider = std::pair{parameter.low, parameter.high}};
}

std::vector<NamedValue> namedValues(const Json& group) {
    std::vector<NamedValue> values;
    for (const auto& item : group.items()) {
        values.emplace_back(item.key(), item.value().get<double>());
    }
    return values;
}

Json describeParameters(std::span<const ParameterDescription> parameters) {
    Json list = Json::array();
    for (const ParameterDescription& parameter : parameters) {
        list.push_back({{"name", parameter.name},
                        {"label", parameter.label},
                        {"min", parameter.min},
                        {"max", parameter.max},
                        {"default", parameter.defaultValue},
                        {"minOpen", parameter.minOpen},
                        {"maxOpen", parameter.maxOpen},
                        {"integer", parameter.integer},
                        {"help", parameter.help}});
    }
    return list;
}

}  // namespace knotwork::scene
