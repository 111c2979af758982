// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace alidade::mesh {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr TypeName kTypeNames[] = {
    {"char", PlyType::int8},    {"uchar", PlyType::uint8},  {"short", PlyType::int16},  {"ushort", PlyType::uint16},
    {"int", PlyType::int32},    {"uint", PlyType::uint32},  {"float", PlyType::float32}, {"double", PlyType::float64},
    {"int8", PlyType::int8},    {"uint8", PlyType::uint8},  {"int16", PlyType::int16},  {"uint16", PlyType::uint16},
    {"int32", PlyType::int32},  {"uint32", PlyType::uint32}, {"float32", PlyType::float32}, {"float64", PlyType::float64},
};

struct EncodingName {
    std::string_view name;
    PlyEncoding encoding;
};
constexpr EncodingName kEncodings[] = {
    {"ascii", PlyEncoding::ascii}, {"binary_little_endian", PlyEncoding::little_endian}, {"binary_big_endian", PlyEncoding::big_endian}};

class HeaderReader {
  public:
    HeaderReader(TextCursor& cursor, Reporter& report) : cursor_(cursor), report_(report) {}

    std::optional<PlyHeader> read();

  private:
    bool statement(std::string_view word);
    bool format();
    bool element();
    bool property();
    bool type(PlyType& out);
    bool name(std::string& out, const char* what);
    bool fail(const TextCursor::Mark& at, std::string message) {
        report_.error(at, std::move(message));
        return false;
    }
    TextCursor::Mark next_mark() {
        cursor_.at_line_end();   // skips blanks
        return cursor_.mark();
    }

    TextCursor& cursor_;
    Reporter& report_;
    TextCursor::Mark statement_{};
    PlyHeader header_;
    std::set<std::string> names_;
    bool has_format_ = false;
};

bool HeaderReader::format() {
    const TextCursor::Mark at = next_mark();
    const std::string_view word = cursor_.word();
    const auto* known = std::find_if(std::begin(kEncodings), std::end(kEncodings), [&](const EncodingName& e) { return e.name == word; });
    if (known == std::end(kEncodings))
        return fail(at, fmt::format("\"{}\" is no PLY encoding: ascii, binary_little_endian or binary_big_endian", cursor_.word_at(at)));
    header_.encoding = known->encoding;
    const TextCursor::Mark version = next_mark();
    if (cursor_.word() != "1.0") return fail(version, fmt::format("PLY version \"{}\" is not known, only 1.0", cursor_.word_at(version)));
    return has_format_ = true;
}

bool HeaderReader::name(std::string& out, const char* what) {
    out = std::string(cursor_.word());
    return !out.empty() || fail(statement_, fmt::format("{} without a name", what));
}

bool HeaderReader::element() {
    PlyElement e;
    e.at = statement_;
    if (!name(e.name, "element")) return false;
    if (!names_.insert(e.name).second) return fail(statement_, "there is already an element of this name");
    const TextCursor::Mark at = next_mark();
    const std::string_view digits = cursor_.word();
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), e.count);
    if (error != std::errc() || end != digits.data() + digits.size())
        return fail(at, fmt::format("\"{}\" is not the number of elements", cursor_.word_at(at)));
    header_.elements.push_back(std::move(e));
    return true;
}

bool HeaderReader::type(PlyType& out) {
    const TextCursor::Mark at = next_mark();
    const std::string_view word = cursor_.word();
    for (const TypeName& t : kTypeNames)
        if (t.name == word) return out = t.type, true;
    return fail(at, fmt::format("\"{}\" is not a PLY type", cursor_.word_at(at)));
}

bool HeaderReader::property() {
    if (header_.elements.empty()) return fail(statement_, "a property before any element");
    PlyProperty p{};
    const TextCursor::Mark at = next_mark();
    if (cursor_.word() == "list") {
        const TextCursor::Mark count = next_mark();
        if (!type(p.count_type.emplace())) return false;
        if (!is_integer(*p.count_type)) return fail(count, "the length of a list must be an integer");
    } else {
        cursor_.back_to(at);
    }
    if (!type(p.type) || !name(p.name, "property")) return false;
    header_.elements.back().properties.push_back(std::move(p));
    return true;
}

bool HeaderReader::statement(std::string_view word) {
    if (word == "format") return format();
    if (word == "element") return element();
    if (word == "property") return property();
    if (word == "comment" || word == "obj_info") return true;
    return fail(statement_, fmt::format("\"{}\" is no statement of a PLY header", cursor_.word_at(statement_)));
}

std::optional<PlyHeader> HeaderReader::read() {
    const TextCursor::Mark start = cursor_.mark();
    if (cursor_.word() != "ply") return fail(start, "a PLY file begins with the line \"ply\""), std::nullopt;
    for (cursor_.next_line(); !cursor_.at_end(); cursor_.next_line()) {
        if (cursor_.at_line_end()) continue;
        statement_ = cursor_.mark();
        const std::string_view word = cursor_.word();
        if (word != "end_header") {
            if (!statement(word)) return std::nullopt;
            continue;
        }
        if (!has_format_) return fail(statement_, "the header has no format statement"), std::nullopt;
        cursor_.next_line();
        return std::move(header_);
    }
    return fail(cursor_.mark(), "the file ends in its header: there is no end_header"), std::nullopt;
}

}  // namespace

size_t size_of(PlyType type) {
    constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[size_t(type)];
}

bool is_integer(PlyType type) { return type < PlyType::float32; }

double largest(PlyType type) {
    constexpr double kLargest[] = {127, 255, 32767, 65535, 2147483647, 4294967295};
    return kLargest[size_t(type)];
}

std::optional<PlyHeader> read_ply_header(TextCursor& cursor, Reporter& report) { return HeaderReader(cursor, report).read(); }

}  // namespace alidade::mesh
