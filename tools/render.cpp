// SPDX-License-Identifier: Apache-2.0
#include "tools/interrupt.h"
#include "tools/json.h"
#include "tools/load.h"
#include "tools/output.h"
#include "tools/progress.h"
#include "tracer/render.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {

namespace {

struct RenderWords {
    Request request;
    std::string output, stats;
    ProgressMode progress = ProgressMode::bar;
    int bits = 8;
    bool json = false;
};

void add_output_options(CLI::App& app, RenderWords& words) {
    app.add_option("-o,--output", words.output, "the picture: .png, .exr, .pfm, .ppm or what OpenImageIO writes (default: the scene's name with .png, here)")
        ->type_name("FILE");
    add_choice(app, "--bits", {"8", "16"}, [&words](size_t i) { words.bits = i ? 16 : 8; }, "of a sample of a PNG or PPM file (default 8)");
    app.add_option("--stats", words.stats, "writes what the render cost, as JSON")->type_name("FILE.json");
    add_choice(app, "--progress", {"bar", "json", "none"}, [&words](size_t i) { words.progress = ProgressMode(i); },
               "a bar (only on a terminal), a line of JSON every 10 %, or nothing (default bar)");
    app.add_flag("--json", words.json, "prints what --stats writes");
}

Json cost(const RenderWords& words, const Prepared& prepared, const Film& film, const std::vector<std::string>& files) {
    const CompiledSummary built = summary(*prepared.scene);
    Json structures = Json::array();
    for (const auto& [name, stats] : built.structures) structures.push_back({{"name", name}, {"build", to_json(stats)}});
    return {{"scene", words.request.scene}, {"files", files}, {"width", film.picture.width}, {"height", film.picture.height},
            {"complete", film.complete}, {"kernel", built.kernel}, {"read_seconds", prepared.read_seconds},
            {"build_seconds", prepared.build_seconds}, {"compiled", to_json(built)}, {"structures", structures},
            {"render", to_json(film.stats)}, {"messages", to_json(prepared.said)}};
}

tl::expected<Film, std::string> render_watched(const CompiledScene& scene, const RenderWords& words) {
    const StopOnSignal signals;
    Progress progress(words.progress, stderr);
    Monitor monitor;
    monitor.progress = [&progress](size_t done, size_t tiles) { progress.update(done, tiles); };
    monitor.stop = &signals.stop();
    return render(scene, words.request.render, monitor);
}

int write_everything(const RenderWords& words, const Prepared& prepared, const Film& film) {
    const auto files = write_film(words.output, film.picture, words.bits);
    if (!files) return fail(fmt::format("{}: {}", words.output, files.error()));
    const std::string report = as_json_text(cost(words, prepared, film, *files));
    if (!words.stats.empty()) {
        if (const auto written = write_file(words.stats, std::as_bytes(std::span(report))); !written) return fail(fmt::format("{}: {}", words.stats, written.error()));
    }
    if (words.json) fmt::print("{}", report);
    fmt::print(stderr, "{}: {}x{}, read in {:.2f} s, built in {:.2f} s, rendered in {:.2f} s\n", words.output, film.picture.width, film.picture.height,
               prepared.read_seconds, prepared.build_seconds, film.stats.seconds);
    if (film.complete) return kDone;
    fmt::print(stderr, "alidade: interrupted after {} of {} tiles; the rest of the picture is black\n", film.stats.tiles_done, film.stats.tiles);
    return kInterrupted;
}

}  // namespace

int run_render(const Verb& verb, const Words& given) {
    RenderWords words;
    CLI::App app;
    add_scene_options(app, words.request);
    add_output_options(app, words);
    add_render_options(app, words.request);
    add_compile_options(app, words.request);
    if (const auto code = parse_words(app, verb, given)) return *code;
    if (words.output.empty()) words.output = std::filesystem::path(words.request.scene).filename().replace_extension(".png").string();
    if (const std::string why = why_not_writable(words.output); !why.empty()) return fail(why);
    if (const std::string why = words.stats.empty() ? "" : why_no_file(words.stats); !why.empty()) return fail("--stats: " + why);

    words.request.import.frame.image_width = words.request.render.width, words.request.import.frame.image_height = words.request.render.height;
    words.request.import.frame.clock = words.request.time.value_or(0);
    exit_on_signal();
    const Prepared prepared = prepare(words.request);
    fmt::print(stderr, "{}", prepared.said.text());
    if (!prepared.scene) return kError;
    const auto film = render_watched(*prepared.scene, words);
    if (!film) return usage_error(verb, film.error());
    return write_everything(words, prepared, *film);
}

}  // namespace alidade
