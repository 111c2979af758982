// SPDX-License-Identifier: Apache-2.0
/// A ray tracer that is measured beside others, on the same triangles and rays.
#pragma once

#include "stress/rays.h"

#include <memory>
#include <optional>
#include <string>

namespace alidade {

/// What a ray met first: a Hit, without what measuring does not look at.
struct StressHit {
    double t = kInf;
    uint32_t instance = kNoId, primitive = kNoId;
    float u = 0, v = 0;

    bool hits() const { return primitive != kNoId; }
    friend bool operator==(const StressHit&, const StressHit&) = default;
};

/// Of the structure that was built, those below places added up: where nothing is known, nothing.
struct StressStructure {
    size_t bytes = 0;                     ///< without the caller's arrays
    std::optional<size_t> nodes, leaves, references, removed;
    std::optional<size_t> depth;          ///< the deepest mesh's, and that of the structure over the places
    std::optional<double> sah_cost;       ///< of the mesh with the most triangles
    std::vector<BuildPhase> phases;       ///< of the last build; empty where the tracer does not tell
};

/// Single rays, one thread. Rays are converted to the tracer's own within the measured time.
class StressPeer {
  public:
    virtual ~StressPeer() = default;
    /// Builds all structures over the scene, which outlives them.
    virtual void build(const StressScene& scene) = 0;
    /// Frees them.
    virtual void drop() = 0;
    /// hits[i] becomes what rays[i] meets first.
    virtual void closest(std::span<const StressRay> rays, std::span<StressHit> hits) = 0;
    /// hit[i] becomes 1 if anything is hit, else 0.
    virtual void any(std::span<const StressRay> rays, std::span<uint8_t> hit) = 0;
    virtual StressStructure structure() const = 0;
    /// Since build(); nothing where the tracer does not count.
    virtual std::optional<WorkCounters> work() const { return std::nullopt; }

    std::string name, precision = "float";
    bool exact = false;        ///< its hits are those of brute force in this precision, bit for bit; else ids are not looked at, and t to 1e-5 of it
    int threads = 1;           ///< that build() uses (0: as many as the machine has); with one it is measured in CPU time, with more on the clock
    bool accountable = true;   ///< its wrong answers are disagreements; else they are only counted
};

/// An accelerator of our registry, or of anybody's, which is not exact then: t depends on the box in which a ray is met. `entry` must live as long. `together`: closest hits are asked by intersect_many.
std::unique_ptr<StressPeer> make_own_peer(const AcceleratorEntry& entry, const AccelOptions& options, bool together = false);
/// Embree 3 with default and with robust settings, from the library that the system has; empty where there is none, or this was built without its headers.
std::vector<std::unique_ptr<StressPeer>> make_embree_peers();

}  // namespace alidade
