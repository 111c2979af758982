// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/obj_text.h"

#include "core/image.h"
#include "importers/mesh/reporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <unordered_map>

namespace alidade::mesh {
namespace {

/// Reads one file; a member function for each statement.
class ObjReader {
  public:
    ObjReader(std::string_view text, uint32_t file, bool strict, Diagnostics& said) : cursor_(text), report_(said, file, cursor_, strict), file_(file) {
        out_.objects.push_back({"", {file, 1, 1, {}}});
    }

    std::optional<ObjText> read();

  private:
    using Mark = TextCursor::Mark;

    struct Statement {
        std::string_view word;
        void (ObjReader::*read)();
    };
    /// What an index of a corner can name.
    struct Indexed {
        const char* name;
        uint32_t Corner::*member;
        size_t (*count)(const ObjText&);
    };
    /// An index that named nothing when it was read; it is wrong only if nothing has come by the end.
    struct Forward {
        Mark at;
        uint32_t index;
        const Indexed* what;
    };
    static constexpr Indexed kVertex{"vertex", &Corner::position, [](const ObjText& t) { return t.positions.size(); }};
    static constexpr Indexed kUv{"texture coordinate", &Corner::uv, [](const ObjText& t) { return t.uvs.size(); }};
    static constexpr Indexed kNormal{"normal", &Corner::normal, [](const ObjText& t) { return t.normals.size(); }};

    static std::span<const Statement> statements();

    void position();
    void normal();
    void uv();
    void face();
    void object() { begin_object(std::string(cursor_.rest_of_line())); }
    void smoothing();
    void material();
    void library() { out_.libraries.push_back({std::string(cursor_.rest_of_line()), report_.place(statement_)}); }
    void ignored() {}   // of no meaning for a renderer: groups are merged
    void left_out() { report_.tally(statement_, fmt::format("{} is not supported: left out", report_word_)); }

    void line();
    void begin_object(std::string name);
    void set_color(const double (&values)[6], const Mark& at);
    std::optional<size_t> numbers(std::span<double> values, size_t least, const char* what);
    bool corner(Corner& corner);
    bool index(Corner& corner, const Indexed& what);
    bool names_nothing(const Mark& at, size_t known, const Indexed& what);
    bool whole_corner(const Mark& at);
    void begin_section();
    void check_forward();

