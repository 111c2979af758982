// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/seeds.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace alidade {
namespace {

/// Two pictures of 8 bits may be rounded in different directions. Linear ones have a hundredth, which is about as much for the eye, and room for black.
constexpr double kDisplayFloor = 1.0 / 255 + 1e-6, kLinearFloor = 3e-4, kLinearShare = 0.01;

/// All pictures of one program, each as it is beside one of the other's.
tl::expected<SeedStatistics, std::string> statistics(const Rendered& rendered, const std::string& beside, bool is_reference, const DiffRequest& request) {
    SeedStatistics out;
    std::vector<std::string> files{rendered.picture};
    files.insert(files.end(), rendered.more.begin(), rendered.more.end());
    for (const std::string& file : files) {
        const auto loaded = is_reference ? load_pair(file, beside, request.pair) : load_pair(beside, file, request.pair);
        if (!loaded) return tl::unexpected(loaded.error().sentence);
        const Picture& picture = is_reference ? loaded->pair.reference : loaded->pair.test;
        if (loaded->non_finite.in_one > 0) return tl::unexpected(fmt::format("{} has values that are no numbers", file));
        if (out.count() > 0 && picture.values.size() != out.values()) return tl::unexpected(fmt::format("{} has other channels than the picture of another seed", file));
        out.add(picture);
    }
    return out;
}

std::string verdict_text(const SeedComparison& c) {
    const size_t pixels = c.result.marked.size();
    if (c.result.significant == 0) return fmt::format("no pixel differs by more than the noise of {} seeds explains", c.seeds);
    return fmt::format("{} of {} pixels ({:.3g} %) differ by more than the noise of {} seeds explains", c.result.significant, pixels,
                       100 * double(c.result.significant) / double(std::max<size_t>(pixels, 1)), c.seeds);
}

void judge(const SeedComparison& c, Comparison& comparison) {
    Judgement& judgement = comparison.judgement;
    const bool kept = c.result.significant == 0;
    judgement.checks.push_back({"--noise", double(c.result.significant), false, kept, false});
    if (!kept || judgement.verdict == Verdict::pass) judgement.verdict = kept ? Verdict::pass : Verdict::fail, judgement.reason = verdict_text(c);
    comparison.marked = c.result.marked;
}

const char* name_of(ReferenceNoise noise) {
    constexpr const char* kNames[] = {"none", "like ours", "measured"};
    return kNames[size_t(noise)];
}

}  // namespace

tl::expected<SeedComparison, std::string> compare_seeds(const Rendered& reference, const Rendered& test, bool random, const DiffRequest& request, Comparison& comparison) {
    const auto ours = statistics(test, reference.picture, false, request);
    if (!ours) return tl::unexpected(ours.error());
    const auto theirs = statistics(reference, test.picture, true, request);
    if (!theirs) return tl::unexpected(theirs.error());
    SeedComparison out{ours->count(), theirs->count(), ReferenceNoise::none, {}};
    if (theirs->count() > 1) out.reference_noise = ReferenceNoise::measured;
    else if (random) out.reference_noise = ReferenceNoise::like_ours;
    const PicturePair& pair = comparison.loaded->pair;
    out.result = test_seeds(*ours, *theirs, out.reference_noise, pair.counts, pair.hdr ? kLinearFloor : kDisplayFloor, pair.hdr ? kLinearShare : 0);
    judge(out, comparison);
    return out;
}

Json to_json(const SeedComparison& c) {
    const double largest = c.result.largest_z;
    return {{"seeds", c.seeds}, {"reference_seeds", c.reference_seeds}, {"reference_noise", name_of(c.reference_noise)}, {"alpha", kSeedAlpha}, {"tests", c.result.tests},
            {"significant", c.result.significant}, {"share", double(c.result.significant) / double(std::max<size_t>(c.result.marked.size(), 1))},
            {"largest_z", std::isfinite(largest) ? Json(largest) : Json()}, {"limit", c.result.limit}};
}

std::string as_lines(const SeedComparison& c) {
    const char* how[] = {"not random", "taken to be as random as ours", "measured, too"};
    return fmt::format("noise of {} seeds; the reference is {}\n", c.seeds, how[size_t(c.reference_noise)]);
}

}  // namespace alidade
