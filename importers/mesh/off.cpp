// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/off.h"

#include "core/image.h"
#include "importers/mesh/reporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace alidade {
namespace mesh {
namespace {

/// What stands on the line of a vertex, in this order after its coordinates.
struct VertexFormat {
    bool has_uv = false, has_color = false, has_normal = false, homogeneous = false, any_dimension = false;

    size_t coordinates() const { return homogeneous ? 4 : 3; }
    /// Without colours, of which there may be 3 or 4 numbers.
    size_t numbers() const { return coordinates() + (has_normal ? 3 : 0) + (has_uv ? 2 : 0); }
};

/// The meaning of the first word, [ST][C][N][4][n]OFF; nothing if it is another word.
std::optional<VertexFormat> parse_first_word(std::string_view word) {
    VertexFormat format;
    const auto take = [&](std::string_view prefix) { return word.starts_with(prefix) && (word.remove_prefix(prefix.size()), true); };
    format.has_uv = take("ST");
    format.has_color = take("C");
    format.has_normal = take("N");
    format.homogeneous = take("4");
    format.any_dimension = take("n");
    if (word != "OFF") return std::nullopt;
    return format;
}

class OffReader {
  public:
    OffReader(std::string_view text, uint32_t file, bool strict, Diagnostics& said) : cursor_(text), report_(said, file, cursor_, strict), end_(text.data() + text.size()) {
        begin_only_object(out_, file);
    }

    std::optional<ObjText> read();

  private:
    /// The most numbers of a vertex: 4 coordinates, 3 of a normal, 4 of a colour, 2 of a texture.
    static constexpr size_t kMostNumbers = 13;
    static constexpr float kNoAlpha = std::numeric_limits<float>::quiet_NaN();

    bool first_word();
    bool counts();
    bool count(uint64_t& out, const char* what);
    bool vertex();
    bool set_vertex(std::span<const double> values);
    bool face();
    bool index(uint32_t& out);
    bool next_line(const char* what);
    void decode_colors();
    bool fail(const TextCursor::Mark& at, std::string message, std::string hint = {}) {
        report_.error(at, std::move(message), std::move(hint));
        return false;
    }

