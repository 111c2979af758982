// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/random.h"

#include "importers/pov/integers.h"

namespace alidade::pov {

size_t RandomStreams::seed(double value) {
    states_.push_back(uint32_t(to_int(value)));
    return states_.size() - 1;
}

std::optional<double> RandomStreams::next(double stream) {
    const int number = to_int(stream);
    if (number < 0 || size_t(number) >= states_.size()) return std::nullopt;
    uint32_t& state = states_[size_t(number)];
    state = state * 1812433253u + 12345u;
    return state / 4294967295.0;
}

}  // namespace alidade::pov
