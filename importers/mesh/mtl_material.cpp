// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/mtl_material.h"

#include "core/image_colors.h"
#include "importers/local_path.h"

#include <fmt/format.h>

#include <filesystem>

namespace alidade::mesh {
namespace {

bool is_mirror(const MtlMaterial& m) { return m.illumination >= 3 && m.illumination <= 7; }   // "ray trace on"; false if there is none
bool is_refracting(const MtlMaterial& m) { return m.illumination == 6 || m.illumination == 7; }
bool has_highlight(const MtlMaterial& m) { return m.illumination.value_or(2) >= 2 && !(m.specular && is_black(*m.specular)); }
bool is_metal_mirror(const MtlMaterial& m) { return is_mirror(m) && !is_refracting(m) && has_highlight(m) && m.specular && m.diffuse && is_black(*m.diffuse); }
double opacity(const MtlMaterial& m) { return std::clamp(m.opacity.value_or(1), 0.0, 1.0); }

double ior(const MtlMaterial& m) { return m.ior && *m.ior > 1 ? *m.ior : 1.5; }

/// The reflectance head-on of an interface with this index of refraction.
double normal_reflectance(double ior) { return (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)); }

/// (u, v) -> scale (u, v) + offset, in a frame whose v grows downwards.
Mat3 uv_transform(const MtlMap& map) {
    Mat3 m(1.0);
    m[0][0] = map.scale.x, m[1][1] = map.scale.y;
    m[2][0] = map.offset.x, m[2][1] = 1 - map.scale.y - map.offset.y;
    return m;
}

int channel_index(const MtlMap& map) {
    switch (map.channel) {
        case 'g': return 1;
        case 'b': return 2;
        case 'm': return 3;
        default: return 0;
    }
}

}  // namespace

SignalId MaterialBuilder::add(Signal signal) {
    scene_.signals.push_back(std::move(signal));
    return {uint32_t(scene_.signals.size() - 1)};
}

SignalId MaterialBuilder::constant(const Vec4& value, const SourcePos& from) { return add({ConstantSignal{value}, from}); }

std::optional<std::string> MaterialBuilder::picture_path(const MtlMap& map) {
    const auto path = local_path(folder_, map.file);
    if (!path) {
        said_.warning(map.from, fmt::format("the picture \"{}\" is not read: {}", map.file, path.error()), "put pictures beside the material library");
        return std::nullopt;
    }
    std::error_code error;
    if (std::filesystem::is_regular_file(*path, error)) return *path;
    said_.warning(map.from, fmt::format("there is no picture \"{}\": left out", map.file));
    return std::nullopt;
}

SignalId MaterialBuilder::image(const MtlMap& map, const std::string& path, bool is_color) {
    const auto [known, added] = images_.try_emplace(path, ImageId{uint32_t(scene_.images.size())});
    if (added) scene_.images.push_back({map.file, path, {}, map.from});
    ImageSignal signal;
    signal.image = known->second;
    signal.srgb = is_color;
    signal.uv_transform = uv_transform(map);
    if (map.clamp) signal.wrap_u = signal.wrap_v = Wrap::clamp;
    return add({signal, map.from});
}

std::optional<SignalId> MaterialBuilder::scaled(const std::optional<MtlMap>& map, const std::optional<Vec4>& factor, bool is_color, const SourcePos& from) {
    std::optional<SignalId> picture;
    if (map)
        if (const std::optional<std::string> path = picture_path(*map)) picture = image(*map, *path, is_color);
    if (picture && !is_color) picture = add({ChannelSignal{*picture, channel_index(*map)}, map->from});
    if (!picture && !factor) return std::nullopt;
    if (!picture) return constant(*factor, from);
    if (!factor || *factor == Vec4(1)) return picture;
    return add({ProductSignal{*picture, constant(*factor, from)}, from});
}

void MaterialBuilder::set_base_color(GltfPbr& pbr, const MtlMaterial& mtl) {
    Vec3 color = mtl.diffuse.value_or(mtl.diffuse_map ? Vec3(1) : Vec3(0.8));
    if (is_refracting(mtl)) color = mtl.transmission_filter.value_or(Vec3(1));
    if (is_metal_mirror(mtl)) color = *mtl.specular;
    const double alpha = is_refracting(mtl) ? 1 : opacity(mtl);
    pbr.base_color = *scaled(mtl.diffuse_map, Vec4(color, alpha), true, mtl.from);
    if (alpha < 1) pbr.alpha_mode = AlphaMode::blend;
    if (!mtl.opacity_map) return;
    if (mtl.diffuse_map && mtl.diffuse_map->file == mtl.opacity_map->file) pbr.alpha_mode = AlphaMode::blend;
    else said_.warning(mtl.opacity_map->from, "a map_d that is not the alpha of map_Kd is not supported: left out", "put the opacity into the alpha of map_Kd");
}

