#include "scene/builtin.hpp"

#include "generated/builtin_scenes.hpp"

namespace knotwork::scene {

std::span<const BuiltinScene> builtinScenes() noexcept { return generatedScenes; }

Json describeScenes() {
    Json list = Json::array();
    for (const BuiltinScene& scene : builtinScenes()) {
        Json document = *parseJson(scene.document);
        list.push_back({{"id", scene.id},
                        {"title", stringOr(document, "title", "")},
                        {"description", stringOr(document, "description", "")},
                        {"document", std::move(document)}});
    }
    return list;
}

}  // namespace knotwork::scene
