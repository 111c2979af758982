// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/shape.h"

namespace alidade {

inline bool is_complete(const Polynomial& f) {
    return f.order >= 1 && f.order <= Polynomial::kMostOrder && f.coefficients.size() == Polynomial::terms(f.order);
}

/// How many of the first `most` are 0: Horner's rule begins behind them. Most coefficients of most polynomials are.
inline int leading_zeros(const double* c, int most) {
    int count = 0;
    while (count < most && c[count] == 0) ++count;
    return count;
}

/// f by Horner's rule in x, of polynomials in y, of polynomials in z: the order in which the coefficients stand. A Sum begins as 0, and takes sums and
/// coefficients; `times(sum, axis)` multiplies one by a coordinate. At most 2 roundings a power in a row.
template <class Sum, class Times> Sum horner(const Polynomial& f, const Times& times) {
    const double* c = f.coefficients.data();
    Sum in_x;
    for (int i = f.order; i >= 0; --i) {
        const int most = f.order - i;
        int zeros = leading_zeros(c, (most + 1) * (most + 2) / 2), j = most;
        c += zeros;
        for (; j >= 0 && zeros > most - j; --j) zeros -= most - j + 1;   // nothing has been added to in_y
        times(in_x, 0);
        if (j < 0) continue;
        Sum in_y;
        for (bool first = true; j >= 0; --j, first = false) {
            if (!first) zeros = leading_zeros(c, most - j + 1), c += zeros, times(in_y, 1);
            if (zeros > most - j) continue;
            Sum in_z;
            for (int k = most - j - zeros; k >= 0; --k) times(in_z, 2), in_z.add(*c++);
            in_y.add(in_z);
        }
        in_x.add(in_y);
    }
    return in_x;
}

}  // namespace alidade
