// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/extents.h"

#include "eval/kept_boxes.h"
#include "eval/quadric_reach.h"
#include "importers/pov/builders/objects.h"
#include "importers/pov/builders/shapes.h"
#include "importers/pov/builders/texts.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace alidade::pov {

namespace {

const Bounds kAllSpace{Vec3(-kInf), Vec3(kInf)};

struct Extent;

/// What clips or bounds an object. References share it: copies of copies would double at every level.
struct Limit {
    std::shared_ptr<const Extent> what;
    Bounds box;                          ///< of it; all space if it is turned inside out
};

/// What an object is as long as its transformations are read.
struct Extent {
    enum class Rule { sphere, points, at_once, step_by_step };
    Rule rule = Rule::step_by_step;
    Bounds box;                          ///< in the shape's own space, or as it has become step by step
    Transform transform;                 ///< at once
    Sphere sphere;
    std::vector<Vec3> points;
    bool flat = false;                   ///< a polygon: has some thickness where it has none
    bool inverse = false;
    std::optional<Plane> plane;          ///< moved by `transform`
    std::optional<Quadric> quadric;      ///< moved already
    std::vector<Limit> clips, bounds;
    double limits = 0;                   ///< how many there are: each is moved as the object is
};

Bounds own_box(const Extent& e) {
    switch (e.rule) {
        case Extent::Rule::sphere: return {e.sphere.center - std::abs(e.sphere.radius), e.sphere.center + std::abs(e.sphere.radius)};
        case Extent::Rule::at_once: return e.box.finite() ? e.transform.bounds(e.box) : e.box;
        case Extent::Rule::step_by_step: return e.box;
        case Extent::Rule::points: break;
    }
    Bounds box;
    for (const Vec3& p : e.points) box.extend(p);
    constexpr double kThickness = 0.001;
    for (int i = 0; i < 3; ++i)
        if (e.flat && box.max[i] - box.min[i] < 1e-9) box.min[i] -= kThickness, box.max[i] += kThickness;
    return box;
}

void replace_by_smaller(Bounds& box, const std::vector<Limit>& others) {
    if (others.empty()) return;
    Bounds common = kAllSpace;
    for (const Limit& other : others) common = intersection(common, other.box);
    box = smaller_box(box, common);
}

Bounds box_of(const Extent& e) {
    Bounds box = own_box(e);
    if (box.empty() && !box.finite()) return box;
    replace_by_smaller(box, e.bounds);
    replace_by_smaller(box, e.clips);
    return box;
}

Limit limit_of(Extent e) {
    const Bounds box = e.inverse ? kAllSpace : box_of(e);
    return {std::make_shared<const Extent>(std::move(e)), box};
}

/// Does it keep a sphere one?
bool keeps_spheres(const Item& item, const Transform& t) {
    if (item.kind != Item::Kind::word || item.word == "matrix"_w || item.word == "transform"_w) return false;
    return item.word != "scale"_w || (t.linear[0].x == t.linear[1].y && t.linear[0].x == t.linear[2].z);
}

void move(Extent& e, const Item& item, const Transform& t);

/// What is moved with the object that it limits is finished. Sets, meshes and quadrics move the box that they had; another shape makes its box anew, without what limits itself, but for what clips one that has no end.
void finish(Extent& e) {
    if (e.rule == Extent::Rule::step_by_step) e.box = box_of(e);
    if (e.rule == Extent::Rule::step_by_step || own_box(e).finite()) e.clips.clear();
    e.bounds.clear();
    e.limits = double(e.clips.size());
}

void move(std::vector<Limit>& limits, const Item& item, const Transform& t) {
    for (Limit& limit : limits) {
        Extent e = *limit.what;
        finish(e);
        move(e, item, t);
        limit = limit_of(std::move(e));
    }
}

void move(Extent& e, const Item& item, const Transform& t) {
    if (e.rule == Extent::Rule::sphere) {
        if (keeps_spheres(item, t)) {
            e.sphere.center = t.point(e.sphere.center);
            if (item.word == "scale"_w) e.sphere.radius *= t.linear[0].x;
        } else {
            e.box = own_box(e), e.transform = t, e.rule = Extent::Rule::at_once;
        }
    } else if (e.rule == Extent::Rule::points) {
        for (Vec3& p : e.points) p = t.point(p);
    } else if (e.rule == Extent::Rule::at_once) {
        e.transform = t * e.transform;
    } else if (e.box.finite()) {
        e.box = moved_box(t, e.box);
    }
    if (e.quadric) e.quadric = moved(*e.quadric, t);
    move(e.clips, item, t);
    move(e.bounds, item, t);
}

Extent of_shape(const ShapeGeometry& geometry) {
    Extent e;
    e.rule = Extent::Rule::at_once;
    if (const auto* s = std::get_if<Sphere>(&geometry)) {
        e.rule = Extent::Rule::sphere, e.sphere = *s;
    } else if (const auto* p = std::get_if<Polygon>(&geometry)) {
        e.rule = Extent::Rule::points, e.flat = true;
        for (const auto& loop : p->loops) e.points.insert(e.points.end(), loop.begin(), loop.end());
    } else if (const auto* q = std::get_if<Quadric>(&geometry)) {
        e.rule = Extent::Rule::step_by_step, e.quadric = *q, e.box = box_of_ellipsoid(*q);
    } else if (std::holds_alternative<Mesh>(geometry)) {
        e.rule = Extent::Rule::step_by_step, e.box = bounds(geometry);
    } else {
        if (const auto* plane = std::get_if<Plane>(&geometry)) e.plane = *plane;
        const FramedBox framed = framed_box(geometry);
        e.box = framed.box, e.transform = framed.frame;
    }
    return e;
}

/// Corners of a triangle that stands alone.
void set_corners(Extent& e, const ShapeGeometry& geometry) {
    const auto* mesh = std::get_if<Mesh>(&geometry);
    if (!mesh) return;
    e.rule = Extent::Rule::points;
    for (size_t i = 0; i < mesh->positions.size(); ++i) e.points.push_back(mesh->exact_positions.empty() ? Vec3(mesh->positions[i]) : mesh->exact_positions[i]);
}

Bounds common_box(const std::vector<Extent>& parts, bool difference) {
    Bounds box = kAllSpace;
    const auto inverted = [&](const Extent& part) { return part.inverse != (difference && &part != &parts.front()); };
    for (const Extent& part : parts)
        if (!inverted(part) && !part.plane) box = intersection(box, box_of(part));   // what limits a plane itself does not count
    for (const Extent& part : parts)
        if (part.plane) cut_by_plane(box, *part.plane, part.transform, inverted(part));
    for (const Extent& part : parts)
        if (part.quadric && !inverted(part) && !box.empty()) box = intersection(box, reach(*part.quadric, box));
    return box.finite() && !box.empty() ? box : kAllSpace;
}

Bounds joined_box(const std::vector<Extent>& parts) {
    Bounds box;
    for (const Extent& part : parts) box.extend(box_of(part));
    return box.empty() || !box.finite() ? kAllSpace : box;
}

}  // namespace

