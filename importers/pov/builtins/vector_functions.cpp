// SPDX-License-Identifier: Apache-2.0
/// Functions of vectors (POV-Ray reference, 3.3.1.6.5).
#include "eval/noise/noise.h"
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"
#include "importers/pov/rotation.h"

namespace alidade::pov {

namespace {

using Components = std::array<double, 5>;

Vec3 next_vector(Parser& p) {
    p.accept(',');
    const Components c = parse_vector(p);
    return {c[0], c[1], c[2]};
}

Vec3 first_vector(Parser& p) {
    p.expect('(', "before the arguments of a function");
    return next_vector(p);
}

Value vcross(Parser& p, Place) {
    const Vec3 a = first_vector(p), b = next_vector(p);
    close(p);
    return of_three(cross(a, b));
}

Value vdot(Parser& p, Place) {
    const Vec3 a = first_vector(p), b = next_vector(p);
    close(p);
    return Value::number(dot(a, b));
}

Value vlength(Parser& p, Place) {
    const Vec3 a = first_vector(p);
    close(p);
    return Value::number(std::sqrt(dot(a, a)));
}

/// The zero vector stays as it is.
Value vnormalize(Parser& p, Place at) {
    const Vec3 a = first_vector(p);
    close(p);
    const double l = std::sqrt(dot(a, a));
    if (l == 0) p.warn(at, "a vector of length 0 is normalized");
    return of_three(l == 0 ? Vec3(0) : Vec3(a.x / l, a.y / l, a.z / l));
}

Value vrotate(Parser& p, Place) {
    const Vec3 v = first_vector(p), degrees = next_vector(p);
    close(p);
    return of_three(rotation(degrees) * v);
}

Value vaxis_rotate(Parser& p, Place) {
    const Vec3 v = first_vector(p), axis = next_vector(p);
    const double degrees = next_float(p);
    close(p);
    return of_three(axis_rotation(axis, degrees) * v);
}

/// vturbulence(lambda, omega, octaves, point); of octaves there are 1 to 10.
Value vturbulence(Parser& p, Place) {
    p.expect('(', "before the arguments of a function");
    Turbulence t;
    t.lambda = parse_float(p), t.omega = next_float(p);
    const double octaves = next_float(p);
    t.octaves = octaves >= 1 ? octaves <= 10 ? int(octaves) : 10 : 1;
    const Vec3 at = next_vector(p);
    close(p);
    return of_three(vector_turbulence(at, t));
}

constexpr BuiltinEntry kVectorFunctions[] = {
    {"vcross"_w, vcross}, {"vdot"_w, vdot}, {"vlength"_w, vlength}, {"vnormalize"_w, vnormalize}, {"vrotate"_w, vrotate}, {"vaxis_rotate"_w, vaxis_rotate},
    {"vturbulence"_w, vturbulence},
};

}  // namespace

std::span<const BuiltinEntry> vector_functions() { return kVectorFunctions; }

}  // namespace alidade::pov
