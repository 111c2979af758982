// SPDX-License-Identifier: Apache-2.0
#include "numerics/peers.h"

namespace alidade {

namespace {

constexpr const char* kPovRay = "POV-Ray 3.7.0.10";
constexpr const char* kEmbree = "Embree 3.13.5";
constexpr const char* kRobustEmbree = "Embree 3.13.5, robust";
constexpr const char* kTinybvh = "tinybvh of 2026-02-13";
constexpr const char* kTinybvhInDouble = "tinybvh of 2026-02-13, double";
constexpr const char* kBvh = "madmann91/bvh of 2025-06-16, robust, float";
constexpr const char* kBvhInDouble = "madmann91/bvh of 2025-06-16, robust, double";
constexpr const char* kLeaks = "10 closed meshes of sizes 1e-15 to 1e10, up to 1e6 from the origin, 200,000 rays each";
constexpr const char* kTriangles = "12,000 rays a class";

constexpr NumericsPeer kPeers[] = {
    {"T01", kEmbree, "43,000 to 332,000 of a million miss, all at 1e-15", kLeaks},
    {"T01", kTinybvh, "97,000 to 373,000 of a million miss, all at 1e-3 and less (of eight children: at 1e-12)", kLeaks},
    {"T01", "tinybvh of 2026-02-13, watertight, mended to compile", "335 to 199,000 of a million miss", kLeaks},
    {"T01", kTinybvhInDouble, "100 to 17,500 of a million miss, all at 1e-3 and less", kLeaks},
    {"T01", kBvh, "1,400 to 31,600 of a million miss", kLeaks},
    {"T01", kBvhInDouble, "none misses", kLeaks},
    {"T01", kRobustEmbree, "none misses", kLeaks},
    {"T02", kRobustEmbree, "50 to 1,955 of a million miss", kLeaks},
    {"T02", kBvh, "3,600 to 31,000 of a million miss", kLeaks},
    {"T02", kBvhInDouble, "none misses", kLeaks},
    {"T03", kRobustEmbree, "leaks at vertices at all sizes, nowhere at edges", kLeaks},
    {"T03", kBvhInDouble, "does not leak", kLeaks},
    {"T03", kTinybvh, "sees nothing of size 1e-3 and less (of eight children: of 1e-12; watertight: sees all)", kLeaks},
    {"T04", kEmbree, "hits are there twice on edges", "its issue 188, not measured by us"},
    {"T05", kEmbree, "t is off by up to 320,000 units, and by 260 million of a triangle of size 1e6 that is 1 away; 2 to 17 % miss and 7 to 53 % hit falsely within 1e-6 of an edge", kTriangles},
    {"T05", kTinybvh, "t is off by up to 1.7 million units, and by 1.8 billion of a triangle of size 1e6", kTriangles},
    {"T05", "Moeller and Trumbore's test in double", "t within 0.9 units, no decision wrong", kTriangles},
    {"T06", kEmbree, "all miss, or t is NaN", kTriangles},
    {"T06", kTinybvh, "all miss, or t is NaN", kTriangles},
    {"T06", "Moeller and Trumbore's test in double", "all right", kTriangles},
    {"T07", kPovRay, "0.4 % miss at 9e5 radii", "trace(), 4,000 rays"},
    {"T08", kPovRay, "all miss 1e-12 radii inside of the silhouette", "trace(), 4,000 rays"},
    {"T10", kPovRay, "the quartic misses or is wrong always from 1e4 on; the torus never", "trace(), 4,000 rays"},
    {"T12", kPovRay, "glass is wrong outside of 1e-1 to 1e4, everything is gone at 1e-5", "pictures of 200 x 150"},
    {"T13", kPovRay, "mesh2 is wrong in 21 % of its pixels at 1e5, black at 1e8", "pictures of 200 x 150"},
    {"T16", kTinybvh, "67 % miss in double, none in float", "11,532 rays through vertices of a lattice"},
    {"T17", "rays from t > 1e-4, robust Embree", "490 of a million at size 1, 505,000 at 1e6", "a closed mesh, outward rays"},
    {"T17", "pbrt-v4's bound of the error, or Waechter and Binder's step, robust Embree", "none", "a closed mesh, up to 1e5 from the origin"},
    {"T17", "the same, tinybvh", "0 to 7,770 of a million", "a closed mesh, up to 1e5 from the origin"},
    {"T18", "rays from t > 1e-4, robust Embree", "all are lost at sizes of 1e-3 and less", "two squares"},
    {"T18", "pbrt-v4's bound of the error, robust Embree", "none is lost but at 1.6 units in the last place", "two squares"},
    {"T19", kTinybvh, "hits wrongly, or ends the program", "a mesh with one bad triangle, 50,000 rays"},
    {"T19", kEmbree, "a direction of NaN ends the program", "Debian's build, which has assertions"},
    {"T20", kPovRay, "21 % of the pixels are wrong from a flatness of 1e-8 on", "pictures of 200 x 150"},
    {"T21", kPovRay, "a sphere less itself keeps 99.8 % of its pixels", "pictures of 200 x 150"},
    {"T24", kPovRay, "diffuse surfaces are exact", "radiosity, albedo 0.5"},
};

}  // namespace

std::span<const NumericsPeer> numerics_peers() { return kPeers; }

std::string peers_text(std::string_view row) {
    std::string text;
    for (const NumericsPeer& peer : kPeers)
        if (row == peer.row) text += std::string(text.empty() ? "" : "; ") + peer.program + ": " + peer.figure;
    return text.empty() ? "not measured" : text;
}

}  // namespace alidade
