// SPDX-License-Identifier: Apache-2.0
#include "eval/half_spaces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace alidade {
namespace {

constexpr size_t kMostHalfSpaces = 32;
/// Of coordinates, over what the planes are from the origin: what reaches farther has no end for us.
constexpr double kFar = 1e6;
/// Three unit normals whose determinant is smaller are parallel to a line, or nothing is known of where they meet ...
constexpr double kParallel = 1e-13;
/// ... unless it is larger than this: then corners are as exact as kSlack asks.
constexpr double kSurelyMeet = 1e-6;
/// Of a corner's coordinates: corners that are cut off by less than that count, and the box is wider by that.
constexpr double kSlack = 1e-9;

struct Meeting {
    double determinant;
    Vec3 point;
};

Meeting meet(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) {
    const Vec3 bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal), ab = cross(a.normal, b.normal);
    const double determinant = dot(a.normal, bc);
    return {std::abs(determinant), (a.offset * bc + b.offset * ca + c.offset * ab) / determinant};
}

/// With unit normals, and six that are `far` away; none if a normal has no length.
std::vector<HalfSpace> with_far_ones(std::span<const HalfSpace> half_spaces, double& far) {
    std::vector<HalfSpace> out;
    far = 0;
    for (const HalfSpace& h : half_spaces) {
        const double size = length(h.normal);
        if (!(size > 0) || !std::isfinite(size) || !std::isfinite(h.offset)) return {};
        out.push_back({h.normal / size, h.offset / size});
        far = std::max(far, std::abs(h.offset / size));
    }
    far = far > 0 ? far * kFar : kFar;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            HalfSpace end{Vec3(0), far};
            end.normal[axis] = sign;
            out.push_back(end);
        }
    return out;
}

}  // namespace

Bounds box_of_corners(std::span<const HalfSpace> half_spaces) {
    const Bounds everywhere{Vec3(-kInf), Vec3(kInf)};
    if (half_spaces.size() < 4 || half_spaces.size() > kMostHalfSpaces) return everywhere;
    double far = 0;
    const std::vector<HalfSpace> all = with_far_ones(half_spaces, far);
    const auto holds = [&](const Vec3& p) { return std::ranges::all_of(all, [&](const HalfSpace& h) { return dot(h.normal, p) <= h.offset + kSlack * (max_abs(p) + far / kFar); }); };
    Bounds box;
    for (size_t i = 0; i < all.size(); ++i)
        for (size_t j = i + 1; j < all.size(); ++j)
            for (size_t k = j + 1; k < all.size(); ++k) {
                const Meeting corner = meet(all[i], all[j], all[k]);
                if (corner.determinant < kParallel) continue;
                if (corner.determinant < kSurelyMeet && k < half_spaces.size()) return everywhere;
                if (!holds(corner.point)) continue;
                if (k >= half_spaces.size()) return everywhere;
                box.extend(corner.point);
            }
    if (box.empty()) return everywhere;
    const Vec3 pad(kSlack * std::max(max_abs(box.min), max_abs(box.max)));
    return {box.min - pad, box.max + pad};
}

}  // namespace alidade
