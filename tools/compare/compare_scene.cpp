// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/compare_scene.h"

#include "exporters/exporter.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tools/compare/program.h"
#include "tools/output.h"
#include "tools/povray_words.h"
#include "tracer/render.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>

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

using Scratch = std::pair<ScratchFolder, ScratchFolder>;   // the reference's, and ours

void compare_pictures(SceneComparison& out, const DiffRequest& request) {
    out.comparison = compare_files(out.reference->picture, out.test->picture, request);
    if (out.comparison.loaded && !out.comparison.measured.empty()) out.graded = grade(out.comparison.loaded->pair, out.noisy);
    else if (out.comparison.judgement.verdict == Verdict::incomparable) out.graded.grade = Grade::off;
    out.comparison.reference = "POV-Ray " + povray_version(), out.comparison.test = "alidade";
}

/// Our picture of a scene that is read already.
tl::expected<Rendered, RenderFailure> render_here(const Scene& scene, const Request& request, const PovJob& job, const std::string& folder) {
    const auto failure = [](std::string sentence) { return tl::unexpected(RenderFailure{false, false, std::move(sentence)}); };
    const std::clock_t start = std::clock();
    Diagnostics said;
    const auto compiled = compile(scene, request.compile, said);
    if (!compiled) return failure(said.text());
    constexpr int kLightSamples = 64;   // POV-Ray's light of the sky has no noise: ours has little
    RenderOptions options;
    options.width = job.width, options.height = job.height, options.spp = 1, options.light_samples = kLightSamples, options.threads = 1;
    const auto film = render(*compiled, options);
    if (!film) return failure(film.error());
    const std::string picture = folder + "/picture.png";
    if (const auto written = write_film(picture, film->picture); !written) return failure(written.error());
    const Words command{"alidade", "render", request.scene, "-o", "picture.png", "--size", fmt::format("{}x{}", job.width, job.height), "--spp", "1", "--light-samples", std::to_string(kLightSamples)};
    return Rendered{picture, command, double(std::clock() - start) / CLOCKS_PER_SEC, false};
}

}  // namespace

SceneComparison compare_exported(const Request& request, const PovJob& job, const DiffRequest& diff) {
    SceneComparison out;
    out.job = job;
    const auto scratch = std::make_shared<Scratch>();
    out.scratch = scratch;
    const Loaded loaded = load(request);
    if (!loaded.scene) return fail_with(out, {false, false, loaded.said.text()}), out;
    PovJob exported = job;
    exported.scene = scratch->first.path() + "/exported/scene.pov";
    std::error_code ignored;
    std::filesystem::create_directories(scratch->first.path() + "/exported", ignored);
    const auto files = export_scene(*loaded.scene, exported.scene);
    if (!files) return fail_with(out, {false, true, files.error()}), out;
    out.lost = files->losses;
    const auto reference = povray_reference(exported, scratch->first.path());
    if (!reference) return fail_with(out, reference.error()), out;
    out.reference = *reference;
    const auto test = render_here(*loaded.scene, request, job, scratch->second.path());
    if (!test) return fail_with(out, test.error()), out;
    out.test = *test;
    compare_pictures(out, diff);
    return out;
}

SceneComparison compare_with_povray(const PovJob& job, const DiffRequest& request) {
    SceneComparison out;
    out.job = job;
    const auto scratch = std::make_shared<Scratch>();
    out.scratch = scratch;
    const auto reference = povray_reference(job, scratch->first.path());
    if (!reference) return fail_with(out, reference.error()), out;
    out.reference = *reference;
    const auto test = povray_test(job, scratch->second.path());
    if (!test) return fail_with(out, test.error()), out;
    out.test = *test;
    out.noisy = has_random_effects(job);
    compare_pictures(out, request);
    return out;
}

Json to_json(const SceneComparison& c) {
    Json out = to_json(c.comparison);
    out["scene"] = c.job.scene;
    out["grade"] = {{"name", name_of(c.graded.grade)}, {"rmse", c.graded.rmse}, {"over2", c.graded.over2}, {"envelope", c.graded.envelope}, {"noisy", c.noisy}};
    Json& lost = out["lost"] = Json::array();
    for (const Loss& loss : c.lost) lost.push_back({{"what", loss.what}, {"count", loss.count}, {"instead", loss.instead}});
    if (c.reference) out["reference_render"] = to_json(*c.reference);
    if (c.test) out["test_render"] = to_json(*c.test);
    return out;
}

std::string as_lines(const SceneComparison& c) {
    std::string out;
    for (const Loss& loss : c.lost) out += fmt::format("lost for POV-Ray: {} ({}){}\n", loss.what, loss.count, loss.instead.empty() ? "" : "; instead: " + loss.instead);
    if (c.reference) out += fmt::format("POV-Ray {}: {:.2f} CPU s{}\n", povray_version(), c.reference->cpu_seconds, c.reference->from_cache ? " (kept from before)" : "");
    if (c.test) out += fmt::format("alidade: {:.2f} CPU s\n", c.test->cpu_seconds);
    out += as_lines(c.comparison);
    if (c.test) out += fmt::format("grade: {}{}\n", name_of(c.graded.grade), c.noisy ? " (of a scene with random effects)" : "");
    return out;
}

}  // namespace alidade
