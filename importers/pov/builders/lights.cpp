// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/lights.h"

#include "importers/pov/builders/objects.h"

#include <cmath>

namespace alidade::pov {

namespace {

constexpr double kDegree = kPi / 180;

struct LightWords {
    Vec3 location{0}, point_at{0, 0, 1};
    Light light;
    ConeLight cone;
    bool spot = false;
    LightFade fade;
    Transform transform;
    const Block* looks_like = nullptr;
};

bool take_cone_word(LightWords& w, Cursor& at) {
    if (at.accept("spotlight"_w)) w.spot = true;
    else if (at.accept("radius"_w)) w.cone.radius = at.number("the radius of a spotlight") * kDegree;
    else if (at.accept("falloff"_w)) w.cone.falloff = at.number("the falloff of a spotlight") * kDegree;
    else if (at.accept("tightness"_w)) w.cone.tightness = at.number("the tightness of a spotlight");
    else if (at.accept("point_at"_w)) w.point_at = at.vector("point_at");
    else if (at.accept("parallel"_w)) w.light.parallel = true;
    else return false;
    return true;
}

/// What belongs to an area light alone.
bool is_area_word(const Cursor& at) {
    return at.at_word("adaptive"_w) || at.at_word("jitter"_w) || at.at_word("circular"_w) || at.at_word("orient"_w) || at.at_word("area_illumination"_w);
}

bool take_light_word(LightWords& w, Cursor& at) {
    if (at.accept("shadowless"_w)) w.light.shadowless = true;
    else if (at.accept("fade_distance"_w)) w.fade.distance = at.number("the distance of fading");
    else if (at.accept("fade_power"_w)) w.fade.power = at.number("the power of fading");
    else if (at.accept("media_interaction"_w)) w.light.media_interaction = at.flag();
    else if (at.at_numeric()) w.light.intensity = at.rgb("the colour of a light");
    else return false;
    return true;
}

void read_light(Build& build, const Block& block, LightWords& w) {
    const Nested nested(build.p, block.place);
    Cursor at(build, block);
    if (const Block* base = at.block_at("light_source"_w)) at.next(), read_light(build, *base, w);
    else w.location = at.vector("the location of a light");
    while (!at.done()) {
        if (at.at_transform()) w.transform = at.transform() * w.transform;
        else if (const Block* like = at.block_at("looks_like"_w)) at.next(), w.looks_like = like;
        else if (take_cone_word(w, at) || take_light_word(w, at)) continue;
        else if (is_area_word(at) || at.at_word("media_attenuation"_w)) at.skip();
        else if (at.at_word("area_light"_w)) {
            build.p.tally(at.place(), "area_light is not modelled yet: its light is at the centre");
            at.skip();
        } else if (at.at_word("cylinder"_w)) {
            build.p.tally(at.place(), "a cylinder of light is not modelled yet: it is a point light");
            at.skip();
        } else at.skip_unmodelled();
    }
}

/// -z of the node points along `axis`.
Transform facing(const Vec3& location, const Vec3& axis) {
    Transform t = Transform::translate(location);
    if (!(length(axis) > 0)) return t;
    const Vec3 back = -normalized(axis);
    Vec3 right, up;
    orthonormal_basis(back, right, up);
    t.linear = Mat3(right, up, back);
    return t;
}

/// The object that shows where the light is: it throws no shadow, and stands around the light. It follows the light's transformations.
void add_looks(Build& build, const LightWords& w, Node& group) {
    for (Cursor at(build, *w.looks_like); !at.done();) {
        const Block* object = at.any_block();
        if (!object || !is_object(object->word)) {
            at.skip_unmodelled();
            continue;
        }
        at.next();
        const auto built = build_object(build, *object);
        if (!built) continue;
        Node moved;
        moved.to_parent = w.transform * Transform::translate(w.location);
        moved.flags.shadow = false;
        moved.children.push_back(built->node);
        group.children.push_back(build.add_node(std::move(moved)));
    }
}

}  // namespace

NodeId build_light(Build& build, const Block& block) {
    LightWords w;
    w.light.intensity = Color(0);
    read_light(build, block, w);
    if (w.spot) w.light.kind = w.cone;
    w.light.inverse_square = false;
    if (w.fade.power > 0 && std::abs(w.fade.distance) > 1e-10) w.light.fade = w.fade;
    w.light.from = build.position(block.place);
    build.scene.lights.push_back(w.light);
    Node node;
    node.what = LightId{uint32_t(build.scene.lights.size() - 1)};
    node.from = w.light.from;
    const Vec3 location = w.transform.point(w.location);
    node.to_parent = facing(location, w.transform.point(w.point_at) - location);
    const NodeId light = build.add_node(std::move(node));
    if (!w.looks_like) return light;
    Node group;
    group.children.push_back(light);
    add_looks(build, w, group);
    return build.add_node(std::move(group));
}

}  // namespace alidade::pov