/// Reads blocks of objects.
class Extents::Reader {
  public:
    explicit Reader(Build& build) : build_(build) {}

    /// Each block once: a chain of references can double at every level.
    Extent object(const Block& block) {
        const auto known = known_.find(&block);
        if (known != known_.end()) return known->second;
        Cursor at(build_, block);
        Extent e = begin(block, at);
        while (!at.done()) modifier(e, at);
        return known_.emplace(&block, std::move(e)).first->second;
    }

  private:
    Extent begin(const Block& block, Cursor& at) {
        const Block* first = at.any_block();
        const bool set = block.word == "union"_w || block.word == "merge"_w || block.word == "intersection"_w || block.word == "difference"_w || block.word == "light_group"_w;
        if (first && is_object(first->word) && (block.word == "object"_w || (first->word == block.word && !set))) return at.next(), object(*first);
        Extent e;
        if (set) {
            e.box = of_parts(block.word, parts(at));
        } else if (block.word == "text"_w) {
            const Bounds box = build_text(build_, at).box;
            e.box = box.empty() ? kAllSpace : box;
        } else if (block.word == "light_source"_w) {
            e.box = kAllSpace;
        } else if (const auto shape = build_shape(build_, block.word, at)) {
            e = of_shape(shape->geometry);
            if (block.word == "triangle"_w || block.word == "smooth_triangle"_w) set_corners(e, shape->geometry);
        }
        return e;
    }

