// SPDX-License-Identifier: Apache-2.0
/// `compare --noise`: pictures of many seeds to a verdict.
#pragma once

#include "tools/compare/reference.h"
#include "tools/diff/words.h"
#include "tools/metrics/seed_noise.h"

namespace alidade {

/// A test of pixels, and of what pictures.
struct SeedComparison {
    int seeds = 0, reference_seeds = 0;
    ReferenceNoise reference_noise = ReferenceNoise::none;
    SeedNoise result;
};

/// Tests all pictures of both; `random`: a single reference is made of random numbers. The outcome becomes a check of `comparison` and part of its verdict,
/// and its heat map marks the pixels. An error is one sentence.
tl::expected<SeedComparison, std::string> compare_seeds(const Rendered& reference, const Rendered& test, bool random, const DiffRequest& request, Comparison& comparison);

Json to_json(const SeedComparison& compared);
std::string as_lines(const SeedComparison& compared);

}  // namespace alidade
