// SPDX-License-Identifier: Apache-2.0
/// Student's distribution, for tests of means.
#pragma once

#include <cstddef>

namespace alidade {

/// The normal deviate that a Student's t of `degrees` is as rare as, to 0.7 % of it for 8 degrees and more and t up to 12; it errs to the small side where t is large.
/// Source   Wallace, "Bounds on normal approximations to Student's and the chi-square distributions", Ann. Math. Statist. 30 (1959), section 3.
double normal_deviate(double t, double degrees);

/// The deviate that the largest of `tests` independent ones exceeds, up or down, with the probability `alpha`: Sidak's correction.
double sidak_limit(double alpha, size_t tests);

}  // namespace alidade
