// SPDX-License-Identifier: Apache-2.0
#include "tools/options.h"

#include "accel/intersect.h"
#include "tools/option_words.h"
#include "topology/subdivide.h"
#include "tracer/render.h"
#include "tracer/sample_stop.h"
#include "tracer/sampler.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alidade {

namespace {

struct SkyWord {
    std::optional<Color> color;
    std::string file;
};

Value<SkyWord> parse_sky(const std::string& word) {
    if (word.empty() || word[0] != '#') return SkyWord{std::nullopt, word};
    return parse_color(word).map([](const Color& color) { return SkyWord{color, {}}; });
}

std::vector<std::string> isa_names() {
    std::vector<std::string> names{name(Isa::best)};
    for (const Isa isa : available_isas()) names.emplace_back(name(isa));
    return names;
}

/// The first word that no option took, as a sentence; empty if there is none.
std::string unknown_word(const CLI::App& app) {
    const std::vector<std::string> extras = app.remaining();
    if (extras.empty()) return {};
    const std::string word = extras[0].substr(0, extras[0].find('='));
    if (word.size() < 2 || word[0] != '-') return fmt::format("unexpected word '{}'", extras[0]);
    std::vector<std::string> options;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& known : option->get_lnames()) options.push_back("--" + known);
    const std::string near = nearest(word, options);
    return fmt::format("unknown option '{}'{}", word, near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

/// What is done to the meshes after reading.
void add_mesh_options(CLI::App& app, ReshapeOptions& reshape) {
    add_integer(app, "--subdivide", reshape.subdivide, 0, topology::kMostLevels,
                "times that each mesh is refined: by Catmull and Clark's rules if it has faces of more than three corners, else by Loop's (default 0)");
    add(app, "--decimate", "RATIO", [](const std::string& word) { return parse_number(word, kLeastRatio, 1); },
        [&reshape](double ratio) { reshape.decimate = ratio; }, "the part of each mesh's triangles that is kept, 1 being all (default 1)");
    add(app, "--crease", "DEGREES", [](const std::string& word) { return parse_number(word, 0, 180); },
        [&reshape](double degrees) { reshape.crease_degrees = degrees; },
        "meshes without normals are shaded smoothly over edges up to this angle (default: they are flat)");
}

}  // namespace

void add_choice(CLI::App& app, const char* option, std::vector<std::string> names, std::function<void(size_t)> store, const std::string& doc) {
    add(app, option, "NAME", [names](const std::string& word) { return one_of(word, names); }, store, fmt::format("{}: {}", doc, fmt::join(names, ", ")));
}

/// Each name with what it counts, as the table has it.
void add_limit_option(CLI::App& app, pov::Limits& limits) {
    std::string doc = "how much a POV scene may ask for; may be given more than once. Names:";
    for (const pov::LimitEntry& e : pov::limit_entries()) doc += fmt::format("\n  {} ({}): {}", e.name, pov::Limits().*e.value, e.doc);
    app.add_option_function<std::vector<std::string>>("--limit", [&limits](const std::vector<std::string>& words) {
        for (const std::string& word : words)
            if (const std::string why = pov::set_limit(limits, word); !why.empty()) throw CLI::ValidationError("--limit", why);
    }, doc)->type_name("NAME=N")->expected(1)->take_all();
}

void add_scene_options(CLI::App& app, Request& request) {
    app.add_option("SCENE", request.scene, "the scene's file")->type_name("FILE")->required();
    add_number(app, "--time", "T", -1e9, [&request](double t) { request.time = request.render.time = t; },
               "seconds into the scene's animations (default: nothing is posed)");
    add_choice(app, "--light-units", {"auto", "photometric", "raw"}, [&request](size_t i) { request.import.light_units = LightUnitsOption(i); },
               "what the file's light intensities are counted in (default auto)");
    app.add_flag("--strict", request.import.strict, "what the importer does not understand is an error, not a warning");
    app.add_option("-I", request.import.include_paths, "a folder where POV scenes' includes are looked for; may be given more than once")->type_name("DIR")->expected(1)->take_all();
    app.add_option("--declare", request.import.declarations, "a number that a POV scene finds declared; may be given more than once")->type_name("NAME=VALUE")->expected(1)->take_all();
    app.add_option("--allow-write", request.import.write_folder, "where a POV scene's #write may write (default: nowhere)")->type_name("DIR");
    add_limit_option(app, request.import.limits);
    add_mesh_options(app, request.reshape);
    group_options(app, "The scene");
}

void add_compile_options(CLI::App& app, Request& request) {
    std::vector<std::string> structures = names_of(accelerators());
    structures.insert(structures.begin(), "auto");
    add_choice(app, "--accel", structures, [&request, structures](size_t i) { request.compile.accel = structures[i]; }, "accelerator (default auto)");
    add_choice(app, "--precision", {"float", "double"}, [&request](size_t i) { request.compile.precision = Precision(i); },
               "of mesh vertices and nodes; rays and hits are double always (default float)");
    add_choice(app, "--intersect", names_of(intersects()), [&request](size_t i) { request.compile.intersect = intersects()[i].value; },
               "of rays and triangles (default exact; docs/accelerators.md says what the others give up, and gain)");
    const std::vector<std::string> isas = isa_names();
    const auto set_isa = [&request](size_t i) { request.compile.isa = i == 0 ? Isa::best : available_isas()[i - 1]; };
    add_choice(app, "--isa", isas, set_isa, "instructions of the triangle filter, of those that this machine has (default best)");
    add(app, "--environment", "#rgb|FILE", parse_sky, [&request](const SkyWord& sky) { request.compile.environment = sky.color, request.compile.environment_file = sky.file; },
        "a constant sky, or an equirectangular picture, instead of the scene's");
    app.add_flag("--lazy", request.compile.lazy, "a mesh's structure is built when the first ray enters its box; the picture does not depend on it");
    app.add_flag("--full-kernel", request.compile.full_kernel, "renders with every feature, needed or not: to measure what they cost; the picture does not depend on it");
    const auto set_threads = [&request](int64_t n) { request.compile.threads = request.render.threads = int(n); };
    add(app, "--threads", "N", [](const std::string& word) { return parse_integer(word, 0, 4096); }, set_threads,
        "0: as many as the machine has (default 0); the picture does not depend on it");
    group_options(app, "How its rays are answered");
}

void add_render_options(CLI::App& app, Request& request) {
    RenderOptions& render = request.render;
    add(app, "--size", "WxH", [](const std::string& word) { return parse_size(word); },
        [&render](const Size& size) { render.width = size.width, render.height = size.height; }, "of the picture, in pixels (default 640x480)");
    add(app, "--region", "x0,y0,x1,y1", [](const std::string& word) { return parse_region(word); }, [&render](const Region& r) { render.region = r; },
        "only these pixels; the rest stays black");
    app.add_option("--camera", render.camera, "a camera's name, or its number from 0 (default: the first)")->type_name("NAME");
    add_number(app, "--exposure", "EV", -1000, [&render](double ev) { render.exposure = ev; }, "colours are multiplied by 2^EV (default 0)");
    add_number(app, "--aperture", "D", 0, [&render](double d) { render.aperture = d; }, "diameter of the lens, world units; 0: a pinhole (default: the camera's)");
    add_number(app, "--focus", "D", 0, [&render](double d) { render.focus = d; }, "distance from the eye to the plane in focus, world units (default: the camera's)");
    const std::vector<std::string> known = names_of(integrators());
    add_choice(app, "--integrator", known, [&render, known](size_t i) { render.integrator = known[i]; }, "what a ray is asked (default whitted)");
    add_integer(app, "--spp", render.spp, 1, 1 << 20, "samples a pixel; 1: its centre (default: as the scene says)");
    add_number(app, "--adaptive", "ERROR", 0, [&render](double error) { render.adaptive = error; },
               fmt::format("a pixel ends after {} samples or more, --spp at the most, once the standard error of its displayed colour is below (1: black to white; default 0: none ends early)",
                           kLeastSamples));
    const std::vector<std::string> spreads = names_of(samplers());
    add_choice(app, "--sampler", spreads, [&render, spreads](size_t i) { render.sampler = spreads[i]; }, fmt::format("how samples are spread (default {})", render.sampler));
    add_integer(app, "--light-samples", render.light_samples, 1, 1 << 16, "shadow rays to each light with an extent, and to the sky (default 1)");
    add_integer(app, "--seed", render.seed, 0, INT64_MAX, "of the samples (default 0)");
    add_integer(app, "--max-depth", render.max_depth, 0, 1000, "recursion limit (default: as the scene says, else 8)");
    const std::vector<std::string> layers = names_of(aovs());
    const auto take_layers = [&render, layers](const std::vector<size_t>& chosen) {
        render.aovs.clear();
        for (const size_t i : chosen) render.aovs.push_back(layers[i]);
    };
    add(app, "--aov", "A,B", [layers](const std::string& word) { return list_of(word, layers); }, take_layers, fmt::format("output layers: {}", fmt::join(layers, ", ")));
    add_integer(app, "--tile", render.tile, 1, 4096, "edge of a tile in pixels (default 16); the picture does not depend on it");
    group_options(app, "The picture");
}

std::string why_not_parsed(CLI::App& app, const Words& words) {
    app.allow_extras();
    std::string sentence;
    try {
        app.parse(Words(words.rbegin(), words.rend()));   // CLI11 takes them from the back
    } catch (const CLI::CallForHelp&) {
        throw;
    } catch (const CLI::ParseError& error) {
        sentence = error.what();
    }
    const std::string unknown = unknown_word(app);   // a slip in an option's name is the cause of what else went wrong
    return unknown.empty() ? sentence : unknown;
}

std::optional<int> parse_words(CLI::App& app, const Verb& verb, const Words& words) {
    app.name(fmt::format("alidade {}", verb.name));
    app.description(fmt::format("alidade {}: {}", verb.usage, verb.doc));
    app.footer(fmt::format("Exit codes: {}.", verb.exits));
    try {
        const std::string sentence = why_not_parsed(app, words);
        if (sentence.empty()) return std::nullopt;
        return usage_error(verb, sentence);
    } catch (const CLI::CallForHelp&) {
        fmt::print("{}", app.help());
        return kDone;
    }
}

int usage_error(const Verb& verb, const std::string& sentence) {
    fmt::print(stderr, "alidade {}: {}\n", verb.name, sentence);
    return kUsage;
}

}  // namespace alidade
