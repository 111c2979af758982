// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/ply.h"

#include "core/image.h"
#include "importers/mesh/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace alidade {
namespace mesh {
namespace {

/// Where the values of a vertex are kept until it is complete.
enum Scalar { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kAlpha, kScalars };
enum List { kIndices, kTexcoords, kLists };
constexpr int kUnused = -1;

struct Meaning {
    std::string_view name;
    int place;
};
constexpr Meaning kVertexProperties[] = {
    {"x", kX},           {"y", kY},           {"z", kZ},         {"nx", kNx},         {"ny", kNy},   {"nz", kNz},     {"u", kU},       {"v", kV},
    {"s", kU},           {"t", kV},           {"texture_u", kU}, {"texture_v", kV},   {"red", kRed}, {"green", kGreen}, {"blue", kBlue}, {"alpha", kAlpha},
};
constexpr Meaning kFaceLists[] = {{"vertex_indices", kIndices}, {"vertex_index", kIndices}, {"texcoord", kTexcoords}};

/// Reads one file, element by element.
class PlyReader {
  public:
    PlyReader(std::string_view text, uint32_t file, bool strict, Diagnostics& said) : text_(text), file_(file), strict_(strict), said_(said) {}

    std::optional<ObjText> read();

  private:
    using Use = bool (PlyReader::*)();

    bool check(const PlyHeader& header, Reporter& report);
    bool read_elements(const PlyElement& element);
    bool read_properties(const PlyElement& element);
    bool read_list(const PlyProperty& property, int place);
    Use choose_places(const PlyElement& element);
    void mention_unused(const PlyElement& element, const PlyProperty& property);
    void tell(const PlyHeader& header);

    bool vertex();
    void vertex_color();
    bool face();
    bool strips();
    bool ignored() { return true; }
    void add_corner(double index) { out_.corners.push_back({uint32_t(index), kAbsent, kAbsent}); }
    bool finish_face(size_t first);

    std::string_view text_;
    uint32_t file_;
    bool strict_;
    Diagnostics& said_;
    PlyValues* values_ = nullptr;
    ObjText out_;
    uint64_t vertex_count_ = 0;
    std::string unused_;                            ///< properties, separated by commas
    std::map<std::string_view, size_t> oddities_;   ///< what is said once, with its count

    // Of the element that is being read:
    std::vector<int> places_;                       ///< of each property: a Scalar, a List or kUnused
    std::array<bool, kScalars> has_{};
    std::array<double, kScalars> scalars_{};
    std::array<double, kScalars> units_{};          ///< the value that means 1; 0 in float colours, which are not encoded
    std::array<std::vector<double>, kLists> lists_;
    double least_index_ = 0;                        ///< -1 in strips, where it begins a new one
};

/// What can be said before anything is read: the counts are not believed.
bool PlyReader::check(const PlyHeader& header, Reporter& report) {
    for (const PlyElement& e : header.elements) {
        const size_t least = values_->least_bytes(e);
        if (least == 0) continue;   // nothing of it is in the file
        const uint64_t most = (values_->bytes_left() + 1) / least;
        if (e.count > most) return report.error(e.at, fmt::format("{} elements are promised: the file has bytes for {} at most", e.count, most)), false;
        if (e.name != "vertex") continue;
        vertex_count_ = e.count;
        if (e.count >= kAbsent) return report.error(e.at, "the file has too many vertices"), false;
        for (const char* name : {"x", "y", "z"})
            if (std::none_of(e.properties.begin(), e.properties.end(), [&](const PlyProperty& p) { return p.name == name && !p.count_type; }))
                return report.error(e.at, fmt::format("the vertices have no property {}", name)), false;
    }
    return true;
}

void PlyReader::mention_unused(const PlyElement& element, const PlyProperty& property) {
    constexpr size_t kLongest = 200;
    if (unused_.size() > kLongest) return;
    unused_ += fmt::format("{}{} {}", unused_.empty() ? "" : ", ", element.name.substr(0, kLongest), property.name.substr(0, kLongest));
}

/// Sets places_ and what goes with them; returns what makes something of an element.
PlyReader::Use PlyReader::choose_places(const PlyElement& element) {
    const bool is_vertex = element.name == "vertex", is_strip = element.name == "tristrips", is_face = element.name == "face" || is_strip;
    places_.assign(element.properties.size(), kUnused);
    has_ = {}, scalars_ = {}, units_ = {};
    for (size_t i = 0; i < places_.size(); ++i) {
        const PlyProperty& p = element.properties[i];
        const auto find = [&](std::span<const Meaning> meanings) {
            const auto known = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& m) { return m.name == p.name; });
            if (known != meanings.end()) places_[i] = known->place;
        };
        if (is_vertex && !p.count_type) find(kVertexProperties);
        if (is_face && p.count_type) find(kFaceLists);
        if (places_[i] == kUnused) mention_unused(element, p);
        else if (is_vertex) has_[size_t(places_[i])] = true, units_[size_t(places_[i])] = is_integer(p.type) ? largest(p.type) : 0;
    }
    least_index_ = is_strip ? -1 : 0;
    if (is_vertex) return &PlyReader::vertex;
    if (is_strip) return &PlyReader::strips;
    return is_face ? &PlyReader::face : &PlyReader::ignored;
}

