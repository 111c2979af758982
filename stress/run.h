// SPDX-License-Identifier: Apache-2.0
/// Accelerators side by side on one scene: what they cost to build and to ask, and whether they say the same.
#pragma once

#include "stress/hardware.h"
#include "stress/measure.h"
#include "stress/peer.h"

#include <atomic>
#include <functional>

namespace alidade {

struct StressOptions {
    int rounds = 5;                            ///< of rays; builds get half as many, at least one
    double oracle_tests = 2e7;                 ///< triangle tests that brute force may take for each set of rays; never fewer than 16 rays
    double seconds = kInf;                     ///< on the clock; what is predicted not to fit is left out
    double clock_factor = 1;                   ///< seconds on the clock that one of CPU time takes on this machine, as others use it now
    size_t bytes = ~size_t(0);                 ///< of the scene and the structures; the same
    const std::atomic<bool>* stop = nullptr;   ///< asked between batches of rays and before builds
    std::function<void(double)> progress;      ///< is told what has been done, of stress_work()
};

/// What is known of a peer from a smaller scene, to predict from.
struct StressPace {
    double primitives = 0;  ///< of that scene: triangles, and places; 0: nothing is known
    double build_seconds = 0, ray_seconds = 0, bytes = 0, peak_bytes = 0;
};

struct StressRayFigures {
    std::string rays;
    Question question = Question::closest;
    std::string left_out;      ///< why there is nothing below; empty if there is
    size_t count = 0, hits = 0;
    int rounds = 0;
    Spread seconds;            ///< CPU time of a round
    std::optional<double> boxes, triangles, decided;   ///< of a ray: box tests or steps, triangles looked at, and decided in double
    EventCounts events;        ///< of a ray, the mean of all rounds: what the processor counted
    uint64_t hash = 0;         ///< of all answers: exact peers of one precision have the same
    size_t unlike = 0;         ///< rays whose answer is not that of the first exact peer of the precision
};

struct StressPeerFigures {
    std::string name, precision;
    std::string left_out;      ///< why there is nothing below; empty if there is
    int builds = 0;
    Spread build_seconds;      ///< CPU time; on the clock if several threads built
    StressStructure structure;
    std::optional<size_t> peak_bytes;   ///< of the process while it was built, over what was there before (PeakMemory)
    std::vector<StressRayFigures> rays;
};

/// A wrong answer: the first of a peer for a set of rays.
struct StressDisagreement {
    std::string peer, precision, rays;
    Question question = Question::closest;
    size_t ray = 0, wrong = 0;   ///< its number in the set, and how many were found wrong
    StressRay asked;
    StressHit got, wanted;       ///< for any-hit rays only whether they hit is said

    std::string sentence() const;
};

/// How many rays of a set were asked of brute force.
struct StressChecked {
    std::string rays, precision;
    size_t count = 0;
};

struct StressFigures {
    size_t triangles = 0, placed_triangles = 0, places = 0, scene_bytes = 0;
    std::vector<StressPeerFigures> peers;
    std::vector<StressChecked> checked;
    std::vector<StressDisagreement> disagreements;   ///< empty: all agree
    bool interrupted = false;
};

/// Builds all peers over the scene and asks each all rays, in turns. `paces`, one a peer or none, say what to expect. Hits of exact peers are compared with
/// each other, bit for bit, and with brute force's on some rays of each set; where peers differ, brute force says who is right.
StressFigures run_stress(const StressScene& scene, std::span<const RaySet> rays, std::span<const std::unique_ptr<StressPeer>> peers, const StressOptions& options,
                         std::span<const StressPace> paces = {});

/// The sets of make_ray_sets, by a BVH that is built for it.
std::vector<RaySet> stress_rays(const StressScene& scene, std::vector<StressRay> primary, uint64_t seed);

inline constexpr Intersect kExactAlone[] = {Intersect::exact};
/// Each of `entries` in each precision with each test of triangles, built on so many threads. The entries must live as long as the peers.
std::vector<std::unique_ptr<StressPeer>> make_peers(std::span<const AcceleratorEntry> entries, std::span<const Precision> precisions, int threads = 1, std::span<const Intersect> tests = kExactAlone);

/// For programs with an accelerator of their own: `entries` beside each other on the four kinds of rays, side x side of the camera's.
StressFigures stress_entries(const StressScene& scene, std::span<const AcceleratorEntry> entries, size_t side = 128, const StressOptions& options = {});

StressPace pace_of(const StressPeerFigures& figures, size_t primitives);

/// What options.progress counts up to.
double stress_work(size_t primitives, size_t peers, size_t rays, int rounds);

}  // namespace alidade
