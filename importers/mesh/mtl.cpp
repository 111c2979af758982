// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/mtl.h"

#include "importers/mesh/reporter.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace alidade::mesh {
namespace {

/// Reads one library; a row of the tables for each statement.
class MtlReader {
  public:
    MtlReader(std::string_view text, uint32_t file, bool strict, Diagnostics& said) : cursor_(text), report_(said, file, cursor_, strict) {}

    std::vector<MtlMaterial> read();

  private:
    using Mark = TextCursor::Mark;
    template <class Member> struct Row {
        std::string_view word;
        Member member;
    };
    using ColorRow = Row<std::optional<Vec3> MtlMaterial::*>;
    using ScalarRow = Row<std::optional<double> MtlMaterial::*>;
    using MapRow = Row<std::optional<MtlMap> MtlMaterial::*>;

    void line();
    bool property(std::string_view word);
    void color(std::optional<Vec3>& out);
    void scalar(std::optional<double>& out);
    void illumination();
    void map(std::optional<MtlMap>& out);
    bool map_option(MtlMap& map, std::string_view option);
    void vector_option(Vec3& out);
    bool is_left_out(std::string_view word) const;
    std::optional<double> number();

    TextCursor cursor_;
    Reporter report_;
    std::vector<MtlMaterial> materials_;
    Mark statement_{};
};

std::vector<MtlMaterial> MtlReader::read() {
    for (; !cursor_.at_end() && report_.diagnostics().errors() < Diagnostics::kKept; cursor_.next_line())
        if (!cursor_.at_line_end()) line();
    report_.tell_tallies();
    return std::move(materials_);
}

void MtlReader::line() {
    statement_ = cursor_.mark();
    const std::string_view word = cursor_.word();
    if (word == "newmtl") {
        materials_.emplace_back();
        materials_.back().name = cursor_.rest_of_line();
        materials_.back().from = report_.place(statement_);
    } else if (materials_.empty()) {
        report_.tally(statement_, "a statement before the first newmtl: left out");
    } else if (!property(word)) {
        const char* why = is_left_out(word) ? "{} has no counterpart here: left out" : "unknown statement \"{}\"";
        report_.tally(statement_, fmt::format(fmt::runtime(why), cursor_.word_at(statement_)));
    }
}

bool MtlReader::property(std::string_view word) {
    static constexpr ColorRow colors[] = {{"Kd", &MtlMaterial::diffuse}, {"Ks", &MtlMaterial::specular}, {"Ke", &MtlMaterial::emission},
                                         {"Tf", &MtlMaterial::transmission_filter}};
    static constexpr ScalarRow scalars[] = {
        {"Ns", &MtlMaterial::exponent}, {"d", &MtlMaterial::opacity},    {"Ni", &MtlMaterial::ior},
        {"Pr", &MtlMaterial::roughness}, {"Pm", &MtlMaterial::metallic}, {"Pc", &MtlMaterial::clearcoat}, {"Pcr", &MtlMaterial::clearcoat_roughness}};
    static constexpr MapRow maps[] = {
        {"map_Kd", &MtlMaterial::diffuse_map},   {"map_Ke", &MtlMaterial::emission_map}, {"map_d", &MtlMaterial::opacity_map},
        {"map_Pr", &MtlMaterial::roughness_map}, {"map_Pm", &MtlMaterial::metallic_map}, {"norm", &MtlMaterial::normal_map},
        {"map_Bump", &MtlMaterial::bump_map},    {"map_bump", &MtlMaterial::bump_map},   {"bump", &MtlMaterial::bump_map}};
    MtlMaterial& material = materials_.back();
    for (const ColorRow& row : colors)
        if (row.word == word) return color(material.*row.member), true;
    for (const ScalarRow& row : scalars)
        if (row.word == word) return scalar(material.*row.member), true;
    for (const MapRow& row : maps)
        if (row.word == word) return map(material.*row.member), true;
    if (word == "illum") return illumination(), true;
    if (word == "Tr") {   // transparency; where a file has both, d has the last word
        std::optional<double> transparency;
        scalar(transparency);
        if (transparency && !material.opacity) material.opacity = 1 - *transparency;
        return true;
    }
    return word == "Ka" || word == "map_Ka";   // ambient light is what a ray tracer computes
}

/// Statements that are known, but that the surface model cannot express.
bool MtlReader::is_left_out(std::string_view word) const {
    static constexpr std::string_view words[] = {"Kt",    "Ps",   "aniso", "anisor", "sharpness", "map_Ks", "map_Ns", "map_Ps", "map_Tr",
                                                 "map_aat", "disp", "decal", "refl", "map_refl", "map_disp", "map_Disp", "map_opacity"};
    for (const std::string_view known : words)
        if (word == known) return true;
    return false;
}

std::optional<double> MtlReader::number() {
    cursor_.at_line_end();
    const Mark at = cursor_.mark();
    const std::optional<Number> n = cursor_.number();
    if (n && std::isfinite(n->value)) return n->value;
    report_.error(at, fmt::format("\"{}\" is not a finite number", cursor_.word_at(at)));
    return std::nullopt;
}

/// Three numbers; or one, which stands for all.
void MtlReader::color(std::optional<Vec3>& out) {
    const Mark at = (cursor_.at_line_end(), cursor_.mark());
    const std::string_view kind = cursor_.word();
    if (kind == "spectral" || kind == "xyz") return report_.tally(at, fmt::format("{} colours are not supported: left out", kind));
    cursor_.back_to(at);
    Vec3 value(0);
    for (int i = 0; i < 3; ++i) {
        if (i == 1 && cursor_.at_line_end()) {
            value = Vec3(value.x);
            break;
        }
        const std::optional<double> n = number();
        if (!n) return;
        value[i] = *n;
    }
    out = value;
}

void MtlReader::scalar(std::optional<double>& out) {
    const Mark at = (cursor_.at_line_end(), cursor_.mark());
    if (cursor_.word() == "-halo") report_.tally(at, "-halo is not supported: left out");
    else cursor_.back_to(at);
    if (const std::optional<double> n = number()) out = *n;
}

void MtlReader::illumination() {
    const Mark at = (cursor_.at_line_end(), cursor_.mark());
    const std::optional<int32_t> model = cursor_.integer();
    if (model && *model >= 0 && *model <= 10 && cursor_.at_word_end()) materials_.back().illumination = *model;
    else report_.error(at, fmt::format("\"{}\" is not an illumination model: they are 0 to 10", cursor_.word_at(at)));
}

/// One to three numbers.
void MtlReader::vector_option(Vec3& out) {
    if (const std::optional<double> first = number()) out.x = *first;
    for (int i = 1; i < 3; ++i) {
        cursor_.at_line_end();
        const Mark at = cursor_.mark();
        const std::optional<Number> n = cursor_.number();
        if (!n || !std::isfinite(n->value)) return cursor_.back_to(at);
        out[i] = n->value;
    }
}

/// False if there is no such option.
bool MtlReader::map_option(MtlMap& map, std::string_view option) {
    if (option == "-s") return vector_option(map.scale), true;
    if (option == "-o") return vector_option(map.offset), true;
    if (option == "-bm") {
        if (const std::optional<double> n = number()) map.bump = *n;
        return true;
    }
    if (option == "-clamp") return map.clamp = cursor_.word() == "on", true;
    if (option == "-imfchan") {
        const std::string_view channel = cursor_.word();
        map.channel = channel.empty() ? char(0) : channel[0];
        return true;
    }
    if (option == "-t") {
        Vec3 turbulence(0);
        vector_option(turbulence);
        if (turbulence != Vec3(0)) report_.tally(statement_, "-t (turbulence of a texture) is not supported: left out");
        return true;
    }
    if (option == "-mm") {
        const std::optional<double> base = number(), gain = base ? number() : std::nullopt;
        if (base && gain && (*base != 0 || *gain != 1)) report_.tally(statement_, "-mm (range of a texture) is not supported: left out");
        return true;
    }
    // Hints for filtering and size: one word each, of no meaning here.
    for (const char* hint : {"-blendu", "-blendv", "-boost", "-cc", "-texres", "-type", "-colorspace"})
        if (option == hint) return cursor_.word(), true;
    return false;
}

void MtlReader::map(std::optional<MtlMap>& out) {
    MtlMap map;
    map.from = report_.place(statement_);
    const size_t errors = report_.diagnostics().errors();
    for (;;) {
        const Mark at = (cursor_.at_line_end(), cursor_.mark());
        const std::string_view option = cursor_.word();
        if (option.starts_with('-') && map_option(map, option)) continue;
        cursor_.back_to(at);
        break;
    }
    map.file = cursor_.rest_of_line();
    if (report_.diagnostics().errors() > errors) return;
    if (map.file.empty()) report_.error(statement_, "the name of a picture is missing");
    else out = std::move(map);
}

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, uint32_t file, bool strict, Diagnostics& said) {
    return MtlReader(text, file, strict, said).read();
}

}  // namespace alidade::mesh
