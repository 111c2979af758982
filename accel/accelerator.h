// SPDX-License-Identifier: Apache-2.0
/// The accelerators: three questions to ask of a set of primitives, and a table of structures that answer them.
///
/// Every structure gives the answer of brute force, bit for bit: the same t, ids, u, v (with Intersect::exact, which is the default). It knows nothing of scenes: this folder sees core alone.
#pragma once

#include "accel/intersect.h"
#include "accel/isa.h"
#include "accel/stats.h"
#include "core/bounds.h"
#include "core/ray.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

class Shaft;
struct TriangleView;

/// A node of a tree, for whoever studies trees.
struct TreeNode {
    uint32_t number = 0, parent = kNoId;      ///< the root has no parent
    uint32_t depth = 0;                       ///< nodes above it
    Bounds box;
    std::span<const uint32_t> children = {};     ///< their numbers; none in a leaf
    std::span<const uint32_t> primitives = {};   ///< a leaf's
    bool leaf = false;
};

class Accelerator {
  public:
    virtual ~Accelerator() = default;

    /// The first hit with ray.tmin <= t <= ray.tmax that comes before `hit` in the order of core/ray.h; true if there is one, which then replaces
    /// `hit`. A default-constructed Hit is behind all others. The instance of hits is `instance`, unless the primitives are instances themselves.
    virtual bool intersect(const Ray& ray, Hit& hit, WorkCounters& work, uint32_t instance = 0) const = 0;
    /// Makes hits[i] the first hit of rays[i], which is that of each by itself. Where rays that follow each other go the same way, as those of 4 x 4 pixels do, a BVH has less work with them together.
    virtual void intersect_many(std::span<const Ray> rays, std::span<Hit> hits, WorkCounters& work, uint32_t instance = 0) const {
        for (size_t i = 0; i < rays.size(); ++i) hits[i] = Hit(), intersect(rays[i], hits[i], work, instance);
    }
    /// Is anything hit with ray.tmin <= t <= ray.tmax?
    virtual bool occluded(const Ray& ray, WorkCounters& work) const = 0;
    /// All hits with ray.tmin <= t <= ray.tmax, appended to `hits` in order, each once.
    virtual void all_hits(const Ray& ray, std::vector<Hit>& hits, WorkCounters& work, uint32_t instance = 0) const = 0;

    /// Replaces `ids` by all primitives of a PrimitiveSet that a ray with all of its [tmin, tmax] in the shaft could hit, by their bounds. False if there are more
    /// than `most`, or if the structure cannot find them without looking at everything: then `ids` says nothing.
    virtual bool candidates(const Shaft& shaft, size_t most, std::vector<uint32_t>& ids) const = 0;

    virtual Bounds bounds() const = 0;   ///< of the bounded primitives
    virtual const BuildStats& stats() const = 0;
    /// Shows `visit` the nodes of a tree, depth first, each before its children; unbounded primitives are in none. False, and nothing shown, if the structure is no tree.
    virtual bool visit_nodes(const std::function<void(const TreeNode&)>& visit) const { return static_cast<void>(visit), false; }

    /// Takes new positions of the same triangles, on `threads` threads (0: as many as the machine has): answers are then those of a structure built over them, stats().sah_cost tells whether one would be worth
    /// it, and stats().seconds and phases are of this. False, and nothing changed, if the structure cannot, or if other triangles than before have no area or no finite corners: build a new one. Nobody may ask meanwhile.
    virtual bool refit(const TriangleView& mesh, int threads = 1) { return static_cast<void>(mesh), static_cast<void>(threads), false; }

    /// Writes the structure over `mesh` to a file that load_accelerator (accel/load.h) maps. An error is one sentence: of the file, or that this structure cannot be saved.
    virtual tl::expected<void, std::string> save(const std::string& path, const TriangleView& mesh) const;

    std::string why;   ///< where "auto" chose: what, and why
};

/// Primitives of any kind, for accelerators over shapes and instances. Bounds may be unbounded (then the primitive is tested by every ray) or empty
/// (then by none); NaN bounds are reported as removed. With AccelOptions::threads several threads ask for them at once.
class PrimitiveSet {
  public:
    virtual ~PrimitiveSet() = default;
    virtual size_t size() const = 0;
    virtual Bounds bounds(uint32_t id) const = 0;
    /// A box of the part of primitive `id` that lies in `box`; may be larger.
    virtual Bounds clipped_bounds(uint32_t id, const Bounds& box) const { return intersection(bounds(id), box); }
    /// As Accelerator::intersect, over these ids only. For every hit, entry(bounds) <= t <= exit(bounds) must hold as computed in double: see docs/numerics.md.
    virtual bool intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const = 0;
    virtual bool occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const = 0;
    virtual void all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const = 0;
};

/// A plain triangle array. The caller keeps it alive while the accelerator is built; for `compact`, and for one that is built lazily, as long as the accelerator lives.
struct TriangleView {
    std::span<const Vec3f> positions;
    std::span<const Vec3> exact_positions;   ///< empty, or as many: read instead of `positions` by double-precision accelerators
    std::span<const Index3> triangles;
};

enum class Precision { float_, double_ };

struct AccelOptions {
    Precision precision = Precision::float_;   ///< of mesh vertices, nodes and the edge filter; rays and hits are double always
    Isa isa = Isa::best;
    int threads = 1;                           ///< of the build (0: as many as the machine has); the structure does not depend on it
    Intersect intersect = Intersect::exact;    ///< of rays and triangles
};

struct AcceleratorEntry {
    const char* name;
    const char* doc;
    std::unique_ptr<Accelerator> (*over_triangles)(const TriangleView& mesh, const AccelOptions& options);
    std::unique_ptr<Accelerator> (*over_set)(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options);
};

/// The table; the first row is brute force, the oracle.
std::span<const AcceleratorEntry> accelerators();
/// The row of that name, or null. "auto" is a row of its own that is not in the table: it chooses one (accel/automatic.h).
const AcceleratorEntry* find_accelerator(std::string_view name);

}  // namespace alidade
