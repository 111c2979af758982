// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/cameras.h"

#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/textures.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace alidade::pov {

namespace {

/// What the words of a camera say. From version 3.5 on they act together at its end, `arrange`; before, each where it stands.
struct CameraWords {
    Camera camera;
    Vec3 sky{0, 1, 0};
    std::optional<Vec3> look_at;          ///< the last that was given
    std::optional<double> angle, vertical_angle;
    LensNoise noise;
    bool sized = false;                   ///< right or up was given
    bool look_at_waits = false, angle_waits = false, orthographic_waits = false;   ///< given, and has not acted yet
    Transform transform;                  ///< has not acted yet
};

/// Of cameras whose window is not flat: 90 degrees, and all around for the spherical one, where nothing is said.
void set_angles(const CameraWords& words, Camera& c) {
    const bool spherical = c.projection == Projection::spherical, given = words.angle && *words.angle > 0;
    c.angle = given ? *words.angle : spherical ? 360 : 90;
    if (spherical && words.vertical_angle) c.vertical_angle = *words.vertical_angle;
}

bool is_flat(const Camera& c) { return c.projection == Projection::perspective || c.projection == Projection::orthographic; }

/// What POV-Ray does with `angle` where the window is flat: direction gets the length that makes the window fill it.
void apply_angle(Build& build, Place at, const CameraWords& words, Camera& c) {
    if (!is_flat(c) || *words.angle <= 0) return;
    if (c.projection == Projection::perspective && *words.angle >= 180) build.p.fail(at, "the angle of a perspective camera must be less than 180 degrees");
    c.direction = normalized(c.direction) * (length(c.right) / (2 * std::tan(*words.angle * kPi / 360)));
}

/// The window turns towards the point, upright as the sky says; its handedness stays.
void apply_look_at(Build& build, Place at, const CameraWords& words, Camera& c) {
    const Vec3 towards = *words.look_at - c.location;
    constexpr double kNearest = 1e-5;   // as POV-Ray has it
    if (length(towards) < kNearest) build.p.fail(at, "look_at is the camera's location");
    const double along = length(c.direction), high = length(c.up), wide = length(c.right), hand = dot(cross(c.up, c.direction), c.right);
    c.direction = normalized(towards);
    const Vec3 side = cross(words.sky, c.direction);
    const bool no_side = std::abs(side.x) < 1e-10 && std::abs(side.y) < 1e-10 && std::abs(side.z) < 1e-10;
    c.right = normalized(no_side ? c.right : side);
    c.up = cross(c.direction, c.right) * high;
    c.right *= hand > 0 ? wide : -wide;
    c.direction *= along;
}

/// The window gets the size that it would fill at the distance of what is looked at, which is <0,0,1> until it is given: in order always; together only
/// where its size is not given.
void apply_orthographic(const CameraWords& words, bool in_order, Camera& c) {
    if (c.projection != Projection::orthographic || (!in_order && words.sized && !words.angle)) return;
    const double scale = length(words.look_at.value_or(Vec3(0, 0, 1)) - c.location) / length(c.direction);
    c.right *= scale, c.up *= scale;
}

void check(Build& build, Place at, const Camera& c) {
    if (length(c.direction) == 0) build.p.fail(at, "the camera's direction has no length");
    if (length(c.right) == 0 || length(c.up) == 0) build.p.fail(at, "the camera's right or up has no length");
}

/// Does what waits. `in_order`: the words of an old camera, of which one waits at most.
void arrange(Build& build, Place at, bool in_order, CameraWords& words) {
    Camera& c = words.camera;
    check(build, at, c);
    if (std::exchange(words.angle_waits, false)) apply_angle(build, at, words, c);
    if (std::exchange(words.look_at_waits, false)) apply_look_at(build, at, words, c);
    if (std::exchange(words.orthographic_waits, false)) apply_orthographic(words, in_order, c);
    const Transform moved = std::exchange(words.transform, Transform());
    c.location = moved.point(c.location);
    c.direction = moved.vector(c.direction), c.right = moved.vector(c.right), c.up = moved.vector(c.up);
    check(build, at, c);
}

std::optional<Projection> projection(WordId word) {
    switch (word) {
        case "perspective"_w: return Projection::perspective;
        case "orthographic"_w: return Projection::orthographic;
        case "fisheye"_w: return Projection::fisheye;
        case "ultra_wide_angle"_w: return Projection::ultra_wide_angle;
        case "omnimax"_w: return Projection::omnimax;
        case "panoramic"_w: return Projection::panoramic;
        case "cylinder"_w: return Projection::cylindrical;
        case "spherical"_w: return Projection::spherical;
        default: return std::nullopt;
    }
}

void take_lens(CameraWords& words, WordId word, Cursor& at) {
    switch (word) {
        case "aperture"_w: words.camera.aperture = at.number("the aperture") / 2; break;   // POV-Ray's lens is half as wide (tests/scenes/pov_pictures_test.cpp)
        case "blur_samples"_w:
            words.camera.blur_samples = at.integer("the number of samples", 1, 1'000'000), words.noise.fewest = 0;
            if (!at.at_number()) break;
            words.noise.fewest = words.camera.blur_samples;
            words.camera.blur_samples = at.integer("the largest number of samples, not below the smallest", words.noise.fewest, 1'000'000);
            break;
        default: words.camera.focal_point = at.vector("the focal point");
    }
}

/// A number from 0 to 1, or between them. Where it is another, the one before stays.
void take_share(Build& build, Cursor& at, const char* what, bool ends_too, double& out) {
    const Place place = at.place();
    const double given = at.number(what);
    if (ends_too ? given >= 0 && given <= 1 : given > 0 && given < 1) out = given;
    else build.p.warn(place, fmt::format("{} must be between 0 and 1: {} is used", what, out));
}

/// One word of a camera with its values; false if it is none.
bool take_word(Build& build, CameraWords& words, Cursor& at) {
    if (at.peek().kind != Item::Kind::word) return false;
    const WordId word = at.peek().word;
    if (const auto kind = projection(word)) {
        at.next();
        words.camera.projection = *kind;
        words.orthographic_waits = kind == Projection::orthographic;
        if (kind == Projection::cylindrical) words.camera.cylinder = at.integer("the type of the cylinder", 1, 4);
        return true;
    }
    switch (word) {
        case "location"_w: at.next(), words.camera.location = at.vector("the location"); return true;
        case "direction"_w: at.next(), words.camera.direction = at.vector("the direction"); return true;
        case "right"_w: at.next(), words.camera.right = at.vector("right"), words.sized = true; return true;
        case "up"_w: at.next(), words.camera.up = at.vector("up"), words.sized = true; return true;
        case "sky"_w: at.next(), words.sky = at.vector("the sky"); return true;
        case "look_at"_w: at.next(), words.look_at = at.vector("look_at"), words.look_at_waits = true; return true;
        case "angle"_w:
            at.next(), words.angle = at.number("the angle"), words.angle_waits = true;
            if (at.at_number()) words.vertical_angle = at.number("the vertical angle");
            return true;
        case "aperture"_w: case "blur_samples"_w: case "focal_point"_w: at.next(), take_lens(words, word, at); return true;
        case "variance"_w: at.next(), take_share(build, at, "the variance", true, words.noise.variance); return true;
        case "confidence"_w: at.next(), take_share(build, at, "the confidence", false, words.noise.confidence); return true;
        default: return false;
    }
}

/// `camera { NAME ... }`: from version 3.5 on it goes on with transformations alone.
void check_named(Build& build, const Block& block) {
    const auto is_camera = [](const Item& item) { return item.kind == Item::Kind::value && item.value_kind() == Kind::block && item.block().word == "camera"_w; };
    const std::span<const Item> items = block.items();
    for (size_t i = 1; i < items.size(); ++i)
        if (is_camera(items[i])) build.p.fail(items[i].place, "the name of a camera stands at the beginning of a camera alone: POV-Ray refuses it elsewhere, too");
    if (items.empty() || !is_camera(items[0]) || block.version < 3.5F) return;
    Cursor at(build, block);
    for (at.next(); !at.done(); at.transform())
        if (!at.at_transform()) build.p.fail(at.place(), "behind the name of a camera nothing but transformations stands: POV-Ray refuses it, too", "declare the camera anew with all its words");
}

void read_words(Build& build, const Block& block, CameraWords& words) {
    check_named(build, block);
    const bool in_order = block.version < 3.5F;
    for (Cursor at(build, block); !at.done();) {
        const Place place = at.place();
        const Block* other = at.block_at("camera"_w);
        if (other) at.next(), read_words(build, *other, words);
        else if (const Block* normal = at.block_at("normal"_w)) at.next(), words.camera.normal = build_normal(build, *normal, words.camera.normal ? words.camera.normal : default_texture(build, normal->defaults).normal);
        else if (at.at_transform()) words.transform = at.transform() * words.transform;
        else if (!take_word(build, words, at)) at.skip_unmodelled();
        if (in_order) arrange(build, place, !other || other->version < 3.5F, words);
    }
}

}  // namespace

Camera build_camera(Build& build, const Block& block) {
    CameraWords words;
    words.camera.direction = {0, 0, 1}, words.camera.right = {1.33, 0, 0}, words.camera.up = {0, 1, 0};
    read_words(build, block, words);
    arrange(build, block.place, false, words);
    Camera& c = words.camera;
    if (!is_flat(c)) set_angles(words, c);
    if (c.normal && is_flat(build, *c.normal)) c.normal.reset();
    c.from = build.position(block.place);
    c.fit = Fit::stretch;
    build.scene.settings.lens_noise = c.aperture > 0 ? std::optional(words.noise) : std::nullopt;
    return c;
}

}  // namespace alidade::pov