void MaterialBuilder::set_highlight(GltfPbr& pbr, const MtlMaterial& mtl) {
    const auto factor = [](const std::optional<double>& value) { return value ? std::optional(Vec4(*value)) : std::nullopt; };
    std::optional<double> roughness = mtl.roughness;
    if (!roughness && !mtl.roughness_map && mtl.exponent) roughness = std::sqrt(std::sqrt(2 / (std::max(*mtl.exponent, 0.0) + 2)));
    pbr.roughness = scaled(mtl.roughness_map, factor(roughness), false, mtl.from);
    pbr.metallic = scaled(mtl.metallic_map, factor(mtl.metallic), false, mtl.from);
    if (!pbr.metallic) pbr.metallic = scalar(is_metal_mirror(mtl) ? 1 : 0, mtl.from);

    pbr.ior = ior(mtl);
    if (!has_highlight(mtl)) pbr.specular = scalar(0, mtl.from);
    else if (is_mirror(mtl) && mtl.specular && !is_metal_mirror(mtl))
        pbr.specular_color = constant(Vec4(*mtl.specular / normal_reflectance(pbr.ior), 1), mtl.from);
    if (is_refracting(mtl)) pbr.transmission = scalar(opacity(mtl) < 1 ? 1 - opacity(mtl) : 1, mtl.from);
    if (mtl.clearcoat) pbr.clearcoat = scalar(*mtl.clearcoat, mtl.from);
    if (mtl.clearcoat_roughness) pbr.clearcoat_roughness = scalar(*mtl.clearcoat_roughness, mtl.from);
}

/// Most directions of a normal map are near (0, 0, 1), which is stored as (0.5, 0.5, 1); a height map is gray.
bool MaterialBuilder::is_normal_map(const MtlMap& map, const std::string& path) {
    const auto picture = read_picture(path, Encoding::linear).and_then(colors_alone);
    if (!picture) {
        said_.warning(map.from, fmt::format("the normal map \"{}\" is left out: {}", map.file, picture.error()));
        return false;
    }
    Vec3 sum(0);
    const size_t pixels = size_t(picture->width) * size_t(picture->height);
    for (size_t p = 0; p < pixels && picture->channels >= 3; ++p)
        for (int c = 0; c < 3; ++c) sum[c] += picture->values[p * size_t(picture->channels) + size_t(c)];
    const Vec3 mean = sum / double(pixels);
    if (std::abs(mean.x - 0.5) < 0.2 && std::abs(mean.y - 0.5) < 0.2 && mean.z > 0.7) return true;
    said_.warning(map.from, fmt::format("\"{}\" is no normal map, and height maps are not supported: left out", map.file));
    return false;
}

void MaterialBuilder::set_normal(GltfPbr& pbr, const MtlMaterial& mtl) {
    const std::optional<MtlMap>& map = mtl.normal_map ? mtl.normal_map : mtl.bump_map;
    if (!map) return;
    const std::optional<std::string> path = picture_path(*map);
    if (!path || (!mtl.normal_map && !is_normal_map(*map, *path))) return;
    pbr.normal = image(*map, *path, false);
    pbr.normal_scale = map->bump;
}

MaterialId MaterialBuilder::add(const MtlMaterial& mtl, const std::string& folder) {
    folder_ = folder;
    GltfPbr pbr;
    pbr.double_sided = true;
    set_base_color(pbr, mtl);
    set_highlight(pbr, mtl);
    set_normal(pbr, mtl);
    const bool glows = mtl.emission_map || (mtl.emission && !is_black(*mtl.emission));
    if (glows) pbr.emissive = scaled(mtl.emission_map, mtl.emission ? std::optional(Vec4(*mtl.emission, 1)) : std::nullopt, true, mtl.from);
    Material material;
    material.name = mtl.name;
    material.layers.push_back(pbr);
    material.from = mtl.from;
    scene_.materials.push_back(std::move(material));
    return {uint32_t(scene_.materials.size() - 1)};
}

}  // namespace alidade::mesh
