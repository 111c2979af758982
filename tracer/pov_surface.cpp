// SPDX-License-Identifier: Apache-2.0
#include "tracer/pov_surface.h"

#include "core/random.h"
#include "eval/noise/noise.h"
#include "tracer/segment.h"
#include "tracer/textures.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace alidade {
namespace {

/// Products nearer to 0 than this count as none: where POV-Ray looks at a light, or at a change of direction.
constexpr double kEpsilon = 1e-10;

double opacity(const RenderSettings& settings, const PovFinish& f, const PigmentColor& c) {
    return 1 - c.filter * (settings.filter_dims_by_colour && !f.uncolored ? max_component(c.color) : 1) - c.transmit;
}

/// Whatever its pigment is: mirrors and highlights lie on clear surfaces, too.
bool shines(const PovFinish& f) { return f.specular != 0 || f.phong != 0 || f.crand != 0 || !is_black(f.reflection_min) || !is_black(f.reflection_max); }

Color filter_of(const PovFinish& f, const PigmentColor& c) { return f.uncolored ? Color(c.filter + c.transmit) : c.color * c.filter + Color(c.transmit); }

/// How a metal's highlight or reflection takes the colour of the surface: less and less towards grazing angles. `cosine` is of the angle from the normal.
Color metallic(const Color& c, double amount, double cosine) {
    if (amount == 0) return Color(1);
    const double x = std::abs(std::acos(std::clamp(cosine, -1.0, 1.0))) / (kPi / 2);
    const double f = std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
    return Color(1) + (c - Color(1)) * (amount * (1 - f));
}

/// The reflectivity of a layer at an angle; `relative_ior` is that of what lies behind the surface over that in front.
Color reflectivity(const PovLayer& layer, double cosine, double relative_ior) {
    const PovFinish& f = *layer.finish;
    double toward_max = 0;
    if (f.reflection_fresnel) {
        const double g2 = relative_ior * relative_ior + cosine * cosine - 1;
        if (g2 > 0) {
            const double g = std::sqrt(g2), a = (g - cosine) / (g + cosine), b = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
            toward_max = std::clamp(0.5 * a * a * (1 + b * b), 0.0, 1.0);
        } else {
            toward_max = 1;
        }
    } else if (f.reflection_min != f.reflection_max) {
        toward_max = std::pow(1 - std::min(cosine, 1.0), f.reflection_falloff);   // beyond max where a bent normal turns away
    }
    return (f.reflection_max * toward_max + f.reflection_min * (1 - toward_max)) * metallic(layer.color, f.reflection_metallic, cosine);
}

bool is_mirror(const PovFinish& f) { return f.reflection_fresnel || !is_black(f.reflection_max) || !is_black(f.reflection_min); }

/// Is what passes bright enough to be followed?
bool passes(const Color& through, const RenderSettings& settings) { return std::min(1.0, std::abs(pov_grey(through))) > settings.adc_bailout; }

/// The index of refraction behind the surface over that in front, as POV-Ray's mirrors have it (probed): a ray that leaves a solid, whatever side it hits,
/// comes to what it has entered last, be that the solid itself, if it is in others, too.
double mirror_ior(const CompiledScene& scene, const ShadePoint& point, const InteriorStack& inside) {
    const uint32_t interior = slot_at(scene, point).interior, carrier = scene.instances[point.instance].carrier;
    if (interior == kNoId) return 1;
    const auto entries = inside.entries();
    const double own = scene.interiors[interior].ior, here = ior_in(scene, inside);
    for (const InteriorStack::Entry& e : entries)
        if (e.carrier == carrier) return (entries.size() > 1 ? here : 1) / own;
    return own / here;
}

/// Does one ray serve both?
bool reflect_alike(const PovLayer& a, const PovLayer& b) { return a.normal == b.normal && a.finish->reflection_exponent == b.finish->reflection_exponent; }

}  // namespace

struct PovSurface::Passage {
    InteriorStack beyond;
    double ratio = 1;          ///< index of refraction here over that beyond
    Color faded{1};            ///< what is left of light on the way inside of the object that is left
    double refraction = 1;     ///< of the light that passes
};

