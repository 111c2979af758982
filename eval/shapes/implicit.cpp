// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/implicit.h"

namespace alidade {

ErrorBound implicit_bound(const ImplicitValue& f, int roundings, const Vec3& p, double at_rounding) {
    const double off = std::abs(f.value) + gamma_bound(roundings) * f.magnitude, slope = length(f.gradient);
    const double straight = slope > 0 ? 1.5 * off / slope : kInf;
    if (straight < 1e-5 * length(p)) return {straight + at_rounding};   // less than 4 cbrt(one rounding)
    const double singular = f.magnitude > 0 ? 4 * length(p) * std::cbrt(off / f.magnitude) : 0;
    return {std::min(straight, singular) + at_rounding};
}

SurfacePoint flat_mapped(const Vec3& normal, const Vec3& point) {
    SurfacePoint out;
    out.normal = normal;
    out.uv = {point.x, point.y};
    if (normal.z == 0) orthonormal_basis(normal, out.dpdu, out.dpdv);
    else out.dpdu = {1, 0, -normal.x / normal.z}, out.dpdv = {0, 1, -normal.y / normal.z};
    return out;
}

}  // namespace alidade
