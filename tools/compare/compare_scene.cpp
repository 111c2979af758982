// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/compare_scene.h"

#include "importers/importer.h"
#include "scene/queries.h"
#include "tools/compare/program.h"
#include "tools/povray_words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace alidade {
namespace {

/// Both programs' pictures are made of random numbers, which are not the same ones.
bool is_random(const Imported& imported) {
    for (const RequiredBy& each : requirements(imported.scene))
        if (each.what == Requirement::area_lights || each.what == Requirement::depth_of_field || each.what == Requirement::media) return true;
    for (const Material& material : imported.scene.materials)
        for (const auto& layer : material.layers)
            if (const auto* finish = std::get_if<PovFinish>(&layer); finish && finish->crand > 0) return true;
    for (const Diagnostic& message : imported.diagnostics.list())
        for (const char* word : {"radiosity", "photons", "media", "subsurface"})
            if (message.message.find(word) != std::string::npos) return true;
    return false;
}

bool has_random_effects(const PovJob& job) {
    const auto words = parse_povray_words(povray_words(job, "none.png"));
    if (!words) return false;
    ImportOptions options;
    options.include_paths = words->library_paths, options.declarations = words->declarations;
    options.frame.image_width = job.width, options.frame.image_height = job.height;
    options.frame.clock = clock_of(*words, words->subset_start.value_or(words->initial_frame));
    const auto imported = import_scene(job.scene, options);
    return imported && is_random(*imported);
}

void fail_with(SceneComparison& out, const RenderFailure& failure) {
    out.missing_program = failure.missing;
    out.comparison.judgement = {Verdict::error, failure.sentence, {}};
    out.comparison.cause = {failure.missing ? "missing" : failure.reference ? "reference" : "render", failure.sentence};
}

Json to_json(const Rendered& rendered) {
    return {{"command", fmt::format("{}", fmt::join(rendered.command, " "))}, {"cpu_seconds", rendered.cpu_seconds}, {"from_cache", rendered.from_cache}};
}

}  // namespace

SceneComparison compare_with_povray(const PovJob& job, const DiffRequest& request) {
    SceneComparison out;
    out.job = job;
    const auto scratch = std::make_shared<std::pair<ScratchFolder, ScratchFolder>>();
    out.scratch = scratch;
    const auto reference = povray_reference(job, scratch->first.path());
    if (!reference) return fail_with(out, reference.error()), out;
    out.reference = *reference;
    const auto test = povray_test(job, scratch->second.path());
    if (!test) return fail_with(out, test.error()), out;
    out.test = *test;
    out.comparison = compare_files(reference->picture, test->picture, request);
    out.noisy = has_random_effects(job);
    if (out.comparison.loaded) out.graded = grade(out.comparison.loaded->pair, out.noisy);
    else if (out.comparison.judgement.verdict == Verdict::incomparable) out.graded.grade = Grade::off;
    out.comparison.reference = "POV-Ray " + povray_version(), out.comparison.test = "alidade";
    return out;
}

Json to_json(const SceneComparison& c) {
    Json out = to_json(c.comparison);
    out["scene"] = c.job.scene;
    out["grade"] = {{"name", name_of(c.graded.grade)}, {"rmse", c.graded.rmse}, {"over2", c.graded.over2}, {"envelope", c.graded.envelope}, {"noisy", c.noisy}};
    if (c.reference) out["reference_render"] = to_json(*c.reference);
    if (c.test) out["test_render"] = to_json(*c.test);
    return out;
}

std::string as_lines(const SceneComparison& c) {
    std::string out;
    if (c.reference) out += fmt::format("POV-Ray {}: {:.2f} CPU s{}\n", povray_version(), c.reference->cpu_seconds, c.reference->from_cache ? " (kept from before)" : "");
    if (c.test) out += fmt::format("alidade: {:.2f} CPU s\n", c.test->cpu_seconds);
    out += as_lines(c.comparison);
    if (c.test) out += fmt::format("grade: {}{}\n", name_of(c.graded.grade), c.noisy ? " (of a scene with random effects)" : "");
    return out;
}

}  // namespace alidade