/// A solid is left by a ray that has entered it, whatever side is hit.
PovSurface::Passage PovSurface::passage(const CompiledScene& scene, const ShadePoint& point, const RayState& state) const {
    const uint32_t interior = slot_at(scene, point).interior, carrier = scene.instances[point.instance].carrier;
    Passage out;
    out.beyond = state.inside;
    if (interior == kNoId) return out;
    const double own = scene.interiors[interior].ior, here = ior_in(scene, state.inside);
    out.refraction = scene.interiors[interior].refraction;
    const bool last = !state.inside.empty() && state.inside.top().carrier == carrier;
    if (out.beyond.leave(carrier)) {
        out.ratio = last ? own / ior_in(scene, out.beyond) : 1;
        out.faded = pov_fade(scene.interiors[interior], state.travelled);
    } else {
        out.beyond.enter({carrier, interior});
        out.ratio = here / own;
    }
    return out;
}

PovSurface::PovSurface(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const Vec3& normal, const InteriorStack& inside)
    : dir_(dir), normal_(normal), position_(point.position), mirror_ior_(mirror_ior(scene, point, inside)), irid_wavelength_(scene.scene.settings.irid_wavelength), noise_(scene.scene.settings.noise) {
    double_illuminate_ = scene.instances[point.instance].double_illuminate;
    if (const PlainPovSurface* plain = plain_at(scene, point)) {
        take(*plain);
        return;
    }
    for_each_mixed_slot(scene, point, [&](const ShadePoint& own, double share) {
        PatternFrame frame = pattern_frame(own);
        add(scene, own, material_at(scene, own), share, frame);
    });
    bool bent_to_none = false;
    for (const PovLayer& l : layers_) bent_to_none |= std::isnan(l.normal.x);
    if (bent_to_none) become_black();
}

/// Where the normal of any layer is no number, POV-Ray's colour is none, either, nor that of all that shows it, which its pictures have as black (probed).
void PovSurface::become_black() {
    static const PovFinish kBlack;
    layers_ = {}, textures_ = {}, plain_ = nullptr;
    layers_.push_back({&kBlack, Color(std::numeric_limits<double>::quiet_NaN()), 1, Color(1), normal_});
    textures_.push_back({1, 0, 1, Color(0)});
    sends_on_ = false;
}

void PovSurface::add(const CompiledScene& scene, const ShadePoint& point, const Material& material, double share, PatternFrame& frame) {
    const auto* map = std::get_if<PovTextureMap>(&material.layers.front());
    if (!map) return add_layers(scene, point, material, share, frame);
    scene.textures->for_each_share(map->pattern, frame, [&](uint32_t entry, double part) { add(scene, point, scene.scene.materials[map->textures[entry].index], share * part, frame); });
}

void PovSurface::add_layers(const CompiledScene& scene, const ShadePoint& point, const Material& material, double share, const PatternFrame& frame) {
    const RenderSettings& settings = scene.scene.settings;
    PovTexture texture;
    texture.share = share;
    texture.begin = layers_.size();
    for (size_t i = material.layers.size(); i-- > 0;) {
        PovLayer layer;
        layer.finish = &std::get<PovFinish>(material.layers[i]);
        const PigmentColor pigment = scene.textures->pigment(layer.finish->pigment, point, frame.at);
        layer.color = pigment.color;
        layer.opacity = opacity(settings, *layer.finish, pigment);
        layer.above = texture.through;
        layer.normal = layer.finish->normal ? scene.textures->bent(*layer.finish->normal, frame, normal_) : normal_;
        texture.through *= filter_of(*layer.finish, pigment);
        if (layer.finish->conserve_energy && !pigment.ended) {   // as POV-Ray has it
            const Color left = Color(1) - reflectivity(layer, -dot(dir_, layer.normal), mirror_ior_);
            texture.through *= glm::min(left, Color(1));
        }
        layers_.push_back(layer);
        sends_on_ = sends_on_ || (settings.follows_mirrors && is_mirror(*layer.finish));
        if (!passes(texture.through, settings)) break;
    }
    if (settings.see_through == SeeThrough::opaque) {
        for (size_t i = texture.begin; i < layers_.size(); ++i) layers_[i].opacity = 0;
        layers_[layers_.size() - 1].opacity = 1, layers_[layers_.size() - 1].above = Color(1);
    }
    if (settings.see_through != SeeThrough::all) texture.through = Color(0);
    sends_on_ = sends_on_ || passes(texture.through, settings);
    texture.end = layers_.size();
    textures_.push_back(texture);
}