bool PlyReader::read_list(const PlyProperty& property, int place) {
    size_t length = 0;
    if (!values_->read_length(property, length)) return false;
    double item = 0;
    for (size_t i = 0; i < length; ++i) {
        if (!values_->read(property.type, item)) return false;
        if (place != kUnused) lists_[size_t(place)].push_back(item);
        if (place == kIndices && !(item >= least_index_ && item < double(vertex_count_) && item == std::floor(item)))
            return values_->fail(fmt::format("index {} of a vertex: there are only {}, counted from 0", item, vertex_count_));
    }
    return true;
}

bool PlyReader::read_properties(const PlyElement& element) {
    for (auto& list : lists_) list.clear();
    if (!values_->begin_element()) return false;
    for (size_t i = 0; i < places_.size(); ++i) {
        const PlyProperty& p = element.properties[i];
        double value = 0;
        if (p.count_type) {
            if (!read_list(p, places_[i])) return false;
        } else if (!values_->read(p.type, value)) {
            return false;
        } else if (places_[i] != kUnused) {
            scalars_[size_t(places_[i])] = value;
            if (places_[i] <= kZ) out_.exceeds_float = out_.exceeds_float || values_->exceeds_float();
        }
    }
    if (!values_->end_element()) ++oddities_["a line has more values than its element: the rest is left out"];
    return true;
}

bool PlyReader::read_elements(const PlyElement& element) {
    if (element.properties.empty()) return true;
    const Use use = choose_places(element);
    for (uint64_t i = 0; i < element.count; ++i)
        if (!read_properties(element) || !(this->*use)()) return false;
    return true;
}

bool PlyReader::vertex() {
    out_.positions.emplace_back(scalars_[kX], scalars_[kY], scalars_[kZ]);
    if (has_[kNx] && has_[kNy] && has_[kNz] && !out_.add_normal({scalars_[kNx], scalars_[kNy], scalars_[kNz]}))
        ++oddities_["a normal is not finite: the polygon's own is taken"];
    if (has_[kU] && has_[kV] && !out_.add_uv(scalars_[kU], scalars_[kV])) ++oddities_["a texture coordinate is not finite: taken for 0 0"];
    if (has_[kRed] && has_[kGreen] && has_[kBlue]) vertex_color();
    return true;
}

void PlyReader::vertex_color() {
    Vec4f color(1);
    bool finite = true;
    for (int c = 0; c < 4; ++c) {
        const size_t place = size_t(kRed + c);
        if (!has_[place]) continue;
        const double value = units_[place] > 0 ? scalars_[place] / units_[place] : scalars_[place];
        color[c] = float(units_[place] > 0 && c < 3 ? srgb_to_linear(value) : value);
        finite = finite && std::isfinite(color[c]);
    }
    if (!finite) ++oddities_["a vertex colour is not finite: taken for white"];
    out_.colors.push_back(finite ? color : Vec4f(1));
}

