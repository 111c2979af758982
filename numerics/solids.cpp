// SPDX-License-Identifier: Apache-2.0
/// The algebra of sets, where faces coincide: in whole scenes, by any accelerator.
#include "numerics/rows.h"
#include "numerics/scene_maker.h"
#include "numerics/shape_samples.h"
#include "tracer/compiled_scene.h"

#include <fmt/format.h>

namespace alidade::numerics {

namespace {

/// A solid twice over: as a set operation makes it, and as it is without; the same place is reached by different numbers.
class Twins {
  public:
    explicit Twins(uint64_t number) : draws_(RandomKey(21, 0, number)) {
        for (SceneMaker* m : {&made, &plain}) m->unlit(Color(1));
        ShapeDraw draw{draws_};
        do shape_ = sample_shape(shapes()[draws_.below(shapes().size())], int(draws_.below(10)), draw);
        while (!find_shape(shape_)->solid(shape_));
        const double scale = std::pow(10, draws_.uniform(-3, 3));
        place_ = Transform::translate(draws_.direction() * scale * std::pow(10, draws_.uniform(-1, 2))) * turn() * Transform::scale(Vec3(scale));
        (this->*kLaws[number % kLawCount].make)();
        name_ = fmt::format("{}, of a {}", kLaws[number % kLawCount].name, find_shape(shape_)->name);
    }

    SceneMaker made, plain;
    const std::string& name() const { return name_; }

    /// At the solid, from a few sizes away.
    Ray ray(uint64_t i) {
        Draws draws(RandomKey(21, 1 + i, draws_.below(1u << 30)));
        const Vec3 aim = draws.in_box(Vec3(-2), Vec3(2)), from = aim + draws.direction() * draws.uniform(5, 20);
        Ray ray;
        ray.origin = place_.point(from), ray.dir = normalized(place_.vector(aim - from)), ray.tmin = -kInf;
        return ray;
    }

  private:
    struct Law {
        const char* name;
        void (Twins::*make)();
    };

    Transform turn() { return Transform::rotate(draws_.direction(), draws_.uniform(0, 2 * kPi)); }

    uint32_t op(SceneMaker& m, CsgKind kind, uint32_t parent = kNoId) {
        Node n;
        n.csg = kind;
        return m.node(std::move(n), parent);
    }
    uint32_t add(SceneMaker& m, ShapeGeometry shape, uint32_t parent = kNoId, bool inverse = false) {
        const uint32_t at = m.object(std::move(shape), {0}, place_, parent);
        m.scene.nodes[at].inverse = inverse;
        return at;
    }
    /// At the same place, by a turn and its inverse.
    void add_turned(SceneMaker& m, uint32_t parent) {
        const Transform there = turn();
        Node n;
        n.to_parent = there;
        m.object(shape_, {0}, alidade::inverse(there).value_or(Transform()) * place_, m.node(std::move(n), parent));
    }

    void difference() {
        const uint32_t whole = op(made, CsgKind::difference);
        add(made, shape_, whole), add(made, shape_, whole);
    }
    void with_inverse() {
        const uint32_t whole = op(made, CsgKind::intersection);
        add(made, shape_, whole), add(made, shape_, whole, true);
    }
    void twice(CsgKind kind) {
        const uint32_t whole = op(made, kind);
        add(made, shape_, whole), add(made, shape_, whole), add(plain, shape_);
    }
    void intersection() { twice(CsgKind::intersection); }
    void merge() { twice(CsgKind::merge); }
    void turned_difference() {
        const uint32_t whole = op(made, CsgKind::difference);
        add(made, shape_, whole), add_turned(made, whole);
    }
    void turned_intersection() {
        const uint32_t whole = op(made, CsgKind::intersection);
        add(made, shape_, whole), add_turned(made, whole), add(plain, shape_);
    }