Color PovSurface::albedo() const {
    Color sum(0);
    for (const PovTexture& t : textures_) {
        if (t.begin == t.end) continue;
        Color seen(0), covered(0);
        for (size_t i = t.begin; i < t.end; ++i) {
            const Color part = layers_[i].above * layers_[i].opacity;
            seen += part * layers_[i].color, covered += part;
        }
        for (int c = 0; c < 3; ++c) sum[c] += t.share * (covered[c] > 0 ? seen[c] / covered[c] : layers_[t.begin].color[c]);
    }
    return std::isnan(sum.x) ? Color(0) : sum;
}

bool PovSurface::is_hole() const {
    if (plain_) return plain_->hole;
    return !textures_.empty() && std::all_of(textures_.begin(), textures_.end(), [&](const PovTexture& t) {
        const auto begin = layers_.begin() + std::ptrdiff_t(t.begin), end = layers_.begin() + std::ptrdiff_t(t.end);
        const bool clear = t.through == Color(1) && std::all_of(begin, end, [](const PovLayer& l) { return l.opacity == 0 && !shines(*l.finish); });
        return t.share == 0 || clear;
    });
}

Color PovSurface::emitted(const Color& ambient_light) const {
    if (plain_) return plain_->emitted;
    Color sum(0);
    for (const PovTexture& t : textures_)
        for (size_t i = t.begin; i < t.end; ++i) {
            const PovLayer& l = layers_[i];
            sum += l.above * l.color * (l.finish->ambient * ambient_light + l.finish->emission) * (l.opacity * t.share);
        }
    return sum;
}

/// In [0, 1): of this point and this light alone, so that crand has the same grains whatever is rendered before.
double PovSurface::grain(const Vec3& wi) const {
    RandomKey key(std::bit_cast<uint64_t>(position_.x), std::bit_cast<uint64_t>(position_.y), std::bit_cast<uint64_t>(position_.z));
    for (int i = 0; i < 3; ++i) key = key.child(std::bit_cast<uint64_t>(wi[i]));
    return key.uniform(0);
}

/// What interference in a thin film makes of light that arrives and leaves at the cosines `nl` and `nd` to the normal.
/// Source   POV-Ray 3.7 reference, 3.4.3.3.7 "Iridescence"; verified by probing.
Color PovSurface::film(const PovFinish& f, double nl, double nd) const {
    double thickness = f.irid_thickness;
    if (f.irid_turbulence != 0) {
        Turbulence t;
        t.octaves = 5;
        thickness *= 1 + f.irid_turbulence * (2 * turbulence(position_, t, noise_) - 1);
    }
    const Color phase = (2 * kPi * thickness * (std::abs(nl) + std::abs(nd))) / irid_wavelength_;
    return Color(1) + f.irid * Color(std::cos(phase.x), std::cos(phase.y), std::cos(phase.z));
}

/// The same of what a mirror brings, ahead of the exponent of the reflection: as a factor of what comes out of that.
Color PovSurface::mirroring_film(const PovFinish& f, double nr, double nd) const {
    const Color factor = film(f, nr, nd);
    return f.reflection_exponent == 1 ? factor : glm::pow(glm::max(factor, Color(0)), Color(1 / f.reflection_exponent));
}

Color PovSurface::lit(const PovLayer& layer, const Vec3& wi, double nl, bool highlights) const {
    const PovFinish& f = *layer.finish;
    const bool back = nl < kEpsilon && !double_illuminate_;
    const double diffuse = back ? f.diffuse_back : f.diffuse;
    Color sum(0);
    if (diffuse > 0) {              // negative numbers count as none, also below
        double intensity = (f.brilliance == 1 ? std::abs(nl) : std::pow(std::abs(nl), f.brilliance)) * diffuse * layer.opacity;
        if (f.crand > 0) intensity -= f.crand * grain(wi);
        sum = layer.color * intensity;
    }
    if (back || !highlights) return sum;
    double highlight = 0;
    if (f.phong > 0) {
        const double k = dot(dir_ - layer.normal * (2 * dot(dir_, layer.normal)), wi);
        if (k > 0 && (f.phong_size < 60 || k > 0.0008)) highlight += f.phong * std::pow(k, f.phong_size);
    }
    if (f.specular > 0) {
        const Vec3 h = wi - dir_;
        const double size = length(h), k = size > 0 ? dot(h, layer.normal) / size : 0;
        if (k > 0) highlight += f.specular * std::pow(k, 1 / f.roughness);
    }
    if (highlight == 0) return sum;
    return f.metallic == 0 ? sum + Color(highlight) : sum + metallic(layer.color, f.metallic, nl) * highlight;
}

