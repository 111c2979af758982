// SPDX-License-Identifier: Apache-2.0
/// `alidade povray`: a drop-in for POV-Ray in scripts.
#include "tools/file_gamma.h"
#include "tools/interrupt.h"
#include "tools/load.h"
#include "tools/output.h"
#include "tools/povray_words.h"
#include "tools/render_state.h"
#include "tools/scene_text.h"
#include "tools/verbs.h"
#include "tracer/compiled_scene.h"

#include "tracer/render.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace alidade {

namespace {

/// A scene's name may come without its ending, and from the library's folders.
std::string scene_path(const PovrayRequest& r) {
    namespace fs = std::filesystem;
    std::vector<fs::path> folders{""};
    for (const std::string& path : r.library_paths) folders.emplace_back(path);
    for (const fs::path& folder : folders)
        for (const char* ending : {"", ".pov", ".POV"})
            if (const std::string path = (folder / (r.input + ending)).string(); fs::is_regular_file(path)) return path;
    return fs::path(r.input).has_extension() ? r.input : r.input + ".pov";
}

Request request_of(const PovrayRequest& r, int frame) {
    Request request;
    request.scene = scene_path(r);
    request.import.format = "pov";
    request.import.include_paths = r.library_paths;
    request.import.include_paths.insert(request.import.include_paths.begin(), ".");   // POV-Ray's first place
    request.import.scene_folder_last = true;                                          // which is none of POV-Ray's
    request.import.header = r.header;
    request.import.declarations = r.declarations;
    request.import.version = r.version;
    request.import.write_folder = r.write_folder;
    request.import.limits = r.limits;
    request.import.quality = r.quality;
    request.compile.threads = r.threads;
    pov::FrameSettings& f = request.import.frame;
    f.image_width = r.width, f.image_height = r.height;
    f.clock = clock_of(r, frame);
    f.clock_on = r.animated() || r.clock_given;
    if (!r.animated()) return request;
    f.initial_clock = pov::six_digits(r.initial_clock), f.final_clock = pov::six_digits(r.final_clock);
    f.initial_frame = r.initial_frame, f.final_frame = r.final_frame + (r.cyclic ? 1 : 0), f.frame_number = frame;   // what would be the first again counts
    if (const double steps = clock_steps(r); steps > 0) f.clock_delta = pov::six_digits((r.final_clock - r.initial_clock) / steps);
    return request;
}

/// Columns and rows are counted from 1, or are shares of the picture if not greater than 1.
int first_pixel(double start, int size) { return start <= 0 ? 0 : start < 1 ? int(start * size) : int(start) - 1; }
int end_pixel(double end, int size) { return end <= 0 ? size : end <= 1 ? int(end * size) : int(end); }

/// What is wrong with the ends of a part of the picture, in the numbers that were given; "" if nothing is. POV-Ray takes a part without pixels, and writes a black picture.
std::string why_no_part(const char* of, char letter, double start, double end, int size) {
    const int first = first_pixel(start, size), last = end_pixel(end, size);
    if (first >= size) return fmt::format("+S{}{}: the picture has {} {}", letter, start, size, of);
    if (last > size) return fmt::format("+E{}{}: the picture has {} {}", letter, end, size, of);
    if (first >= last) return fmt::format("+S{0}{1} +E{0}{2}: of {3} {4} none is between them", letter, start, end, size, of);
    return {};
}

/// PNG, TGA and BMP files. EXR's alpha is associated; others have none.
bool has_straight_alpha(const PovrayRequest& r) { return std::string_view("NTB").find(r.file_type) != std::string_view::npos; }

/// What `scene` asks for, more than one sample with a lens, takes the place of antialiasing.
RenderOptions render_options(const PovrayRequest& r, int frame, const RenderSettings& scene) {
    RenderOptions options;
    options.width = r.width, options.height = r.height;
    options.threads = r.threads;
    options.frame = frame;
    options.seed = r.seed;
    if (r.alpha) options.alpha = has_straight_alpha(r) ? Alpha::straight : Alpha::associated;
    options.spp = scene.default_spp;
    options.lens_noise = scene.lens_noise;
    if (r.antialias && options.spp == 1) options.supersampling = Supersampling{r.sampling_method, r.antialias_threshold, r.antialias_gamma, r.jitter ? std::clamp(r.jitter_amount, 0.0, 1.0) : 0, r.antialias_depth};
    const Region region{first_pixel(r.start_column, r.width), first_pixel(r.start_row, r.height), end_pixel(r.end_column, r.width), end_pixel(r.end_row, r.height)};
    if (region.x0 || region.y0 || region.x1 != r.width || region.y1 != r.height) options.region = region;
    return options;
}

void warn(const std::string& sentence) { fmt::print(stderr, "alidade: warning: {}\n", sentence); }

/// A finished picture leaves no state: where there is one, the picture is not finished, or belongs to an earlier render.
bool done_already(const PovrayRequest& r, const std::string& output) {
    std::error_code ignored;
    return r.continued && r.writes_file() && std::filesystem::exists(output, ignored) && !std::filesystem::exists(state_name(output), ignored);
}

/// The picture is there in part. Without a state it is not written: the next `+C` would take it for a finished one.
int interrupted(const std::string& output, bool state) {
    fmt::print(stderr, "alidade: interrupted; {}\n", state ? fmt::format("+C goes on from {}", state_name(output)) : fmt::format("{} is not written", output));
    return kInterrupted;
}

/// What a frame says, by streams: what is not of `wanted`'s severity is not in it.
std::string text_of(const Diagnostics& said, Severity wanted) {
    std::string text;
    for (const Diagnostic& d : said.list())
        if (d.severity == wanted) text += said.text(d);
    return text;
}

/// Appends to the files of the streams that have one; "" or what went wrong.
std::string keep_messages(const PovrayRequest& r, const SceneText& scene, const Diagnostics& said, const std::string& done) {
    const std::string texts[kMessageStreams] = {scene.lines() + said.text() + done, scene.text(), text_of(said, Severity::error), done, done, text_of(said, Severity::warning)};
    for (size_t i = 0; i < kMessageStreams; ++i) {
        if (r.message_files[i].empty()) continue;
        std::ofstream out(r.message_files[i], std::ios::app);
        if (!(out << texts[i]).flush()) return fmt::format("'{}' cannot be written", r.message_files[i]);
    }
    return {};
}

/// Tells of a picture that is there.
int finished(const PovrayRequest& r, const std::string& output, const RenderStats& stats) {
    const std::string done = fmt::format("{}: {}x{}, rendered in {:.2f} s\n", output, r.width, r.height, stats.seconds);
    if (r.verbose) fmt::print(stderr, "{}", done);
    const std::string wrong = keep_messages(r, SceneText(false), {}, done);
    return wrong.empty() ? kDone : fail(wrong);
}

/// Scenes whose colours are codes already, as old ones without assumed_gamma, are written as they are.
std::optional<double> gamma_of_file(const PovrayRequest& r, const CompiledScene& scene) { return scene.scene.settings.srgb_coded ? std::nullopt : r.file_gamma; }

tl::expected<std::vector<std::byte>, std::string> bytes_of(const PovrayRequest& r, const CompiledScene& scene, const Picture& picture, const std::string& output) {
    const std::string ending = lower_ending(output);
    const int bits = r.bits > 8 ? 16 : 8;
    const auto gamma = gamma_of_file(r, scene);
    return gamma ? encode_with_gamma(picture, ending, bits, *gamma) : encode_picture(picture, ending, bits);
}

/// "" or what went wrong.
std::string write_output(const PovrayRequest& r, const CompiledScene& scene, const Picture& picture, const std::string& output) {
    if (!gamma_of_file(r, scene)) {
        const auto files = write_film(output, picture, r.bits > 8 ? 16 : 8);
        return files ? std::string() : files.error();
    }
    const auto bytes = bytes_of(r, scene, picture, output);
    if (!bytes) return bytes.error();
    const auto done = write_file(output, *bytes);
    return done ? std::string() : done.error();
}

/// A picture that leaves no file: POV-Ray's `+O-`, to stdout, and `-F`.
int render_without_file(const PovrayRequest& r, const CompiledScene& scene, const RenderOptions& options, const Monitor& monitor, const std::string& output) {
    const auto film = render(scene, options, monitor);
    if (!film) return fail(film.error());
    if (!film->complete) return interrupted(output, false);
    if (r.to_file) {
        const auto bytes = bytes_of(r, scene, film->picture, output);
        if (!bytes) return fail(bytes.error());
        if (std::fwrite(bytes->data(), 1, bytes->size(), stdout) != bytes->size() || std::fflush(stdout) != 0) return fail("the picture cannot be written to stdout");
    }
    return finished(r, output, film->stats);
}

/// Renders a picture that goes to the file `output`, and keeps its tiles beside it until it is there.
int render_to_file(const PovrayRequest& r, const CompiledScene& scene, const RenderOptions& options, Monitor monitor, const std::string& output) {
    const auto grid = tile_grid(options);
    if (!grid) return fail(grid.error());
    const auto state = RenderState::open(state_name(output), *grid, r.alpha ? 4 : 3, identity(scene, options), r.continued, warn);
    if (state) {
        monitor.recall = [&](size_t tile, Picture& picture) { return state->recall(tile, picture); };
        monitor.keep = [&](size_t tile, const Picture& picture) { state->keep(tile, picture); };
        if (state->known()) fmt::print(stderr, "{}: {} of {} tiles are known from {}\n", output, state->known(), grid->count(), state_name(output));
    }
    const auto film = render(scene, options, monitor);
    if (!film) return fail(film.error());
    if (!film->complete && !state) return interrupted(output, false);
    if (const std::string wrong = write_output(r, scene, film->picture, output); !wrong.empty()) return fail(fmt::format("{}: {}", output, wrong));
    if (!film->complete) return interrupted(output, true);
    if (state) state->remove();
    return finished(r, output, film->stats);
}

void warn_of_gamma(const PovrayRequest& r, const RenderSettings& settings) {
    if (r.file_gamma && settings.srgb_coded) warn("File_Gamma is not obeyed: the colours of this scene are codes already (no assumed_gamma, or srgb)");
}

int render_frame(const PovrayRequest& r, int frame) {
    const std::string output = output_name(r, frame);
    if (done_already(r, output)) return fmt::print(stderr, "{}: rendered already, and +C: skipped\n", output), kDone;
    if (const std::string wrong = r.writes_file() ? why_not_writable(output) : ""; !wrong.empty()) return fail(wrong);   // as POV-Ray, before it is rendered
    SceneText text(r.shows_scene_text);
    Request request = request_of(r, frame);
    request.import.print = [&](pov::TextStream where, const std::string& what) { text.print(where, what); };
    const Prepared prepared = prepare(request);
    text.end_line();
    fmt::print(stderr, "{}", prepared.said.text());
    if (const std::string wrong = keep_messages(r, text, prepared.said, ""); !wrong.empty()) return fail(wrong);
    if (!prepared.scene) return kError;
    warn_of_gamma(r, prepared.scene->scene.settings);
    const StopOnSignal signals;
    Monitor monitor;
    monitor.stop = &signals.stop();
    const RenderOptions options = render_options(r, frame, prepared.scene->scene.settings);
    return r.writes_file() ? render_to_file(r, *prepared.scene, options, std::move(monitor), output) : render_without_file(r, *prepared.scene, options, monitor, output);
}

int render_frames(const PovrayRequest& r) {
    if (!r.animated()) return render_frame(r, r.initial_frame);   // a subset is one of an animation's
    const auto [first, last] = subset_of(r);
    for (int64_t frame = first; frame <= last; frame += r.frame_step)
        if (const int code = render_frame(r, int(frame)); code != kDone) return code;
    return kDone;
}

std::string help(const Verb& verb) {
    return fmt::format("alidade {}\n\n{}\n\nThe words are POV-Ray's: +Iscene.pov +Oout.png +W320 +H240 +A<threshold> -A +AM<method> +R<depth> -J +L<folder> +FN +UA +Q<quality> +WT<threads> +C +K<clock> +KFI1 +KFF10 +SF +EF +SC +EC +SR +ER,\n"
                       "Key=Value, Declare=NAME=VALUE, scene.ini[section]. docs/pov-support.md lists what they do. Three are ours alone: --seed=N, other random numbers; --allow-write=DIR, where the scene may write;\n"
                       "--limit=NAME=N, what it may ask for (the option of `alidade render`).\n\nExit codes: {}.\n",
                       verb.usage, verb.doc, verb.exits);
}

}  // namespace

