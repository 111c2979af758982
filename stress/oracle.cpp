// SPDX-License-Identifier: Apache-2.0
#include "stress/oracle.h"

#include <cmath>

namespace alidade {

StressHit StressOracle::answer(const StressRay& ray, Question question, const std::string& precision) {
    const bool in_double = precision == "double";
    auto& brute = brute_[in_double];
    if (!brute) {
        AccelOptions options;
        options.precision = in_double ? Precision::double_ : Precision::float_;
        brute = make_own_peer(accelerators().front(), options);
        brute->build(scene_);
    }
    StressHit hit;
    uint8_t any = 0;
    if (question == Question::any) brute->any({&ray, 1}, {&any, 1}), hit = any_hit(any != 0);
    else brute->closest({&ray, 1}, {&hit, 1});
    return hit;
}

StressHit any_hit(bool hit) { return hit ? StressHit{0, 0, 0, 0, 0} : StressHit(); }

bool is_near(const StressHit& got, const StressHit& wanted, Question question) {
    if (got.hits() != wanted.hits()) return false;
    return question == Question::any || !got.hits() || std::abs(got.t - wanted.t) <= 1e-5 * std::abs(wanted.t);
}

}  // namespace alidade
