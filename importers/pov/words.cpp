// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/words.h"

#include <cctype>

namespace alidade::pov {

Names::Names() : texts_(std::begin(kWords), std::end(kWords)) {
    table_.resize(4096);
    for (WordId id = 0; id < kWordCount; ++id) {
        const uint32_t hash = hash_of(kWords[id]);
        place_of(hash, [](WordId) { return false; }) = {hash, id};
    }
}

uint32_t Names::hash_of(std::string_view name) {
    NameHash hash;
    for (const char c : name) hash.add(c);
    return hash.value();
}

template <class Same>
Names::Entry& Names::place_of(uint32_t hash, Same same) {
    size_t at = hash & (table_.size() - 1);
    while (table_[at].id != kFree && !(table_[at].hash == hash && same(table_[at].id))) at = (at + 1) & (table_.size() - 1);
    return table_[at];
}

void Names::rehash(size_t size) {
    std::vector<Entry> before(size);
    before.swap(table_);
    for (const Entry& entry : before)
        if (entry.id != kFree) place_of(entry.hash, [](WordId) { return false; }) = entry;
}

WordId Names::id(std::string_view name, uint32_t hash) {
    Entry& entry = place_of(hash, [&](WordId known) { return texts_[known] == name; });
    if (entry.id != kFree) return entry.id;
    const WordId fresh = WordId(texts_.size());
    texts_.push_back(identifiers_.emplace_back(name));
    entry = {hash, fresh};
    if (2 * texts_.size() > table_.size()) rehash(2 * table_.size());
    return fresh;
}

bool is_directive(WordId id) {
    switch (id) {
        case "declare"_w: case "local"_w: case "undef"_w: case "default"_w: case "version"_w: case "macro"_w: case "include"_w: case "debug"_w: case "warning"_w: case "error"_w: case "render"_w:
        case "statistics"_w: case "fopen"_w: case "fclose"_w: case "read"_w: case "write"_w: case "if"_w: case "ifdef"_w: case "ifndef"_w: case "else"_w: case "elseif"_w: case "end"_w: case "while"_w:
        case "for"_w: case "switch"_w: case "case"_w: case "range"_w: case "break"_w: case "max_trace_level"_w: case "max_intersections"_w: return true;
        default: return false;
    }
}

bool is_object(WordId word) {
    static constexpr WordId kObjects[] = {
        "sphere"_w, "plane"_w, "box"_w, "cylinder"_w, "cone"_w, "disc"_w, "torus"_w, "triangle"_w, "smooth_triangle"_w, "mesh"_w, "mesh2"_w, "union"_w, "merge"_w,
        "intersection"_w, "difference"_w, "object"_w, "light_source"_w, "light_group"_w, "text"_w, "polygon"_w, "quadric"_w, "cubic"_w, "quartic"_w, "poly"_w, "polynomial"_w,
        "blob"_w, "bicubic_patch"_w, "height_field"_w, "isosurface"_w, "julia_fractal"_w, "lathe"_w, "ovus"_w, "parametric"_w, "prism"_w, "sor"_w, "sphere_sweep"_w, "superellipsoid"_w};
    return std::find(std::begin(kObjects), std::end(kObjects), word) != std::end(kObjects);
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
