// SPDX-License-Identifier: Apache-2.0
#include "numerics/suite.h"

#include "numerics/rows.h"
#include "numerics/triangles/subjects.h"

namespace alidade {

namespace numerics {
namespace {

constexpr NumericsRow kSuite[] = {
    {"T01", "leak-edge", "rays from inside of closed meshes (sizes 1e-15 to 1e15, flat, needles, offsets to 1e6) at points of edges, half of them on a lattice; all accelerators, float and double, exact and robust; each eighth ray as a shadow's, too",
     "each hits", 3000000, 2770000000, leak_edge},
    {"T02", "leak-vertex", "the same at vertices",
     "each hits", 1800000, 2770000000, leak_vertex},
    {"T03", "leak-scale", "closed meshes of any size from 1e-15 to 1e15, as they are, 1e-6 to 1e-5 flat, needles of 1e3 to 1e4, blades, up to 1e6 sizes from the origin; half of the rays at edges, half at vertices",
     "each hits", 400000, 400000000, leak_scale},
    {"T04", "parity", "whole lines through closed meshes, at edges, vertices and in planes of the mesh, a quarter from 100 to 1000 sizes away: all hits of all accelerators; rational arithmetic, and a line moved aside by less than any number",
     "each triangle that is touched is hit once, and an even number is crossed", 20000, 10000000, parity},
    {"T05", "tri-exact", "triangles generic, grazing to 1e-9 radians, far, thin, small beside their offset, on a lattice; targets on edges and within 1e-6 of them; rational arithmetic; units of roundoff of float of t",
     "all decisions those of the exact local ray, t within 1, u and v within 1e-6, the point within its own bound", 5000, 4000000, tri_exact},
    {"T06", "tri-underflow", "the same at sizes of 1e-20, 1e-30, 1e15 and 1e18",
     "the same", 2000, 2000000, tri_underflow},
    {"T07", "sphere-far", "spheres from 4 to 1e12 radii away; 512-bit arithmetic; units in the last place of t",
     "t within 4, hit or miss right outside of 4 units of the distance", 40000, 10000000, sphere_far},
    {"T08", "sphere-tangent", "lines 1e-3 to 1e-14 radii inside or outside of the silhouette; 512-bit arithmetic",
     "hit or miss right outside of 4 units of the distance, t within 4", 40000, 10000000, sphere_tangent},
    {"T09", "quadric-cancel", "cylinder, cone, ellipsoid 1:1e6, paraboloid, from 10 to 1e6 away; 512-bit arithmetic; units in the last place of t, or of the distance where that is more",
     "t within 4, normals within 1e-12 radians where it is less than 100 away", 20000, 4000000, quadric_cancel},
    {"T10", "quartic-far", "a torus and its quartic from 2 to 1e8 major radii away, half of the lines 1e-3 to 1e-9 from a tangent; Sturm's theorem in 512 bits; units of the distance",
     "no crossing missed or wrong, within 4 of the surface", 1500, 200000, quartic_far},
    {"T11", "roots", "polynomials of degree 3 to 15 (there are no isosurfaces yet): any coefficients, any roots, clustered, double, 1e-12 to 0.1 apart, at 0 and powers of two, evenly spaced; Sturm's theorem in integers; units of the rounding of the polynomial there",
     "a change of sign within 2^-51 of each root, or the value within 1; one root for each true one between places where the value is more than 4 units", 2000, 1000000, roots},
    {"T12", "scale-image", "every kind of shape, a mesh and a solid, five surfaces each; the whole world scaled by a transform, by 2^-40 to 2^40 or 1e-12 to 1e12, or its vertices and numbers themselves by 2^-40 to 2^40: bits of pictures, pixels of 1200; no digit lost below the least normal number",
     "the same bits by powers of two, of vertices and numbers to 2^20; else no pixel off by more than 2/255", 200, 10000, scale_image},
    {"T13", "offset-image", "the pictures of T12, moved by 1e2 to 1e9: pixels of 1200 that are off by more than 2/255",
     "none to 1e7, 0.1 % beyond", 200, 10000, offset_image},
    {"T14", "axes-permute", "closed forms and triangles with their axes exchanged and mirrored, in each accelerator and precision; units in the last place of t, or of the origin's or a corner's distance where that is longer, of closed forms across the surface",
     "the same hits, within 1; where axes are only mirrored, the same bits", 40000, 4000000, axes_permute, "where axes are exchanged, and not only mirrored, one answer of 1900 is off by more, up to 16 units with a closed form and 5 with a triangle: sums of three products round by their order"},
    {"T15", "accel-equal", "all accelerators and brute force on 16 meshes of sizes 1e-6 to 1e6 and on instances of every kind of shape at one place, 18 classes of rays: the first hit, any hit, all hits",
     "the same bits, the lowest id where hits are at one place (not of triangles that only the box of their instance brings to one)", 100000, 100000000, accel_equal},
    {"T16", "axis-parallel", "rays along axes through lattice planes, edges and corners, and from them, the direction's other components 0, -0 or denormal; where planes stand is known; units of roundoff of t",
     "each plane met, t within 3 of origin and t, nothing else", 30000, 10000000, axis_parallel},
    {"T17", "self-hit", "rays that leave every kind of shape, two meshes among them, of size 1e-12 to 1e12, up to 1e7 sizes away, half of them grazing to 1e-8; all accelerators, float and double",
     "no convex one is met again, no other nearby; the bound of the error is below 1e-6 of the size", 400000, 1250000000, self_hit},
    {"T18", "contact", "two surfaces 1e-7 to 1e-2 of their size apart, closed forms from 1e-9 on, meshes at least 4 units in the last place of their coordinates; rays leave each for the other",
     "the other is met", 150000, 100000000, contacts},
    {"T19", "bad-input", "NaN, infinity, 3e38, denormals, no area, duplicates and nothing, as triangles, closed forms and rays, in each accelerator and precision; the bits of what is good",
     "the good part unchanged, what is removed is told and costs no work, what is kept at most doubles it, and adds 8 tests a ray", 600, 60000, bad_input},
    {"T20", "transform-extreme", "a sphere stretched by 1e-12 to 1e12 an axis, sheared by 1e6, mirrored, turned, under 30 transforms, or flat; 512-bit arithmetic; radians between normals",
     "normals within 1e-6, points within the error they tell, what is flat is told", 6000, 600000, transform_extreme},
    {"T21", "csg-coincident", "solids less, with and beside themselves, cut by planes, by transforms and inverses, boxes side by side, in each accelerator; the algebra of sets",
     "no ray sees a difference", 5000, 1000000, csg_coincident},
    {"T22", "refraction", "one face, at angles from 0 to 90 degrees and at the critical one, indices from 1 to 1e6; up to 64 boxes in boxes; 512-bit arithmetic; units in the last place",
     "directions within 2, the way back within 1e-12 where an index is less than 1000 times both cosines", 20000, 4000000, refraction},
    {"T23", "fresnel-energy", "the same angles and indices; what is mirrored and, by 512-bit arithmetic, let through; units in the last place",
     "the sum is 1 within 2", 20000, 4000000, fresnel_energy},
    {"T24", "white-furnace", "metal-rough surfaces and POV-Ray's finishes under a hemisphere, or a cap, of light, and under a sky; the lobes' integrals; standard errors of the mean",
     "within 3.5; never more than arrives, but of POV-Ray's highlights", 60, 3000, white_furnace},
    {"T25", "determinism", "the pictures of T12 on 1 to 8 threads, with tiles of 1 to 64, each accelerator and instruction set: bits of pictures",
     "the same bits", 200, 10000, determinism},
    {"T26", "mesh-files", "fans with coordinates from denormal to 3.4e38, surveyed, with more than 65536 vertices, normals as short as 1e-38, through each format that is written, and as a fan of glTF; bits of vertices, directions of normals",
     "all is written and read, the same", 500, 100000, mesh_files},
};

}  // namespace
}  // namespace numerics

std::span<const NumericsRow> numerics_suite() { return numerics::kSuite; }

const NumericsRow* find_numerics(std::string_view word) {
    for (const NumericsRow& row : numerics::kSuite) {
        if (word == row.id || word == row.name) return &row;
    }
    return nullptr;
}

void ask_numerics(const NumericsAsked& what) { numerics::ask(what); }

}  // namespace alidade
