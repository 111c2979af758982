// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/compare_scene.h"

#include "exporters/exporter.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tools/compare/objects.h"
#include "tools/compare/povray_reference.h"
#include "tools/compare/program.h"
#include "tools/output.h"
#include "tools/povray_words.h"
#include "tools/report/report.h"
#include "tools/values.h"
#include "tracer/render.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>

namespace alidade {

namespace fs = std::filesystem;

namespace {

/// Both programs' pictures are made of random numbers, which are not the same ones.
bool is_random(const Scene& scene, const Diagnostics& said) {
    for (const RequiredBy& each : requirements(scene))
        if (each.what == Requirement::area_lights || each.what == Requirement::depth_of_field || each.what == Requirement::media) return true;
    for (const Material& material : scene.materials)
        for (const auto& layer : material.layers)
            if (const auto* finish = std::get_if<PovFinish>(&layer); finish && finish->crand > 0) return true;
    for (const Diagnostic& message : said.list())
        for (const char* word : {"radiosity", "photons", "media", "subsurface"})
            if (message.message.find(word) != std::string::npos) return true;
    return false;
}

/// A scene of POV-Ray, as its words have it read.
tl::expected<Request, std::string> povray_reading(const CompareJob& job) {
    const auto words = parse_povray_words(povray_words(job, "none.png"));
    if (!words) return tl::unexpected(words.error());
    Request out;
    const fs::path folder = fs::path(job.scene).parent_path();
    for (const std::string& path : words->library_paths) out.import.include_paths.push_back((folder / path).string());   // an absolute one stays as it is
    out.import.declarations = words->declarations;
    out.import.frame.clock = clock_of(*words, subset_of(*words).first);
    return out;
}

/// The scene again as our program reads it; nothing where that fails.
std::optional<Imported> read_as_povray(const CompareJob& job) {
    auto reading = povray_reading(job);
    if (!reading) return std::nullopt;
    reading->import.frame.image_width = job.width, reading->import.frame.image_height = job.height;
    auto imported = import_scene(job.scene, reading->import);
    return imported ? std::optional(std::move(*imported)) : std::nullopt;
}

void fail_with(SceneComparison& out, const RenderFailure& failure) {
    out.missing_program = failure.missing;
    out.comparison.judgement = {Verdict::error, failure.sentence, {}};
    out.comparison.cause = {failure.missing ? "missing" : failure.reference ? "reference" : "render", failure.sentence};
}

Json to_json(const Rendered& rendered) {
    return {{"command", shell_line(rendered.command)}, {"cpu_seconds", rendered.cpu_seconds}, {"from_cache", rendered.from_cache}};
}

using Scratch = std::pair<ScratchFolder, ScratchFolder>;   // the reference's, and ours

/// Antialiasing moves its rays at random, unless it is told not to.
bool is_jittered(const CompareJob& job) {
    const auto words = parse_povray_words(povray_words(job, "none.png"));
    return words && words->antialias && words->jitter;
}

std::string as_title(const ReferenceProgram& program) { return fmt::format("{} {}", program.title, program.version()); }

void compare_pictures(SceneComparison& out, const DiffRequest& request) {
    out.comparison = compare_files(out.reference->picture, out.test->picture, request);
    const bool measured = out.comparison.loaded && !out.comparison.measured.empty();
    if (measured) out.graded = grade(out.comparison.loaded->pair, out.noisy);
    else if (out.comparison.judgement.verdict == Verdict::incomparable) out.graded.grade = Grade::off;
    if (measured && out.job.seeds > 1) {
        auto seeds = compare_seeds(*out.reference, *out.test, out.noisy || is_jittered(out.job), request, out.comparison);
        if (!seeds) return fail_with(out, {false, false, seeds.error()});
        out.seeds = std::move(*seeds);
    }
    out.comparison.reference = as_title(*out.job.against), out.comparison.test = "alidade";
}

/// Our pictures of a scene that is compiled already, one of each seed.
tl::expected<Rendered, RenderFailure> render_here(const CompiledScene& scene, const CompareJob& job, const std::string& folder) {
    const auto failure = [](std::string sentence) { return tl::unexpected(RenderFailure{false, false, std::move(sentence)}); };
    const std::clock_t start = std::clock();
    constexpr int kLightSamples = 64;   // a pixel: POV-Ray's light of the sky has no noise, ours has little
    RenderOptions options;
    options.width = job.width, options.height = job.height, options.spp = job.spp, options.light_samples = std::max(1, kLightSamples / job.spp), options.threads = 1;
    Rendered out;
    for (int seed = 0; seed < job.seeds; ++seed) {
        options.seed = uint64_t(seed);
        const auto film = render(scene, options);
        if (!film) return failure(film.error());
        const std::string picture = fmt::format("{}/picture{}{}", folder, seed, job.against->ending);
        if (const auto written = write_film(picture, film->picture); !written) return failure(written.error());
        (seed ? out.more.emplace_back() : out.picture) = picture;
    }
    out.command = {"alidade", "render", job.scene, "-o", std::string("picture") + job.against->ending, "--size", fmt::format("{}x{}", job.width, job.height), "--spp", fmt::format("{}", job.spp),
                   "--light-samples", fmt::format("{}", options.light_samples)};
    out.cpu_seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    return out;
}

/// How the scene is read: as POV-Ray's words say if it is a scene of POV-Ray and there are any.
tl::expected<Request, std::string> final_reading(Request reading, const CompareJob& job) {
    if (is_povray_scene(job.scene) && !job.words.empty()) {
        const auto words = povray_reading(job);
        if (!words) return words;
        reading.import.include_paths = words->import.include_paths, reading.import.declarations = words->import.declarations, reading.import.frame = words->import.frame;
    }
    reading.scene = job.scene;
    reading.import.frame.image_width = job.width, reading.import.frame.image_height = job.height;
    return reading;
}

/// None where words of POV-Ray's made the pictures smaller than they were asked for.
void find_objects(const CompiledScene& scene, const PairOptions& pair, SceneComparison& out) {
    if (!out.comparison.loaded) return;
    const int width = out.job.width, height = out.job.height;
    ReportObjects objects = objects_seen(scene, width, height);
    if (pair.x0 && *pair.x1 <= width && *pair.y1 <= height) objects = cropped(objects, width, *pair.x0, *pair.y0, *pair.x1, *pair.y1);
    if (objects.index.size() == out.comparison.loaded->pair.pixels()) out.objects = std::move(objects);
}

void compare_exported(const Request& given, SceneComparison& out, const Scratch& scratch, const DiffRequest& diff) {
    const auto reading = final_reading(given, out.job);
    if (!reading) return fail_with(out, {false, false, reading.error()});
    Loaded loaded = load(*reading);
    if (!loaded.scene) return fail_with(out, {false, false, loaded.said.text()});
    loaded.scene->animations.clear();   // what has been posed stands; a program that plays them would show another moment
    CompareJob exported = out.job;
    const std::string& folder = scratch.first.path();
    exported.scene = fmt::format("{}/exported/{}", folder, out.job.against->exported);
    std::error_code ignored;
    fs::create_directories(folder + "/exported", ignored);
    const auto files = export_scene(*loaded.scene, exported.scene);
    if (!files) return fail_with(out, {false, true, files.error()});
    out.lost = files->losses;
    out.noisy = out.job.against->random || is_random(*loaded.scene, loaded.said);
    Diagnostics said;
    const auto compiled = compile(std::move(*loaded.scene), reading->compile, said);
    if (!compiled) return fail_with(out, {false, false, said.text()});
    const auto reference = out.job.against->render(exported, *compiled, folder);
    if (!reference) return fail_with(out, reference.error());
    out.reference = *reference;
    const auto test = render_here(*compiled, out.job, scratch.second.path());
    if (!test) return fail_with(out, test.error());
    out.test = *test;
    compare_pictures(out, diff);
    out.materials = compare_materials(*compiled, files->materials, out.comparison, out.job.width, out.job.height);
    if (out.job.objects) find_objects(*compiled, diff.pair, out);
}

void compare_with_povray(SceneComparison& out, const Scratch& scratch, const DiffRequest& request) {
    const auto reference = povray_reference(out.job, scratch.first.path());
    if (!reference) return fail_with(out, reference.error());
    out.reference = *reference;
    const auto test = povray_test(out.job, scratch.second.path());
    if (!test) return fail_with(out, test.error());
    out.test = *test;
    auto read = read_as_povray(out.job);
    out.noisy = read && is_random(read->scene, read->diagnostics);
    compare_pictures(out, request);
    if (!read || !out.job.objects) return;
    Diagnostics said;
    if (const auto compiled = compile(std::move(read->scene), CompileOptions(), said)) find_objects(*compiled, request.pair, out);
}

}  // namespace

bool is_povray_scene(const std::string& path) {
    return lower(fs::path(path).extension().string()) == ".pov";
}

int exit_code(const SceneComparison& compared) {
    const Verdict verdict = compared.comparison.judgement.verdict;
    return int(verdict == Verdict::error && !compared.missing_program ? Verdict::fail : verdict);
}

SceneComparison compare_scene(const Request& reading, const CompareJob& job, const DiffRequest& request) {
    SceneComparison out;
    out.job = job;
    if (out.job.spp == 0) out.job.spp = job.against->spp;
    const auto scratch = std::make_shared<Scratch>();
    out.scratch = scratch;
    if (const std::string why = why_missing(*job.against); !why.empty()) fail_with(out, {true, true, why});
    else if (job.against->version == povray_version && is_povray_scene(job.scene)) compare_with_povray(out, *scratch, request);
    else compare_exported(reading, out, *scratch, request);
    return out;
}

Json to_json(const SceneComparison& c) {
    Json out = to_json(c.comparison);
    out["exit_code"] = exit_code(c);
    out["scene"] = c.job.scene, out["against"] = c.job.against->name;
    if (c.seeds) out["noise"] = to_json(*c.seeds);
    out["grade"] = {{"name", name_of(c.graded.grade)}, {"rmse", c.graded.rmse}, {"over2", c.graded.over2}, {"envelope", c.graded.envelope}, {"noisy", c.noisy}};
    Json& lost = out["lost"] = Json::array();
    for (const Loss& loss : c.lost) lost.push_back({{"what", loss.what}, {"count", loss.count}, {"instead", loss.instead}});
    if (c.materials) put_into(out, *c.materials);
    if (c.reference) out["reference_render"] = to_json(*c.reference);
    if (c.test) out["test_render"] = to_json(*c.test);
    return out;
}

std::string as_lines(const SceneComparison& c) {
    std::string out;
    for (const Loss& loss : c.lost) out += fmt::format("lost for {}: {} ({}){}\n", c.job.against->title, loss.what, loss.count, loss.instead.empty() ? "" : "; instead: " + loss.instead);
    if (c.reference) out += fmt::format("{}: {:.2f} CPU s{}\n", as_title(*c.job.against), c.reference->cpu_seconds, c.reference->from_cache ? " (kept from before)" : "");
    if (c.test) out += fmt::format("alidade: {:.2f} CPU s\n", c.test->cpu_seconds);
    if (c.materials) out += as_lines(*c.materials);
    if (c.seeds) out += as_lines(*c.seeds);
    out += as_lines(c.comparison);
    if (c.test) out += fmt::format("grade: {}{}\n", name_of(c.graded.grade), c.noisy ? " (of a scene with random effects)" : "");
    return out;
}

}  // namespace alidade