    TextCursor cursor_;
    Reporter report_;
    const char* end_;
    VertexFormat format_;
    uint64_t vertices_ = 0, faces_ = 0;
    ObjText out_;
};

/// Skips blank lines and comments; the line's own end is skipped by whoever has read it.
bool OffReader::next_line(const char* what) {
    while (!cursor_.at_end() && cursor_.at_line_end()) cursor_.next_line();
    return !cursor_.at_end() || fail(cursor_.mark(), fmt::format("the file ends before {}", what));
}

bool OffReader::first_word() {
    if (!next_line("its first word")) return false;
    const TextCursor::Mark at = cursor_.mark();
    const std::optional<VertexFormat> format = parse_first_word(cursor_.word());
    if (!format) return fail(at, fmt::format("\"{}\" is no first word of an OFF file", cursor_.word_at(at)), "it is OFF, or COFF, NOFF, STOFF, 4OFF and the like");
    if (format->any_dimension) return fail(at, "meshes of any dimension (nOFF) are not supported");
    format_ = *format;
    if (!next_line("its counts")) return false;
    const TextCursor::Mark second = cursor_.mark();
    if (cursor_.word() == "BINARY") return fail(second, "binary OFF files are not supported", "save it as text");
    cursor_.back_to(second);
    return true;
}

bool OffReader::count(uint64_t& out, const char* what) {
    cursor_.at_line_end();   // skips blanks
    const TextCursor::Mark at = cursor_.mark();
    const std::string_view digits = cursor_.word();
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out);
    if (error != std::errc() || end != digits.data() + digits.size()) return fail(at, fmt::format("\"{}\" is not the number of {}", cursor_.word_at(at), what));
    return true;
}

/// The counts are not believed: each number takes two bytes, with what separates it from the next.
bool OffReader::counts() {
    const TextCursor::Mark at = cursor_.mark();
    if (!count(vertices_, "vertices") || !count(faces_, "faces")) return false;
    cursor_.next_line();   // the number of edges is of no use, and often wrong
    const uint64_t left = uint64_t(end_ - cursor_.mark().at) + 1;
    const uint64_t most_vertices = std::min<uint64_t>(left / (2 * format_.numbers()), kAbsent - 1);
    if (vertices_ > most_vertices) return fail(at, fmt::format("{} vertices are promised: the file has bytes for {} at most", vertices_, most_vertices));
    const uint64_t most_faces = (left - vertices_ * 2 * format_.numbers()) / 2;
    if (faces_ > most_faces) return fail(at, fmt::format("{} faces are promised: the file has bytes for {} at most", faces_, most_faces));
    return true;
}

bool OffReader::vertex() {
    if (!next_line("its last vertex")) return false;
    const TextCursor::Mark line = cursor_.mark();
    std::array<double, kMostNumbers> values{};
    const size_t least = format_.numbers() + (format_.has_color ? 3 : 0), most = format_.numbers() + (format_.has_color ? 4 : 0);
    size_t count = 0;
    while (count < most && !cursor_.at_line_end()) {
        const TextCursor::Mark at = cursor_.mark();
        const std::optional<Number> number = cursor_.number();
        if (!number) return fail(at, fmt::format("\"{}\" is not a number", cursor_.word_at(at)));
        if (count < format_.coordinates()) out_.exceeds_float = out_.exceeds_float || number->exceeds_float;
        values[count++] = number->value;
    }
    if (count < least) return fail(line, fmt::format("a vertex needs {} numbers, here are {}", least, count));
    if (!cursor_.at_line_end()) report_.tally(cursor_.mark(), fmt::format("a vertex has more than {} numbers: the rest is left out", most));
    cursor_.next_line();
    if (!set_vertex({values.data(), count})) report_.tally(line, "a normal or texture coordinate is not finite: left out");
    return true;
}

/// False if something is not finite that need not be there.
bool OffReader::set_vertex(std::span<const double> values) {
    const double w = format_.homogeneous ? values[3] : 1;
    out_.positions.emplace_back(values[0] / w, values[1] / w, values[2] / w);
    values = values.subspan(format_.coordinates());
    bool finite = true;
    if (format_.has_normal) {
        finite = out_.add_normal({values[0], values[1], values[2]});
        values = values.subspan(3);
    }
    if (format_.has_color) {
        const size_t components = values.size() - (format_.has_uv ? 2 : 0);
        out_.colors.emplace_back(float(values[0]), float(values[1]), float(values[2]), components == 4 ? float(values[3]) : kNoAlpha);
        values = values.subspan(components);
    }
    if (format_.has_uv) finite = out_.add_uv(values[0], values[1]) && finite;
    return finite;
}

bool OffReader::index(uint32_t& out) {
    const bool missing = cursor_.at_line_end();
    const TextCursor::Mark at = cursor_.mark();
    if (missing) return fail(at, "the line ends before the last index of its face");
    const std::optional<int32_t> read = cursor_.integer();
    if (!read || !cursor_.at_word_end()) return fail(at, fmt::format("\"{}\" is not the index of a vertex", cursor_.word_at(at)));
    if (*read < 0 || uint64_t(*read) >= vertices_)
        return fail(at, fmt::format("index {} of a vertex: there are only {}, counted from 0", *read, vertices_));
    out = uint32_t(*read);
    return true;
}

bool OffReader::face() {
    if (!next_line("its last face")) return false;
    const TextCursor::Mark line = cursor_.mark();
    uint64_t corners = 0;
    if (!count(corners, "a face's corners")) return false;
    const size_t first = out_.corners.size();
    for (uint64_t i = 0; i < corners; ++i) {
        uint32_t vertex = 0;
        if (!index(vertex)) return false;
        out_.corners.push_back({vertex, format_.has_uv ? vertex : kAbsent, format_.has_normal ? vertex : kAbsent});
    }
    if (!add_face(out_, first, line.line)) return fail(line, "the file has too many corners");
    if (!cursor_.at_line_end()) report_.tally(cursor_.mark(), "colours of faces are not supported: left out");
    cursor_.next_line();
    return true;
}

/// The numbers are kept as the file has them until the greatest is known.
void OffReader::decode_colors() {
    const bool bytes = std::any_of(out_.colors.begin(), out_.colors.end(), [](const Vec4f& c) { return c.x > 1 || c.y > 1 || c.z > 1 || c.w > 1; });
    for (Vec4f& c : out_.colors) {
        if (bytes) {
            for (int k = 0; k < 3; ++k) c[k] = float(srgb_to_linear(double(c[k]) / 255));
            c.w /= 255;
        }
        if (std::isnan(c.w)) c.w = 1;   // kNoAlpha
        if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && std::isfinite(c.w))) c = Vec4f(1);
    }
}

std::optional<ObjText> OffReader::read() {
    if (!first_word() || !counts()) return std::nullopt;
    for (uint64_t i = 0; i < vertices_; ++i)
        if (!vertex()) return std::nullopt;
    for (uint64_t i = 0; i < faces_; ++i)
        if (!face()) return std::nullopt;
    decode_colors();
    while (!cursor_.at_end() && cursor_.at_line_end()) cursor_.next_line();
    report_.tell_tallies();
    Diagnostics& said = report_.diagnostics();
    if (!cursor_.at_end()) said.note(report_.place(cursor_.mark()), fmt::format("what stands behind the last of {} faces is left out", faces_));
    if (said.has_errors()) return std::nullopt;
    return std::move(out_);
}

std::string_view as_text(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

}  // namespace

std::optional<ObjText> read_off(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said) {
    return OffReader(as_text(bytes), file, strict, said).read();
}

}  // namespace mesh

ImportResult import_off(const std::string& path, const ImportOptions& options) { return mesh::import_mesh_file(path, options, mesh::read_off); }

bool looks_like_off(std::span<const std::byte> head) {
    mesh::TextCursor cursor(mesh::as_text(head));
    const auto skip = [&] {
        while (!cursor.at_end() && cursor.at_line_end()) cursor.next_line();
    };
    skip();
    if (!mesh::parse_first_word(cursor.word())) return false;
    skip();
    return cursor.integer().has_value();
}

}  // namespace alidade
