// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/words.h"

#include <cctype>

namespace alidade::pov {

namespace {

/// FNV-1a.
uint32_t hash_of(std::string_view name) {
    uint32_t hash = 2166136261u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash ^ hash >> 15;
}

}  // namespace

Names::Names() {
    rehash(4096);
    for (std::string_view word : kWords) id(word);
}

void Names::rehash(size_t size) {
    table_.assign(size, kFree);
    for (WordId id = 0; id < hashes_.size(); ++id) {
        size_t at = hashes_[id] & (size - 1);
        while (table_[at] != kFree) at = (at + 1) & (size - 1);
        table_[at] = id;
    }
}

WordId Names::id(std::string_view name) {
    const uint32_t hash = hash_of(name);
    size_t at = hash & (table_.size() - 1);
    for (; table_[at] != kFree; at = (at + 1) & (table_.size() - 1))
        if (const WordId known = table_[at]; hashes_[known] == hash && texts_[known] == name) return known;
    const WordId fresh = WordId(texts_.size());
    texts_.emplace_back(name), hashes_.push_back(hash);
    table_[at] = fresh;
    if (2 * texts_.size() > table_.size()) rehash(2 * table_.size());
    return fresh;
}

size_t edit_distance(std::string_view a, std::string_view b) {
    auto same = [](char p, char q) { return std::tolower(static_cast<unsigned char>(p)) == std::tolower(static_cast<unsigned char>(q)); };
    std::vector<size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1])) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last), last.swap(row);
    }
    return last[b.size()];
}

}  // namespace alidade::pov
