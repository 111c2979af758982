// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

constexpr uint64_t kCount = 1'000'000'000'000;
/// Tokens, items and bytes are numbered by 32 bits.
constexpr uint64_t kNumbered = 0xFFFF'FFF0;

constexpr LimitEntry kEntries[] = {
    {"steps", &Limits::tokens_read, kCount, "words, numbers and signs that are read, those of loops and macros each time"},
    {"turns", &Limits::loop_turns, kCount, "turns of all loops"},
    {"tokens", &Limits::tokens_in_file, kNumbered, "words, numbers and signs of one file"},
    {"levels", &Limits::levels, 10'000, "macro calls and includes inside one another"},
    {"nesting", &Limits::nesting, 2'000, "brackets, blocks and function calls inside one another"},
    {"depth", &Limits::depth, 50'000, "objects, functions and arrays that are made of one another"},
    {"elements", &Limits::array_elements, kNumbered, "elements of all arrays"},
    {"items", &Limits::items, kNumbered, "words and values of all blocks"},
    {"copies", &Limits::copies, 100'000'000, "copies of objects that are named more than once, each with all its parts"},
    {"string", &Limits::string_bytes, kNumbered, "bytes of a string"},
    {"written", &Limits::written_bytes, kCount, "bytes that #write writes"},
};

const LimitEntry* find_entry(std::string_view name) {
    for (const LimitEntry& e : kEntries)
        if (e.name == name) return &e;
    return nullptr;
}

}  // namespace

std::span<const LimitEntry> limit_entries() { return kEntries; }

std::string set_limit(Limits& limits, std::string_view word) {
    const size_t equals = word.find('=');
    const LimitEntry* entry = find_entry(word.substr(0, equals));
    if (!entry) {
        std::string names;
        for (const LimitEntry& e : kEntries) names += fmt::format("{}{}", names.empty() ? "" : ", ", e.name);
        return fmt::format("there is no limit '{}': {}", word.substr(0, equals), names);
    }
    const std::string_view number = equals == word.npos ? "" : word.substr(equals + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size() || !(value >= 1 && value <= double(entry->most)))
        return fmt::format("'{}' is not {}= and a number from 1 to {}", word, entry->name, entry->most);
    limits.*entry->value = uint64_t(value);
    return {};
}

std::string how_to_raise(const Limits& limits, uint64_t Limits::*value, double needed) {
    const auto entry = std::find_if(std::begin(kEntries), std::end(kEntries), [&](const LimitEntry& e) { return e.value == value; });
    if (entry == std::end(kEntries) || limits.*value >= entry->most || needed > double(entry->most)) return {};
    const uint64_t enough = std::max(std::min(limits.*value * 2, entry->most), uint64_t(std::ceil(needed)));
    return fmt::format("--limit {}={} would allow more, up to {}", entry->name, enough, entry->most);
}

}  // namespace alidade::pov