bool PlyReader::finish_face(size_t first) { return add_face(out_, first, values_->line()) || values_->fail("the file has too many corners"); }

bool PlyReader::face() {
    const size_t first = out_.corners.size();
    for (const double index : lists_[kIndices]) add_corner(index);
    const std::vector<double>& uv = lists_[kTexcoords];
    if (!uv.empty() && uv.size() != 2 * lists_[kIndices].size()) ++oddities_["texcoord has not two numbers a corner: left out"];
    else
        for (size_t i = 0; i < uv.size(); i += 2) {
            out_.corners[first + i / 2].uv = uint32_t(out_.uvs.size());
            if (!out_.add_uv(uv[i], uv[i + 1])) ++oddities_["a texture coordinate is not finite: taken for 0 0"];
        }
    return finish_face(first);
}

/// Each index makes a triangle with the two before it, every other one turned round; -1 begins a new strip.
bool PlyReader::strips() {
    const std::vector<double>& list = lists_[kIndices];
    size_t run = 0;
    for (size_t i = 0; i < list.size(); ++i) {
        run = list[i] < 0 ? 0 : run + 1;
        if (run < 3) continue;
        const size_t turned = run % 2 == 0 ? 1 : 0, first = out_.corners.size();
        for (const double index : {list[i - 2 + turned], list[i - 1 - turned], list[i]}) add_corner(index);
        if (!finish_face(first)) return false;
    }
    return true;
}

void PlyReader::tell(const PlyHeader& header) {
    const SourcePos whole_file{file_, 0, 0, {}};
    for (const auto& [message, count] : oddities_) {
        const std::string counted = count > 1 ? fmt::format("{} ({} times)", message, count) : std::string(message);
        if (strict_) said_.error(whole_file, counted);
        else said_.warning(whole_file, counted);
    }
    if (!unused_.empty()) said_.note(whole_file, fmt::format("properties that are not used: {}", unused_));
    if (!values_->at_end())
        said_.note(whole_file, fmt::format("{} bytes behind the last of {} elements are left out", values_->bytes_left(), header.elements.size()));
}

/// Gives corners the attributes of their vertices, which may come after the faces.
void share_vertex_attributes(ObjText& out, bool has_normals, size_t vertex_uvs, size_t first_uv) {
    for (Corner& c : out.corners) {
        if (has_normals) c.normal = c.position;
        if (vertex_uvs && c.uv == kAbsent) c.uv = uint32_t(first_uv) + c.position;
    }
}

std::optional<ObjText> PlyReader::read() {
    TextCursor cursor(text_);
    Reporter report(said_, file_, cursor, strict_);
    const std::optional<PlyHeader> header = read_ply_header(cursor, report);
    if (!header) return std::nullopt;
    PlyValues values(text_, cursor, header->encoding, file_, said_);
    values_ = &values;
    if (!check(*header, report)) return std::nullopt;
    begin_only_object(out_, file_);
    size_t first_uv = 0, vertex_uvs = 0;
    for (const PlyElement& e : header->elements) {
        const size_t uvs = out_.uvs.size();
        if (!read_elements(e)) return std::nullopt;
        if (e.name == "vertex") first_uv = uvs, vertex_uvs = out_.uvs.size() - uvs;
    }
    share_vertex_attributes(out_, !out_.normals.empty(), vertex_uvs, first_uv);
    tell(*header);
    if (said_.has_errors()) return std::nullopt;
    return std::move(out_);
}

}  // namespace

std::optional<ObjText> read_ply(std::span<const std::byte> bytes, uint32_t file, bool strict, Diagnostics& said) {
    return PlyReader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file, strict, said).read();
}

}  // namespace mesh

ImportResult import_ply(const std::string& path, const ImportOptions& options) { return mesh::import_mesh_file(path, options, mesh::read_ply); }

bool looks_like_ply(std::span<const std::byte> head) {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return text.size() > 3 && text.starts_with("ply") && std::string_view("\r\n \t").find(text[3]) != std::string_view::npos;
}

}  // namespace alidade
