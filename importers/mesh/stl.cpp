// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/stl.h"

#include "importers/mesh/reporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace alidade {
namespace mesh {
namespace {

constexpr size_t kHeaderBytes = 84, kTriangleBytes = 50;   // of binary files: 80 bytes of text and a count; normal, corners, attribute

std::string lower_case(std::string_view word) {
    std::string out(word);
    for (char& c : out) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return out;
}

/// Little-endian, on any machine.
uint32_t read_uint32(std::span<const std::byte> bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value |= uint32_t(bytes[at + i]) << (8 * i);
    return value;
}

double read_float(std::span<const std::byte> bytes, size_t at) { return double(std::bit_cast<float>(read_uint32(bytes, at))); }

/// Replaces the corners' positions, one each, by those that differ. Sorting takes n log n whatever the positions are; a hash table would not.
void weld(ObjText& out) {
    struct Key {
        std::array<uint64_t, 3> bits;   // so that all can be ordered, NaN too
        uint32_t index;
    };
    std::vector<Key> keys(out.positions.size());
    for (size_t i = 0; i < keys.size(); ++i) {
        const Vec3 p = out.positions[i] + Vec3(0);   // turns -0 into 0
        keys[i] = {{std::bit_cast<uint64_t>(p.x), std::bit_cast<uint64_t>(p.y), std::bit_cast<uint64_t>(p.z)}, uint32_t(i)};
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.bits != b.bits ? a.bits < b.bits : a.index < b.index; });
    std::vector<Vec3> welded;
    for (size_t i = 0; i < keys.size(); ++i) {
        if (i == 0 || keys[i].bits != keys[i - 1].bits) welded.push_back(out.positions[keys[i].index]);
        out.corners[keys[i].index].position = uint32_t(welded.size() - 1);
    }
    out.positions = std::move(welded);
}

void add_vertex(ObjText& out, const Vec3& position) {
    out.corners.push_back({uint32_t(out.positions.size()), kAbsent, kAbsent});
    out.positions.push_back(position);
}

std::optional<ObjText> read_binary(std::span<const std::byte> bytes, uint32_t file, Diagnostics& said) {
    const SourcePos whole_file{file, 0, 0, {}};
    if (bytes.size() < kHeaderBytes) return said.error(whole_file, "neither STL text nor binary STL, which has 84 bytes at least"), std::nullopt;
    const size_t promised = read_uint32(bytes, kHeaderBytes - 4), here = (bytes.size() - kHeaderBytes) / kTriangleBytes;
    if (here < promised)
        return said.error(whole_file, fmt::format("the file is cut off: it promises {} triangles and holds {}", promised, here)), std::nullopt;
    if (promised == 0 && bytes.size() > kHeaderBytes)
        return said.error(whole_file, fmt::format("the file promises no triangles, but {} bytes follow", bytes.size() - kHeaderBytes)), std::nullopt;
    ObjText out;
    begin_only_object(out, file);
    for (size_t t = 0; t < promised; ++t) {
        const size_t first = out.corners.size(), corners = kHeaderBytes + t * kTriangleBytes + 12;
        for (size_t at = corners; at < corners + 36; at += 12) add_vertex(out, {read_float(bytes, at), read_float(bytes, at + 4), read_float(bytes, at + 8)});
        if (!add_face(out, first, 0)) return said.error(whole_file, "the file has too many triangles"), std::nullopt;
    }
    const size_t rest = bytes.size() - kHeaderBytes - promised * kTriangleBytes;
    if (rest) said.note(whole_file, fmt::format("{} bytes behind the last of {} triangles are left out", rest, promised));
    return out;
}

/// Reads STL text, a line at a time.
class StlText {
  public:
    StlText(std::string_view text, uint32_t file, bool strict, Diagnostics& said) : cursor_(text), report_(said, file, cursor_, strict) {
        begin_only_object(out_, file);
    }

    std::optional<ObjText> read();

  private:
    bool line();
    bool vertex();
    bool end_loop();
    bool fail(std::string message) {
        report_.error(line_, std::move(message));
        return false;
    }

