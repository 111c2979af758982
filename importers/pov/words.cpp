// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/words.h"

#include <cctype>
#include <vector>

namespace alidade::pov {

Names::Names() {
    for (std::string_view word : kWords) id(word);
}

WordId Names::id(std::string_view name) {
    if (const auto found = ids_.find(name); found != ids_.end()) return found->second;
    texts_.emplace_back(name);
    const WordId fresh = WordId(texts_.size() - 1);
    ids_.emplace(texts_.back(), fresh);
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