bool PovSurface::faces_away(const Vec3& way) const {
    if (double_illuminate_) return false;
    for (const PovLayer& l : layers_)
        if (!(dot(l.normal, way) <= 0) || l.finish->diffuse_back != 0) return false;
    return true;
}

Color PovSurface::scatter(const Vec3& wi, bool highlights) const {
    Color sum(0);
    for (const PovTexture& t : textures_)
        for (size_t i = t.begin; i < t.end; ++i) {
            const PovLayer& l = layers_[i];
            const double nl = dot(l.normal, wi);
            if (nl < kEpsilon && !double_illuminate_ && l.finish->diffuse_back == 0) continue;
            const Color own = lit(l, wi, nl, highlights) * t.share;
            sum += l.above * (l.finish->irid != 0 ? own * film(*l.finish, nl, dot(l.normal, dir_)) : own);
        }
    return sum;
}

/// The unit direction of a mirrored ray. Where the bent normal would send it below the surface, the surface itself mirrors it, or what it was mirrored to.
Vec3 PovSurface::mirrored(const Vec3& normal, const Vec3& facing) const {
    Vec3 r = dir_ - normal * (2 * dot(dir_, normal));
    if (const double below = dot(r, facing); below < 0) r = dot(r, normal) < 0 ? dir_ - facing * (2 * dot(dir_, facing)) : r - facing * (2 * below);
    return normalized(r);
}

/// One ray for all layers of a texture that have the normal and the exponent of the layer `first`. A layer's share is not dimmed by those above it, but whether it is followed depends on them.
void PovSurface::add_reflection(const CompiledScene& scene, const PovTexture& texture, size_t first, const RayState& state, const Vec3& facing, Secondaries& out) const {
    const Vec3 &normal = layers_[first].normal, out_dir = mirrored(normal, facing);
    const double cosine = -dot(dir_, normal);
    Color weight(0);
    double importance = 0;
    for (size_t i = first; i < texture.end; ++i) {
        const PovLayer& l = layers_[i];
        if (!is_mirror(*l.finish) || !reflect_alike(l, layers_[first])) continue;
        const Color plain = reflectivity(l, cosine, mirror_ior_), r = l.finish->irid != 0 ? plain * mirroring_film(*l.finish, dot(out_dir, normal), cosine) : plain;
        const Color most = l.finish->reflection_fresnel ? plain : glm::max(l.finish->reflection_max, l.finish->reflection_min);
        const double own = std::min(1.0, std::abs(pov_grey(l.above))) * max_component(most);
        if (is_black(r) || state.importance * own < scene.scene.settings.adc_bailout) continue;
        weight += r;
        importance = std::max(importance, own);
    }
    if (is_black(weight)) return;
    out.push_back({out_dir, weight * texture.share, RayKind::reflection, state.inside, importance, false, 1, 1 / layers_[first].finish->reflection_exponent});
}

/// `totally`: the normal by which light is mirrored already, whatever the layers say; null: none.
void PovSurface::add_reflections(const CompiledScene& scene, const PovTexture& texture, const RayState& state, const Vec3* totally, const Vec3& facing, Secondaries& out) const {
    if (!scene.scene.settings.follows_mirrors) return;
    for (size_t i = texture.begin; i < texture.end; ++i) {
        const Vec3& normal = layers_[i].normal;
        const auto begin = layers_.begin() + std::ptrdiff_t(texture.begin), here = layers_.begin() + std::ptrdiff_t(i);
        const bool seen = std::any_of(begin, here, [&](const PovLayer& l) { return reflect_alike(l, layers_[i]); });
        if (!seen && !(totally && *totally == normal)) add_reflection(scene, texture, i, state, facing, out);
    }
}

