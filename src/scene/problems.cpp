#include "scene/problems.hpp"

#include "scene/document.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

class Reader {
public:
    explicit Reader(const Json& document) : document_(document) {}

    std::vector<Error> problems() {
        found_.add(checkGroup(headerOf(document_), headerFields()).problems(), "");
        readList("objects", maximumObjects, [&](const Json& spec, const std::string& path) {
            readOne(spec, path);
        });
        readList("effects", maximumEffects, [&](const Json& spec, const std::string& path) {
            found_.add(problemsOfEffect(spec), path);
        });
        return found_.problems();
    }

private:
    template <class Read>
    void readList(const char* key, std::size_t most, Read read) {
        const auto list = listUnder(document_, key, most);
        if (!list) return found_.add(list.error());
        if (*list == nullptr) return;
        for (std::size_t i = 0; i < (*list)->size() && !found_.full(); ++i) {
            read((**list)[i], indexed(key, i));
        }
    }

    void readOne(const Json& given, const std::string& path) {
        Json spec = given;
        if (spec.is_object() && member(spec, "id") == nullptr) spec["id"] = freshId(objects_);
        const Checked checked = checkObjectSpec(spec);
        auto object = checked.ok() ? readObject(spec) : Result<ObjectPointer>(ObjectPointer());
        found_.add(checked.problems(), path);
        if (!object) found_.add(object.error().under(path));
        if (!object || *object == nullptr) {
            unread_.push_back(stringOr(spec, "id", ""));
            return;
        }
        const std::string& id = (*object)->id;
        auto free = checkNewId(objects_, id);
        if (free && couldNotBeMade(id)) {
            free = refuse(Code::outOfRange, "id", "Another object is called \"" + id + "\" too.");
        }
        if (!free) return found_.add(free.error().under(path));
        objects_.push_back(std::move(*object));
    }

    std::vector<Error> problemsOfEffect(const Json& spec) const {
        const EffectType* type = findEffectType(stringOr(spec, "kind", ""));
        if (type != nullptr) {
            Json fields = spec;
            fields.erase("kind");
            const Checked checked = checkGroup(fields, type->fields);
            if (!checked.ok()) return checked.problems();
        }
        // What the object of an effect is cannot be known where it could not be made.
        const std::string target = stringOr(spec, "target", "");
        if (type != nullptr && couldNotBeMade(target)) return {};
        if (const auto effect = readEffect(spec, objects_); !effect) return {effect.error()};
        return {};
    }

    [[nodiscard]] bool couldNotBeMade(const std::string& id) const {
        return !id.empty() && std::find(unread_.begin(), unread_.end(), id) != unread_.end();
    }

    using ObjectPointer = std::shared_ptr<const Object>;

    const Json& document_;
    Checked found_{Json()};
    std::vector<ObjectPointer> objects_;
    std::vector<std::string> unread_;  ///< the ids of those that could not be made
};

}  // namespace

std::vector<Error> findProblems(const Json& given) {
    const auto document = currentVersion(given);
    if (!document) return {document.error()};
    return Reader(*document).problems();
}

}  // namespace knotwork::scene
