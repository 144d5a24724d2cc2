// Entries of tables by their names.
#pragma once

#include <string_view>

namespace knotwork {

/// The first entry of a table that has this name in its member `key`, or nothing.
template <class Table, class Entry>
[[nodiscard]] constexpr const Entry* findNamed(const Table& table, std::string_view Entry::*key,
                                               std::string_view name) noexcept {
    for (const Entry& entry : table) {
        if (entry.*key == name) return &entry;
    }
    return nullptr;
}

}  // namespace knotwork
