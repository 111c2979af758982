// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/hash.h"

#include <random>
#include <vector>

namespace alidade {

std::span<const double, 32768> cell_randoms() {
    static const std::vector<double> numbers = [] {
        std::vector<double> all(32768);
        std::mt19937 twister;   // its default seed, 5489
        for (double& n : all) n = double(twister()) / 4294967296.0;
        return all;
    }();
    return std::span<const double, 32768>(numbers);
}

}  // namespace alidade