    TextCursor cursor_;
    Reporter report_;
    uint32_t file_;
    ObjText out_;
    Section state_;                 ///< of the next face
    bool state_changed_ = true;
    Mark statement_{};              ///< where the current statement begins
    std::string_view report_word_;  ///< and its keyword
    size_t understood_ = 0;
    std::vector<Forward> forward_;
    std::unordered_map<std::string, uint32_t> material_of_;
    bool number_exceeds_float_ = false;
};

std::span<const ObjReader::Statement> ObjReader::statements() {
    static constexpr Statement table[] = {
        {"v", &ObjReader::position}, {"f", &ObjReader::face},       {"vt", &ObjReader::uv},           {"vn", &ObjReader::normal},
        {"o", &ObjReader::object},   {"s", &ObjReader::smoothing},  {"usemtl", &ObjReader::material}, {"mtllib", &ObjReader::library},
        {"g", &ObjReader::ignored},  {"lod", &ObjReader::ignored},  {"bevel", &ObjReader::ignored},   {"c_interp", &ObjReader::ignored},
        {"d_interp", &ObjReader::ignored}, {"shadow_obj", &ObjReader::ignored}, {"trace_obj", &ObjReader::ignored},
        // Points, lines, free-form curves and surfaces, and what belongs to them.
        {"p", &ObjReader::left_out},     {"l", &ObjReader::left_out},     {"vp", &ObjReader::left_out},     {"cstype", &ObjReader::left_out},
        {"deg", &ObjReader::left_out},   {"bmat", &ObjReader::left_out},  {"step", &ObjReader::left_out},   {"curv", &ObjReader::left_out},
        {"curv2", &ObjReader::left_out}, {"surf", &ObjReader::left_out},  {"parm", &ObjReader::left_out},   {"trim", &ObjReader::left_out},
        {"hole", &ObjReader::left_out},  {"scrv", &ObjReader::left_out},  {"sp", &ObjReader::left_out},     {"end", &ObjReader::left_out},
        {"con", &ObjReader::left_out},   {"mg", &ObjReader::left_out},    {"ctech", &ObjReader::left_out},  {"stech", &ObjReader::left_out},
        {"call", &ObjReader::left_out},  {"csh", &ObjReader::left_out},   {"maplib", &ObjReader::left_out}, {"usemap", &ObjReader::left_out},
    };
    return table;
}

std::optional<ObjText> ObjReader::read() {
    for (; !cursor_.at_end() && report_.diagnostics().errors() < Diagnostics::kKept; cursor_.next_line())
        if (!cursor_.at_line_end()) line();
    check_forward();
    report_.tell_tallies();
    if (understood_ == 0 && !report_.diagnostics().has_errors())
        report_.diagnostics().error({file_, 0, 0, {}}, "no OBJ statement is in this file", "an OBJ file has lines such as `v 0 0 0` and `f 1 2 3`");
    if (report_.diagnostics().has_errors()) return std::nullopt;
    if (!out_.colors.empty()) out_.colors.resize(out_.positions.size(), Vec4f(1));
    return std::move(out_);
}

void ObjReader::line() {
    statement_ = cursor_.mark();
    report_word_ = cursor_.word();
    for (const Statement& s : statements())
        if (s.word == report_word_) {
            ++understood_;
            (this->*s.read)();
            return;
        }
    report_.tally(statement_, fmt::format("unknown statement \"{}\"", cursor_.word_at(statement_)));
}

/// The numbers of a statement: at least `least`, those beyond values.size() are left out.
std::optional<size_t> ObjReader::numbers(std::span<double> values, size_t least, const char* what) {
    size_t count = 0;
    number_exceeds_float_ = false;
    while (!cursor_.at_line_end()) {
        const Mark at = cursor_.mark();
        if (count == values.size()) {
            report_.tally(at, fmt::format("{} has more than {} numbers: the rest is left out", what, values.size()));
            break;
        }
        const std::optional<Number> n = cursor_.number();
        if (!n) {
            report_.error(at, fmt::format("\"{}\" is not a number", cursor_.word_at(at)));
            return std::nullopt;
        }
        number_exceeds_float_ = number_exceeds_float_ || n->exceeds_float;
        values[count++] = n->value;
    }
    if (count >= least) return count;
    report_.error(statement_, fmt::format("{} needs {} numbers, here are {}", what, least, count));
    return std::nullopt;
}

void ObjReader::position() {
    double values[6] = {};
    const std::optional<size_t> count = numbers(values, 3, "v");
    if (!count) return;
    out_.positions.emplace_back(values[0], values[1], values[2]);
    out_.exceeds_float = out_.exceeds_float || number_exceeds_float_;
    if (*count == 4 && values[3] != 1) report_.tally(statement_, "the weight w of a vertex is for curves only: left out");
    if (*count == 5) report_.tally(statement_, "v with 5 numbers: the last two are left out");
    if (*count == 6) set_color(values, statement_);
}

/// The file's colours are sRGB-encoded, as Blender and MeshLab write them.
void ObjReader::set_color(const double (&values)[6], const Mark& at) {
    Vec4f color(1);
    if (std::isfinite(values[3]) && std::isfinite(values[4]) && std::isfinite(values[5]))
        color = Vec4f(float(srgb_to_linear(values[3])), float(srgb_to_linear(values[4])), float(srgb_to_linear(values[5])), 1.0f);
    else report_.tally(at, "a vertex colour is not finite: taken for white");
    out_.colors.resize(out_.positions.size() - 1, Vec4f(1));
    out_.colors.push_back(color);
}

void ObjReader::normal() {
    double values[3] = {};
    if (!numbers(values, 3, "vn")) return;
    if (!out_.add_normal({values[0], values[1], values[2]})) report_.tally(statement_, "a normal is not finite: the polygon's own is taken");
}

void ObjReader::uv() {
    double values[3] = {};
    if (!numbers(values, 1, "vt")) return;
    if (!out_.add_uv(values[0], values[1])) report_.tally(statement_, "a texture coordinate is not finite: taken for 0 0");
}

/// A face cannot do without its vertices; without a texture coordinate or a normal it can, and such files are common.
bool ObjReader::names_nothing(const Mark& at, size_t known, const Indexed& what) {
    const std::string word = cursor_.word_at(at), index = word.substr(0, word.find('/'));   // as the file has it: what was read of it may be cut to 32 bits
    if (&what == &kVertex) report_.error(at, fmt::format("index {} of a vertex: there are only {}{}", index, known, index[0] == '-' ? " before this line" : ""));
    else report_.tally(at, fmt::format("an index of a {} names nothing: left out", what.name));
    return &what != &kVertex;
}

bool ObjReader::index(Corner& corner, const Indexed& what) {
    const Mark at = cursor_.mark();
    const std::optional<int32_t> read = cursor_.integer();
    const size_t known = what.count(out_);
    if (!read) {
        report_.error(at, fmt::format("\"{}\" is not the index of a {}", cursor_.word_at(at), what.name), "a corner is v, v/vt, v//vn or v/vt/vn, in whole numbers");
        return false;
    }
    if (*read == 0) {
        report_.error(at, fmt::format("the index of a {} is 0", what.name), "indices count from 1, or from -1 backwards");
        return false;
    }
    const int64_t index = *read > 0 ? int64_t(*read) - 1 : int64_t(known) + *read;
    if (index < 0) return names_nothing(at, known, what);
    corner.*what.member = uint32_t(index);
    if (size_t(index) >= known) forward_.push_back({at, uint32_t(index), &what});
    return true;
}

bool ObjReader::corner(Corner& corner) {
    const Mark at = cursor_.mark();
    std::array<uint32_t, 3> n;
    if (cursor_.plain_corner(n) && n[0] <= out_.positions.size() && n[1] <= out_.uvs.size() && n[2] <= out_.normals.size()) {
        static_assert(kAbsent == uint32_t(0) - 1);
        corner = {n[0] - 1, n[1] - 1, n[2] - 1};
        return true;
    }
    cursor_.back_to(at);
    if (!index(corner, kVertex)) return false;
    if (!cursor_.accept('/')) return whole_corner(at);
    if (!cursor_.accept('/')) {
        if (cursor_.at_word_end()) return true;   // "1/": some writers leave an empty index
        if (!index(corner, kUv)) return false;
        if (!cursor_.accept('/')) return whole_corner(at);
    }
    if (cursor_.at_word_end()) return true;
    return index(corner, kNormal) && whole_corner(at);
}

bool ObjReader::whole_corner(const Mark& at) {
    if (cursor_.at_word_end()) return true;
    report_.error(cursor_.mark(), fmt::format("\"{}\" is not a corner", cursor_.word_at(at)), "a corner is v, v/vt, v//vn or v/vt/vn, in whole numbers");
    return false;
}

void ObjReader::face() {
    const size_t first = out_.corners.size();
    while (!cursor_.at_line_end()) {
        Corner c{};
        if (!corner(c)) return;
        out_.corners.push_back(c);
    }
    const size_t count = out_.corners.size() - first;
    if (count < 3) {
        report_.error(statement_, fmt::format("a face needs 3 corners, here are {}", count));
    } else if (out_.corners.size() >= kAbsent) {
        report_.error(statement_, "the file has too many corners");
    } else {
        begin_section();
        out_.faces.push_back({uint32_t(first), uint32_t(count), statement_.line});
    }
}

void ObjReader::begin_section() {
    if (!state_changed_) return;
    state_.first_face = uint32_t(out_.faces.size());
    out_.sections.push_back(state_);
    state_changed_ = false;
}

void ObjReader::begin_object(std::string name) {
    out_.objects.push_back({std::move(name), report_.place(statement_)});
    state_.object = uint32_t(out_.objects.size() - 1);
    state_changed_ = true;
}

void ObjReader::smoothing() {
    const Mark at = (cursor_.at_line_end(), cursor_.mark());
    uint32_t group = 0;
    if (const std::optional<int32_t> n = cursor_.integer(); n && *n >= 0 && cursor_.at_word_end()) {
        group = uint32_t(*n);
    } else {
        cursor_.back_to(at);
        const std::string_view word = cursor_.word();
        if (word == "on") group = 1;
        else if (word != "off" && !word.empty()) report_.tally(at, "a smoothing group is a number or off: taken for off");
    }
    state_changed_ = state_changed_ || group != state_.smoothing;
    state_.smoothing = group;
}

void ObjReader::material() {
    const std::string name(cursor_.rest_of_line());
    const auto [known, added] = material_of_.try_emplace(name, uint32_t(out_.materials.size()));
    if (added) out_.materials.push_back({name, report_.place(statement_)});
    state_changed_ = state_changed_ || known->second != state_.material;
    state_.material = known->second;
}

void ObjReader::check_forward() {
    bool dangling = false;
    for (const Forward& f : forward_) {
        const size_t count = f.what->count(out_);
        if (f.index < count) continue;
        names_nothing(f.at, count, *f.what);
        dangling = true;
    }
    if (!dangling) return;
    for (Corner& c : out_.corners) {
        if (c.uv >= out_.uvs.size()) c.uv = kAbsent;
        if (c.normal >= out_.normals.size()) c.normal = kAbsent;
    }
}

}  // namespace

bool ObjText::add_normal(const Vec3& normal) {
    const Vec3 n = normalized(normal);
    normals.push_back(is_finite(n) ? Vec3f(n) : Vec3f(0));
    return is_finite(n);
}

bool ObjText::add_uv(double u, double v) {
    const Vec2f uv{float(u), float(1 - v)};
    const bool finite = std::isfinite(uv.x) && std::isfinite(uv.y);
    uvs.push_back(finite ? uv : Vec2f(0, 1));
    return finite;
}

std::optional<ObjText> read_obj_text(std::string_view text, uint32_t file, bool strict, Diagnostics& said) {
    return ObjReader(text, file, strict, said).read();
}

bool begins_like_obj(std::string_view text) {
    TextCursor cursor(text);
    while (!cursor.at_end() && cursor.at_line_end()) cursor.next_line();
    const std::string_view word = cursor.word();
    for (const char* known : {"v", "vt", "vn", "vp", "f", "g", "o", "s", "usemtl", "mtllib"})
        if (word == known && !cursor.at_end()) return true;
    return false;
}

}  // namespace alidade::mesh