int run_povray(const Verb& verb, const Words& words) {
    if (!words.empty() && (words[0] == "--help" || words[0] == "-h")) {
        fmt::print("{}", help(verb));
        return kDone;
    }
    if (!words.empty() && (words[0] == "--version" || words[0] == "-version")) {
        fmt::print("alidade {} (POV-Ray 3.7's language and words)\n", ALIDADE_VERSION);
        return kDone;
    }
    const auto request = parse_povray_words(words);
    if (!request) return fail(request.error());
    for (const std::string& note : request->notes) fmt::print(stderr, "alidade: warning: {}\n", note);
    if (request->to_file && request->bits != 8 && request->bits != 16) fmt::print(stderr, "alidade: warning: {} bits a colour are asked for: PNG and PPM files have 8 or 16\n", request->bits);
    if (request->alpha && request->to_file && !has_straight_alpha(*request) && request->file_type != 'E')
        fmt::print(stderr, "alidade: warning: +UA (Output_Alpha): files of this type (+F{}) have no alpha, what is missing is black\n", request->file_type);
    for (const std::string& wrong : {why_no_part("columns", 'C', request->start_column, request->end_column, request->width), why_no_part("rows", 'R', request->start_row, request->end_row, request->height)})
        if (!wrong.empty()) return fail(wrong);
    exit_on_signal();
    for (const std::string& file : request->message_files)
        if (!file.empty() && !std::ofstream(file)) return fail(fmt::format("'{}' cannot be written", file));   // and is empty now
    return render_frames(*request);
}

}  // namespace alidade
