// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/merged_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace alidade::gltf_export {

namespace {

/// Of radians. Angles are written as degrees.
constexpr double kSameAngle = 1e-9;
/// Of the greatest light of a sum: POV-Ray's colours are floats, and that is less than what the shortest ramp of such a sum leaves of it.
constexpr double kSameLight = 1e-6;

/// A node's parent (kNoId: none), whether it is shown, where it stands and looks there.
using Place = std::tuple<uint32_t, bool, std::array<double, 6>>;

/// A cone that ends hard, of a power of the cosine that is a coefficient of a square.
bool may_be_part(const Light& light) {
    const auto* cone = std::get_if<ConeLight>(&light.kind);
    return cone && std::abs(cone->radius - cone->falloff) < kSameAngle && (cone->tightness == 0 || cone->tightness == 1 || cone->tightness == 2) && !light.parallel && !light.shadow_grid && !light.projected_through;
}

/// All but the cone, the intensity, and what the first part alone has.
bool alike(const Light& a, const Light& b) {
    const bool same_fade = a.fade.has_value() == b.fade.has_value() && (!a.fade || (a.fade->distance == b.fade->distance && a.fade->power == b.fade->power));
    return same_fade && a.range == b.range && a.inverse_square == b.inverse_square && a.shadowless == b.shadowless && a.media_interaction == b.media_interaction && a.clearance == b.clearance;
}

/// The lights that may be parts, together where they stand in the same places, all of them.
std::map<std::vector<Place>, std::vector<LightId>> parts_by_places(const Scene& scene) {
    std::map<LightId, std::vector<Place>> places;
    const auto stand = [&](NodeId id, uint32_t parent) {
        const Node& node = scene.nodes[id.index];
        const auto* light = std::get_if<LightId>(&node.what);
        if (!light || !may_be_part(scene.lights[light->index]) || !node.to_parent.is_finite()) return;
        const Vec3 at = node.to_parent.translation, axis = normalized(node.to_parent.linear[2]);
        places[*light].emplace_back(parent, node.flags.visible, std::array<double, 6>{at.x, at.y, at.z, axis.x, axis.y, axis.z});
    };
    for (const NodeId root : scene.roots) stand(root, kNoId);
    for (uint32_t i = 0; i < scene.nodes.size(); ++i)
        for (const NodeId child : scene.nodes[i].children) stand(child, i);
    std::map<std::vector<Place>, std::vector<LightId>> out;
    for (auto& [light, where] : places) {
        std::sort(where.begin(), where.end());
        out[where].push_back(light);
    }
    return out;
}

/// The lights of one place that are no part of a sum yet.
class Parts {
  public:
    Parts(const Scene& scene, std::vector<LightId> lights) : scene_(scene), left_(std::move(lights)) {}

    /// A spot, and the parts whose sum it is, the first of tightness 2.
    struct Sum {
        Light spot;
        std::vector<LightId> parts;
    };
    std::optional<Sum> take() {
        for (const LightId first : left_)
            if (auto sum = sum_from(first)) {
                std::erase_if(left_, [&](LightId id) { return std::find(sum->parts.begin(), sum->parts.end(), id) != sum->parts.end(); });
                return sum;
            }
        return std::nullopt;
    }

  private:
    const Light& light(LightId id) const { return scene_.lights[id.index]; }
    const ConeLight& cone(LightId id) const { return std::get<ConeLight>(light(id).kind); }

    /// A light like `first`, but of this tightness, angle and intensity.
    std::optional<LightId> find(LightId first, double tightness, double angle, const Color& intensity) const {
        const double tolerance = kSameLight * max_component(light(first).intensity);
        const auto fits = [&](LightId id) {
            return cone(id).tightness == tightness && std::abs(cone(id).falloff - angle) < kSameAngle && alike(light(first), light(id)) && max_abs(light(id).intensity - intensity) <= tolerance;
        };
        const auto found = std::find_if(left_.begin(), left_.end(), fits);
        return found != left_.end() ? std::optional(*found) : std::nullopt;
    }

    /// With the light a = I / ramp^2: a (c - outer)^2 from the outer angle on, and I - a (c - outer)^2 from the inner one, where there is any.
    std::optional<Sum> sum_from(LightId first) const {
        const Color a = light(first).intensity;
        if (cone(first).tightness != 2 || !is_finite(a) || std::min({a.x, a.y, a.z}) < 0 || is_black(a)) return std::nullopt;
        const double angle = cone(first).falloff, outer = std::cos(angle);
        const auto b = find(first, 1, angle, a * (-2 * outer)), c = find(first, 0, angle, a * (outer * outer));
        if (!b || !c) return std::nullopt;
        const auto sum_of = [&](double inner, std::vector<LightId> parts) {
            Sum sum{light(first), std::move(parts)};
            sum.spot.kind = SpotLight{inner, angle}, sum.spot.intensity = a * (std::cos(inner) - outer) * (std::cos(inner) - outer);
            return sum;
        };
        for (const LightId less : left_) {
            const double inner = cone(less).falloff, ramp = std::cos(inner) - outer;
            if (!(inner < angle) || find(first, 2, inner, -a) != less) continue;
            const auto less_b = find(first, 1, inner, a * (2 * outer)), rest = find(first, 0, inner, a * (ramp * ramp - outer * outer));
            if (less_b && rest) return sum_of(inner, {first, *b, *c, less, *less_b, *rest});
        }
        return sum_of(0, {first, *b, *c});
    }

    const Scene& scene_;
    std::vector<LightId> left_;
};

}  // namespace

std::map<LightId, std::optional<Light>> merged_cones(const Scene& scene) {
    std::map<LightId, std::optional<Light>> merged;
    for (const auto& [places, lights] : parts_by_places(scene)) {
        Parts parts(scene, lights);
        while (const auto sum = parts.take()) {
            for (const LightId id : sum->parts) merged[id] = std::nullopt;
            merged[sum->parts.front()] = sum->spot;
        }
    }
    return merged;
}

}  // namespace alidade::gltf_export
