// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/materials.h"

#include "tracer/render.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unordered_map>

namespace alidade {
namespace {

/// 1 + the number of the material that each pixel's middle shows; 0: none.
std::vector<uint32_t> materials_seen(const CompiledScene& scene, int width, int height) {
    RenderOptions options;
    options.width = width, options.height = height, options.spp = 1, options.integrator = "cast", options.aovs = {"material"};
    const auto film = render(scene, options);
    std::vector<uint32_t> out;
    if (!film) return out;
    const Picture& picture = film->picture;
    for (size_t i = size_t(picture.channels) - 1; i < picture.values.size(); i += size_t(picture.channels)) out.push_back(uint32_t(picture.values[i]));
    return out;
}

double luminance_at(const std::vector<float>& colors, size_t i) {
    const auto shown = [&](size_t c) { return std::clamp(double(colors[3 * i + c]), 0.0, 1.0); };
    return luminance(Color(shown(0), shown(1), shown(2)));
}

Json as_json(const ComparedMaterial& m) { return {{"pixels", m.pixels}, {"flip", m.flip}, {"brighter", m.brighter()}}; }

std::string as_line(const std::string& name, const ComparedMaterial& m) { return fmt::format("{}: {} pixels, mean FLIP {:.4f}, luminance {:+.2f} %", name, m.pixels, m.flip, 100 * m.brighter()); }

}  // namespace

void ComparedMaterial::add(double error, double of_reference, double of_test) { ++pixels, flip += error, reference += of_reference, test += of_test; }

void ComparedMaterial::finish() {
    if (pixels > 0) flip /= double(pixels), reference /= double(pixels), test /= double(pixels);
}

std::optional<ComparedMaterials> compare_materials(const CompiledScene& scene, const std::vector<WrittenMaterial>& written, const Comparison& comparison, int width, int height) {
    const auto flip = comparison.measured.find("flip");
    if (written.empty() || !comparison.loaded || flip == comparison.measured.end()) return std::nullopt;
    const PicturePair& pair = comparison.loaded->pair;
    const std::vector<uint32_t> seen = materials_seen(scene, width, height);
    if (seen.size() != pair.pixels()) return std::nullopt;
    ComparedMaterials out;
    for (const WrittenMaterial& material : written) out.each.push_back({material});
    std::unordered_map<uint32_t, size_t> row_of;
    for (size_t i = 0; i < written.size(); ++i) row_of[written[i].material.index + 1] = i;
    const std::vector<float> colors[] = {linear_colors(pair, pair.reference), linear_colors(pair, pair.test)};
    for (size_t i = 0; i < seen.size(); ++i) {
        const auto known = row_of.find(seen[i]);
        if (!pair.counts[i] || known == row_of.end()) continue;
        ComparedMaterial& row = out.each[known->second];
        const double error = double(flip->second.map[i]), of[] = {luminance_at(colors[0], i), luminance_at(colors[1], i)};
        row.add(error, of[0], of[1]);
        if (row.material.losses.empty()) out.expressed.add(error, of[0], of[1]);
    }
    std::erase_if(out.each, [](const ComparedMaterial& m) { return m.pixels == 0; });
    for (ComparedMaterial& m : out.each) m.finish();
    out.expressed.finish();
    return out;
}

void put_into(Json& document, const ComparedMaterials& materials) {
    document["expressed"] = as_json(materials.expressed);
    Json& rows = document["materials"] = Json::array();
    for (const ComparedMaterial& m : materials.each) {
        Json row = as_json(m), lost = Json::array();
        for (const Loss& loss : m.material.losses) lost.push_back(loss.what);
        row["name"] = m.material.material.name, row["lost"] = lost;
        rows.push_back(row);
    }
}

std::string as_lines(const ComparedMaterials& materials) {
    std::string out;
    for (const ComparedMaterial& m : materials.each) {
        out += as_line(fmt::format("material '{}'", m.material.material.name), m);
        for (size_t i = 0; i < m.material.losses.size(); ++i) out += (i == 0 ? "; lost: " : ", ") + m.material.losses[i].what;
        out += '\n';
    }
    return out + as_line("all materials that lose nothing", materials.expressed) + '\n';
}

}  // namespace alidade
