// SPDX-License-Identifier: Apache-2.0
/// A ray tracer that is measured beside others, on the same triangles and rays.
#pragma once

#include "stress/rays.h"

#include <memory>
#include <string>

namespace alidade::bench {

/// Single rays, one thread. Rays are converted to the tracer's own within the measured time.
class Peer {
  public:
    virtual ~Peer() = default;
    /// Builds all structures over the scene, which outlives this; any older ones are dropped first.
    virtual void build(const StressScene& scene) = 0;
    /// t[i] becomes the first hit of rays[i], infinity for a miss.
    virtual void closest(std::span<const StressRay> rays, std::span<float> t) = 0;
    /// hit[i] becomes 1 if anything is hit.
    virtual void any(std::span<const StressRay> rays, std::span<uint8_t> hit) = 0;
    virtual size_t bytes() const = 0;   ///< of the structures, without the caller's arrays
    virtual std::string work() const { return ""; }

    std::string name;
};

/// One of the accelerators of the registry.
std::unique_ptr<Peer> make_own_peer(const AcceleratorEntry& entry, const AccelOptions& options);
/// Embree 3 with default and with robust settings; empty where this was built without it.
std::vector<std::unique_ptr<Peer>> make_embree_peers();

}  // namespace alidade::bench
