#include "scene/migrations.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

const Migration* migrationFor(const Json& document, std::span<const Migration> table) noexcept {
    const Json* version = member(document, "knotwork");
    if (version == nullptr || !version->is_number()) return nullptr;
    const auto found = std::find_if(table.begin(), table.end(), [&](const Migration& migration) {
        return migration.from == version->get<double>();
    });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Migration> migrations() noexcept {
    return {};  // version 1 is the only one
}

bool isOutdated(const Json& document, std::span<const Migration> table) noexcept {
    return migrationFor(document, table) != nullptr;
}

Json migrated(Json document, std::span<const Migration> table) {
    // Each step leads to a higher version, so this ends whatever a migration does.
    while (const Migration* migration = migrationFor(document, table)) {
        document = migration->apply(std::move(document));
        document["knotwork"] = static_cast<double>(migration->from + 1);
    }
    return document;
}

}  // namespace knotwork::scene