    /// A plane through the shape, and again by other numbers.
    std::pair<Plane, Plane> cuts() {
        const Plane cut{draws_.direction(), draws_.uniform(-0.5, 0.5)};
        const double longer = draws_.uniform(0.1, 10);
        return {cut, Plane{cut.normal * longer, cut.distance}};
    }
    void halves(CsgKind kind) {
        const auto [cut, again] = cuts();
        const uint32_t whole = op(made, kind), one = op(made, CsgKind::intersection, whole), other = op(made, CsgKind::difference, whole);
        add(made, shape_, one), add(made, cut, one);
        add(made, shape_, other), add(made, again, other);
    }
    void merged_halves() { halves(CsgKind::merge), add(plain, shape_); }
    void common_of_halves() { halves(CsgKind::intersection); }

    /// Boxes side by side: 0.1 * 3 is not 0.3.
    void abutting() {
        const double at = draws_.uniform(-0.5, 0.5), third = at / 3;
        const uint32_t whole = op(made, CsgKind::merge);
        add(made, Box{Vec3(-1), Vec3(at, 1, 1)}, whole), add(made, Box{Vec3(third * 3, -1, -1), Vec3(1)}, whole);
        add(plain, Box());
    }
    /// A pit as deep as you like, whose mouth is in the face it is dug into.
    void pit() {
        const double depth = draws_.uniform(-0.9, 0.9);
        for (SceneMaker* m : {&made, &plain}) {
            const uint32_t whole = op(*m, CsgKind::difference);
            add(*m, Box(), whole), add(*m, Box{Vec3(-0.5, depth, -0.5), Vec3(0.5, m == &made ? 1 : 1.5, 0.5)}, whole);
        }
    }

    static constexpr size_t kLawCount = 10;
    static const Law kLaws[kLawCount];

    Draws draws_;
    ShapeGeometry shape_;
    Transform place_;
    std::string name_;
};

const Twins::Law Twins::kLaws[kLawCount] = {
    {"A - A = 0", &Twins::difference},
    {"A * -A = 0", &Twins::with_inverse},
    {"A * A = A", &Twins::intersection},
    {"A + A = A", &Twins::merge},
    {"A - A' = 0, A' turned there and back", &Twins::turned_difference},
    {"A * A' = A, A' turned there and back", &Twins::turned_intersection},
    {"A * H + (A - H) = A", &Twins::merged_halves},
    {"A * H * (A - H) = 0", &Twins::common_of_halves},
    {"boxes side by side are one", &Twins::abutting},
    {"a pit with its mouth in the face", &Twins::pit},
};

std::vector<Hit> all_hits(const CompiledScene& scene, const Ray& ray) {
    std::vector<Hit> hits;
    WorkCounters work;
    scene.top->all_hits(ray, hits, work);
    return hits;
}

/// Does the ray come so near to touching a surface, or to an edge, that rounding decides what it meets? `alone` are the crossings of what is there.
bool grazes(const std::vector<Hit>& alone, double size) {
    for (size_t i = 1; i < alone.size(); ++i)
        if (alone[i].t - alone[i - 1].t < 1e-5 * size) return true;
    return false;
}

bool same(const std::vector<Hit>& a, const std::vector<Hit>& b, double within) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [&](const Hit& x, const Hit& y) { return std::abs(x.t - y.t) <= within; });
}

}  // namespace

Check csg_coincident() {
    return [](uint64_t number, NumericsTally& tally) {
        Twins twins(number);
        CompileOptions options;
        options.accel = accelerators()[number / 10 % accelerators().size()].name, options.threads = 1;
        Diagnostics said;
        const auto made = compile(twins.made.scene, options, said), plain = compile(twins.plain.scene, options, said);
        if (!made || !plain) return tally.decide(false, [&] { return said.text(); });
        for (uint64_t i = 0; i < 50; ++i) {
            const Ray ray = twins.ray(i);
            const std::vector<Hit> want = all_hits(*plain, ray), got = all_hits(*made, ray);
            const double size = length(ray.origin);
            if (grazes(want, size)) continue;
            tally.decide(same(got, want, 1e-9 * size), [&] {
                return fmt::format("{}, {}; ray {} <{}, {}, {}> + t <{}, {}, {}>: {} surfaces, not {}", twins.name(), options.accel, i, ray.origin.x, ray.origin.y, ray.origin.z, ray.dir.x, ray.dir.y, ray.dir.z, got.size(), want.size());
            });
        }
    };
}

}  // namespace alidade::numerics