    std::vector<Extent> parts(Cursor& at) {
        std::vector<Extent> all;
        while (const Block* part = at.any_block()) {
            if (!is_object(part->word)) break;
            at.next();
            all.push_back(object(*part));
        }
        return all;
    }

    static Bounds of_parts(WordId word, const std::vector<Extent>& parts) {
        if (word == "intersection"_w || word == "difference"_w) return common_box(parts, word == "difference"_w);
        return joined_box(parts);
    }

    /// A quadric has the box of what it reaches in those of its clips.
    static void clip_quadric(Extent& e) {
        if (!e.quadric || e.clips.empty()) return;
        Bounds box = e.box;
        for (const Limit& clip : e.clips) {
            if (clip.what->plane) cut_by_plane(box, *clip.what->plane, clip.what->transform, clip.what->inverse);
            else box = intersection(box, clip.box);
        }
        if (!box.empty()) box = reach(*e.quadric, box);
        if (box.finite()) e.box = box;
    }

    void modifier(Extent& e, Cursor& at) {
        if (at.at_transform()) {
            const Item& item = at.peek();
            moved(e, item, at.transform());
        } else if (const Block* clip = at.block_at("clipped_by"_w)) {
            at.next();
            add_limits(e, e.clips, *clip);
            clip_quadric(e);
        } else if (const Block* bound = at.block_at("bounded_by"_w)) {
            at.next();
            add_limits(e, e.bounds, *bound);
        } else if (at.accept("inverse"_w)) {
            e.inverse = !e.inverse;
        } else {
            at.skip();
        }
    }

    void moved(Extent& e, const Item& item, const Transform& t) {
        copies_ += e.limits;
        const uint64_t most = build_.p.options.limits.copies;
        if (copies_ > double(most)) build_.p.fail_limit(item.place, &Limits::copies, fmt::format("more than {} copies of what clips and bounds objects are moved for their extents", most));
        move(e, item, t);
    }

    /// The objects in `clipped_by` or `bounded_by`, moved by the transformations behind them.
    void add_limits(Extent& e, std::vector<Limit>& limits, const Block& block) {
        Cursor at(build_, block);
        std::vector<Extent> all = parts(at);
        while (!at.done()) {
            const Item& item = at.peek();
            if (!at.at_transform()) {
                at.skip();
                continue;
            }
            const Transform t = at.transform();
            for (Extent& limit : all) finish(limit), moved(limit, item, t);
        }
        for (Extent& limit : all) {
            e.limits += 1;
            limits.push_back(limit_of(std::move(limit)));
        }
    }

    Build& build_;
    std::map<const Block*, Extent> known_;
    double copies_ = 0;       ///< of limits
};

Extents::Extents(Build& build) : reader_(std::make_unique<Reader>(build)) {}
Extents::~Extents() = default;

Bounds Extents::of(const Block& block) {
    const Bounds box = box_of(reader_->object(block));
    if (box.empty() && !box.finite()) return box;
    if (!box.finite()) return {Vec3(-kUnboundedExtent), Vec3(kUnboundedExtent)};
    const auto rounded = [](const Vec3& v) { return Vec3(in_single(v.x), in_single(v.y), in_single(v.z)); };
    const Vec3 low = rounded(box.min);
    return {low, rounded(low + rounded(box.max - box.min))};
}

}  // namespace alidade::pov
