// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace alidade {

/// `v` as POV-Ray keeps it where it has single precision. Through memory, since g++ 12 with -O3 drops the way there and back when it does two of them at once.
inline double single(double v) {
    volatile float rounded = float(v);
    return double(rounded);
}

}  // namespace alidade
