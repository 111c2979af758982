// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/lights.h"

#include "importers/pov/builders/objects.h"

#include <cmath>

namespace alidade::pov {

namespace {

constexpr double kDegree = kPi / 180;

/// An object that a light carries: from where it stands on, it follows the light's transformations.
struct Carried {
    const Block* block = nullptr;
    Transform first;             ///< ahead of the modifiers in its block
    Transform to_parent;
};

struct LightWords {
    Vec3 location{0}, point_at{0, 0, 1};
    Light light;
    bool spot = false, cylinder = false;
    std::optional<double> radius, falloff, tightness;
    LightFade fade;
    bool area = false, coloured = false;
    ShadowGrid grid;             ///< of an area light: its words may stand before `area_light`
    Transform transform;
    Carried looks_like, projected_through;
};

/// `spotlight`, `cylinder` and `shadowless` exclude each other: the last of them holds.
void set_form(LightWords& w, bool spot, bool cylinder, bool shadowless) { w.spot = spot, w.cylinder = cylinder, w.light.shadowless = shadowless; }

bool take_cone_word(LightWords& w, Cursor& at) {
    if (at.accept("spotlight"_w)) set_form(w, true, false, false);
    else if (at.accept("cylinder"_w)) set_form(w, false, true, false), w.light.parallel = true;
    else if (at.accept("shadowless"_w)) set_form(w, false, false, true);
    else if (at.accept("radius"_w)) w.radius = at.number("the radius of a light");
    else if (at.accept("falloff"_w)) w.falloff = at.number("the falloff of a light");
    else if (at.accept("tightness"_w)) w.tightness = at.number("the tightness of a light");
    else if (at.accept("point_at"_w)) w.point_at = at.vector("point_at");
    else if (at.accept("parallel"_w)) w.light.parallel = true;
    else return false;
    return true;
}

/// `area_light AXIS1, AXIS2, SIZE1, SIZE2`: the axes as they are before the light's transformations.
void take_area_light(LightWords& w, Cursor& at) {
    constexpr int kMostPoints = 1000;   // along one axis
    ShadowGrid& grid = w.grid;
    w.area = true;
    grid.axis1 = at.vector("the first axis of an area light"), grid.axis2 = at.vector("the second axis of an area light");
    grid.size1 = at.integer("the number of lights along the first axis", 1, kMostPoints);
    grid.size2 = at.integer("the number of lights along the second axis", 1, kMostPoints);
}

/// What belongs to an area light alone, and may stand before it.
bool take_area_word(LightWords& w, Cursor& at) {
    ShadowGrid& grid = w.grid;
    if (at.accept("area_light"_w)) take_area_light(w, at);
    else if (at.accept("adaptive"_w)) grid.adaptive = at.integer("the level of adaptive", 0, 100);
    else if (at.accept("jitter"_w)) grid.jitter = true;
    else if (at.accept("circular"_w)) grid.circular = true;
    else if (at.accept("orient"_w)) grid.orient = true;
    else if (at.accept("area_illumination"_w)) grid.illuminates = at.flag();
    else return false;
    return true;
}

bool take_light_word(LightWords& w, Cursor& at) {
    if (at.accept("fade_distance"_w)) w.fade.distance = at.number("the distance of fading");
    else if (at.accept("fade_power"_w)) w.fade.power = at.number("the power of fading");
    else if (at.accept("media_interaction"_w)) w.light.media_interaction = at.flag();
    else if (at.at_numeric() && !std::exchange(w.coloured, true)) w.light.intensity = at.rgb("the colour of a light");
    else return false;
    return true;
}

void move(LightWords& w, const Transform& t) {
    for (Transform* moved : {&w.transform, &w.looks_like.to_parent, &w.projected_through.to_parent}) *moved = t * *moved;
}

void read_light(Build& build, const Block& block, LightWords& w) {
    Cursor at(build, block);
    bool declared = false;
    if (const Block* base = at.block_at("light_source"_w)) at.next(), read_light(build, *base, w), declared = true;
    else w.location = at.vector("the location of a light");
    while (!at.done()) {
        if (at.at_transform()) move(w, at.transform());
        else if (declared && at.at_colour()) at.skip_quick_colour();
        else if (declared && at.at_numeric()) at.skip_unmodelled();
        else if (const Block* like = at.block_at("looks_like"_w)) at.next(), w.looks_like = {like, Transform::translate(w.transform.point(w.location)), {}};
        else if (const Block* through = at.block_at("projected_through"_w)) {
            if (w.projected_through.block) build.p.fail(through->place, "a light has one projected_through alone");
            at.next(), w.projected_through = {through, {}, {}};
        } else if (take_cone_word(w, at) || take_area_word(w, at) || take_light_word(w, at)) continue;
        else if (at.at_word("media_attenuation"_w)) at.skip();
        else at.skip_unmodelled();
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

/// The object that a light carries, in another space than the light's parent if there is one.
Node carried_node(Build& build, const Carried& carried, const Transform& into = {}) {
    Node out;
    out.to_parent = into * carried.to_parent;
    if (const auto built = build_object(build, *carried.block, carried.first)) out.children.push_back(built->node);
    return out;
}

/// The object that shows where the light is: it throws no shadow.
void add_looks(Build& build, const LightWords& w, Node& group) {
    Node looks = carried_node(build, w.looks_like);
    looks.flags.shadow = false;
    if (!looks.children.empty()) group.children.push_back(build.add_node(std::move(looks)));
}

/// What the light is projected through is kept in the space of the light's node, `placed`.
void add_projector(Build& build, const LightWords& w, const Transform& placed, Light& light) {
    const auto into_node = inverse(placed);
    if (!w.projected_through.block || !into_node) return;
    light.projected_through = build.add_node(carried_node(build, w.projected_through, *into_node));
}

/// What `spotlight` and `cylinder` make of radius, falloff and tightness, in whatever order the words stand.
void set_kind(LightWords& w) {
    if (w.spot) {
        ConeLight cone;
        if (w.radius) cone.radius = *w.radius * kDegree;
        if (w.falloff) cone.falloff = *w.falloff * kDegree;
        cone.tightness = w.tightness.value_or(cone.tightness);
        w.light.kind = cone;
    } else if (w.cylinder) {
        const CylinderLight usual;
        w.light.kind = CylinderLight{w.radius.value_or(usual.radius), w.falloff.value_or(usual.falloff), w.tightness.value_or(usual.tightness)};
    }
}

/// The grid's axes go with the light's transformations, into the space of the light's node. The rays of a parallel grid meet where the light points at: that is one unit of the node away.
void set_grid(LightWords& w, double reach, Mat3& node_axes) {
    if (!w.area) return;
    if (!w.light.parallel || !(reach > 0)) reach = 1;
    const Mat3 to_node = glm::transpose(node_axes) / reach;   // node_axes are orthonormal
    node_axes = node_axes * reach;
    w.grid.axis1 = to_node * w.transform.vector(w.grid.axis1), w.grid.axis2 = to_node * w.transform.vector(w.grid.axis2);
    w.light.shadow_grid = w.grid;
}

}  // namespace

NodeId build_light(Build& build, const Block& block) {
    LightWords w;
    w.light.intensity = Color(0);
    read_light(build, block, w);
    const Vec3 location = w.transform.point(w.location);
    Node node;
    const Vec3 axis = w.transform.point(w.point_at) - location;
    node.to_parent = facing(location, axis);
    set_kind(w);
    set_grid(w, length(axis), node.to_parent.linear);
    w.light.inverse_square = false;
    w.light.clearance = 0.001;
    if (w.fade.power > 0 && std::abs(w.fade.distance) > 1e-10) w.light.fade = w.fade;
    w.light.from = build.position(block.place);
    add_projector(build, w, node.to_parent, w.light);
    build.scene.lights.push_back(w.light);
    node.what = LightId{uint32_t(build.scene.lights.size() - 1)};
    node.from = w.light.from;
    const NodeId light = build.add_node(std::move(node));
    if (!w.looks_like.block) return light;
    Node group;
    group.children.push_back(light);
    add_looks(build, w, group);
    return build.add_node(std::move(group));
}

}  // namespace alidade::pov
