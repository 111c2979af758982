// SPDX-License-Identifier: Apache-2.0
/// Colour spaces of FLIP. Tristimulus values are relative to the white of the display, so that white is (1, 1, 1) and gray has three equal ones.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace alidade::flip {

// Linear Rec. 709 to X/Xn, Y/Yn, Z/Zn and back: from the primaries and the white point (0.31271, 0.32902), D65 of the 2 degree observer.
inline constexpr float kToXyz[9] = {0.43389538883150308f, 0.37624237262225113f, 0.18986223854624579f, 0.21263682167732384f, 0.71518298184125073f,
                                    0.072180196481425471f, 0.017752423151729927f, 0.10946562866246513f, 0.8727819481858049f};
inline constexpr float kFromXyz[9] = {3.0803419882804608f, -1.5373989694887855f, -0.54294301879167506f, -0.92117839616512365f, 1.8759299836951759f,
                                      0.045248412469947583f, 0.052881292875543252f, -0.20401120612390997f, 1.1511299132483668f};

struct Three {
    float x, y, z;
};

inline Three times(const float (&m)[9], Three v) {
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z, m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

/// The opponent space YCxCz (linearised CIELAB) without its affine factors, which linear filters do not see: Y, X - Y, Y - Z; all of them relative.
inline Three opponent(Three rgb) {
    const Three xyz = times(kToXyz, rgb);
    return {xyz.y, xyz.x - xyz.y, xyz.y - xyz.z};
}

inline Three from_opponent(Three yxz) { return times(kFromXyz, {yxz.y + yxz.x, yxz.x, yxz.x - yxz.z}); }

/// The cube root of x in 0.001 .. 2, within 2 ulp: two steps of Halley's from a guess by the exponent. Without branches: compilers make vectors of it.
inline float cube_root(float x) {
    const float bits = float(std::bit_cast<int32_t>(x));
    float y = std::bit_cast<float>(int32_t(bits * (1.0f / 3.0f)) + 709921077);
    for (int step = 0; step < 2; ++step) {
        const float cube = y * y * y;
        y = y * (cube + 2 * x) / (2 * cube + x);
    }
    return y;
}

/// CIELAB's curve: a cube root with a straight start.
inline float lab_curve(float t) {
    constexpr float delta = 6.0f / 29, knee = delta * delta * delta;
    const float root = cube_root(std::max(t, knee));
    const float line = t * (1 / (3 * delta * delta)) + 4.0f / 29;
    return t > knee ? root : line;
}

/// CIELAB of linear Rec. 709 with Hunt's adjustment: chroma in proportion to lightness (section 4.1.2).
inline Three hunt_lab(Three rgb) {
    const Three xyz = times(kToXyz, rgb);
    const float fx = lab_curve(xyz.x), fy = lab_curve(xyz.y), fz = lab_curve(xyz.z);
    const float lightness = 116 * fy - 16;
    return {lightness, 0.01f * lightness * 500 * (fx - fy), 0.01f * lightness * 200 * (fy - fz)};
}

/// HyAB: city block in lightness, Euclid in chroma.
inline float hyab(Three a, Three b) {
    const float da = a.y - b.y, db = a.z - b.z;
    return std::abs(a.x - b.x) + std::sqrt(da * da + db * db);
}

}  // namespace alidade::flip