void PovSurface::add_texture(const CompiledScene& scene, const PovTexture& texture, const Passage& p, const RayState& state, const Vec3& facing, Secondaries& out) const {
    const Vec3& normal = layers_[texture.begin].normal;
    const Color& through = texture.through;
    bool total = false;
    if (passes(through, scene.scene.settings)) {
        const double c = -dot(dir_, normal), t = 1 + p.ratio * p.ratio * (c * c - 1);
        const Color weight = p.faded * through * (texture.share * p.refraction);
        const double importance = std::max({std::abs(through.x), std::abs(through.y), std::abs(through.z)});
        const double shows = std::min(1.0, std::abs(pov_grey(through))) * pov_grey(p.faded) * texture.share * p.refraction;
        if (std::abs(p.ratio - 1) < kEpsilon) {
            out.push_back({dir_, weight, RayKind::refraction, p.beyond, importance, true, shows});
        } else if (t < 0) {
            total = true;
            const Vec3 back = mirrored(normal, facing);
            const PovFinish& film = *layers_[texture.begin].finish;
            const Color colored = film.irid != 0 ? mirroring_film(film, dot(back, normal), c) : Color(1);
            out.push_back({back, p.faded * colored * (texture.share * p.refraction), RayKind::reflection, state.inside, importance, false});   // `refraction` counts here, too (by experiment)
        } else {
            const double root = c < 0 ? -std::sqrt(t) : std::sqrt(t);   // a bent normal may face away: what passes is bent by its other side
            out.push_back({normalized(dir_ * p.ratio + normal * (p.ratio * c - root)), weight, RayKind::refraction, p.beyond, importance, false, shows});
        }
    }
    add_reflections(scene, texture, state, total ? &normal : nullptr, facing, out);
}

void PovSurface::secondary(const CompiledScene& scene, const ShadePoint& point, const RayState& state, const Vec3& facing, Secondaries& out) const {
    const Passage p = passage(scene, point, state);
    for (const PovTexture& texture : textures_) add_texture(scene, texture, p, state, facing, out);
}

namespace {

/// How much brighter a shadow is than its filters make it, where the surface lies across the light (manual, 3.4.7.1.4 "Faked Caustics"). A stand-in for refracted light.
double caustics(const CompiledScene& scene, const PovFinish& finish, const ShadePoint& point, const PatternFrame& frame, const Vec3& dir) {
    const uint32_t interior = slot_at(scene, point).interior;
    const double power = interior == kNoId ? 0 : scene.interiors[interior].caustics;
    if (power == 0) return 1;
    const Vec3 facing = point.shading_normal * (dot(point.shading_normal, dir) < 0 ? 1.0 : -1.0);
    const Vec3 normal = finish.normal ? scene.textures->bent(*finish.normal, frame, facing) : facing;
    if (std::isnan(normal.x)) return 1;
    return 1 + std::pow(std::abs(dot(normal, dir)), 45 * power);
}

}  // namespace

Color pov_transmitted(const CompiledScene& scene, const Material& material, const ShadePoint& point, PatternFrame& frame, const Vec3& dir) {
    if (const auto* map = std::get_if<PovTextureMap>(&material.layers.front())) {
        Color sum(0);
        scene.textures->for_each_share(map->pattern, frame, [&](uint32_t entry, double share) {
            sum += pov_transmitted(scene, scene.scene.materials[map->textures[entry].index], point, frame, dir) * share;
        });
        return sum;
    }
    Color through(1);
    for (const auto& layer : material.layers) {
        const PovFinish& finish = std::get<PovFinish>(layer);
        through *= filter_of(finish, scene.textures->pigment(finish.pigment, point, frame.at));
        if (is_black(through)) return through;
        through *= caustics(scene, finish, point, frame, dir);
    }
    return through;
}

std::optional<Color> uniform_filter(const CompiledScene& scene, const SlotMaterial& slot) {
    if (slot.interior != kNoId && (scene.interiors[slot.interior].caustics != 0 || std::isfinite(scene.interiors[slot.interior].attenuation_distance))) return std::nullopt;
    Color through(1);
    for (const auto& layer : scene.scene.materials[slot.material].layers) {
        const auto* finish = std::get_if<PovFinish>(&layer);
        if (!finish || !std::holds_alternative<ConstantSignal>(scene.scene.signals[finish->pigment.index].what)) return std::nullopt;
        through *= filter_of(*finish, scene.textures->pigment(finish->pigment, Vec3(0)));
        if (is_black(through)) break;
    }
    return through;
}

}  // namespace alidade