    TextCursor cursor_;
    Reporter report_;
    ObjText out_;
    TextCursor::Mark line_{};
    size_t first_ = 0;          ///< corner of the loop that is open
    bool in_loop_ = false, in_solid_ = false;
};

bool StlText::vertex() {
    if (!in_loop_) return fail("a vertex outside of a loop");
    std::array<double, 3> values{};
    for (double& value : values) {
        const bool missing = cursor_.at_line_end();
        const TextCursor::Mark at = cursor_.mark();
        if (missing) return fail("a vertex needs 3 numbers");
        const std::optional<Number> number = cursor_.number();
        if (!number) return report_.error(at, fmt::format("\"{}\" is not a number", cursor_.word_at(at))), false;
        out_.exceeds_float = out_.exceeds_float || number->exceeds_float;
        value = number->value;
    }
    add_vertex(out_, {values[0], values[1], values[2]});
    return true;
}

bool StlText::end_loop() {
    const size_t count = out_.corners.size() - first_;
    if (!in_loop_ || count != 3) return fail(fmt::format("a loop ends that has {} vertices: it must have 3", in_loop_ ? count : 0));
    in_loop_ = false;
    return add_face(out_, first_, line_.line) || fail("the file has too many triangles");
}

bool StlText::line() {
    line_ = cursor_.mark();
    const std::string word = lower_case(cursor_.word());
    if (word == "vertex") return vertex();
    if (word == "endloop") return end_loop();
    if (in_loop_) return fail(fmt::format("\"{}\" in a loop, where only a vertex or endloop can stand", cursor_.word_at(line_)));
    if (word == "outer") {
        if (!in_solid_) return fail("a loop outside of a solid");
        in_loop_ = true, first_ = out_.corners.size();
    } else if (word == "solid" || word == "endsolid") {
        in_solid_ = word == "solid";
    } else if (word != "facet" && word != "endfacet") {
        report_.tally(line_, fmt::format("unknown statement \"{}\"", cursor_.word_at(line_)));
    }
    return true;
}

std::optional<ObjText> StlText::read() {
    for (; !cursor_.at_end(); cursor_.next_line())
        if (!cursor_.at_line_end() && !line()) return std::nullopt;
    line_ = cursor_.mark();
    if (in_loop_ || in_solid_) return fail(fmt::format("the file is cut off: it holds {} triangles and no endsolid", out_.faces.size())), std::nullopt;
    report_.tell_tallies();
    if (report_.diagnostics().has_errors()) return std::nullopt;
    return std::move(out_);
}

/// Is the size what the count says?
bool is_whole_binary(std::span<const std::byte> bytes) {
    return bytes.size() >= kHeaderBytes && bytes.size() - kHeaderBytes == uint64_t(read_uint32(bytes, kHeaderBytes - 4)) * kTriangleBytes;
}

std::string_view as_text(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// The first word of a text, and that of its second line; blank lines do not count.
std::pair<std::string, std::string> first_words(std::string_view text) {
    TextCursor cursor(text);
    std::array<std::string, 2> words;
    for (std::string& word : words) {
        while (!cursor.at_end() && cursor.at_line_end()) cursor.next_line();
        word = lower_case(cursor.word());
        cursor.next_line();
    }
    return {words[0], words[1]};
}

}  // namespace

std::optional<ObjText> read_stl(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said) {
    const std::string_view text = as_text(bytes);
    const bool is_text = !is_whole_binary(bytes) && first_words(text).first == "solid" && text.find('\0') == std::string_view::npos;
    std::optional<ObjText> out = is_text ? StlText(text, file, strict, said).read() : read_binary(bytes, file, said);
    if (out) weld(*out);
    return out;
}

}  // namespace mesh

ImportResult import_stl(const std::string& path, const ImportOptions& options) { return mesh::import_mesh_file(path, options, mesh::read_stl); }

bool looks_like_stl(std::span<const std::byte> head) {
    const auto [first, second] = mesh::first_words(mesh::as_text(head));
    return mesh::is_whole_binary(head) || (first == "solid" && (second == "facet" || second == "endsolid"));
}

}  // namespace alidade
