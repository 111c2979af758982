// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/renderer.h"

#include "tools/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace alidade::tradeoff {
namespace {

constexpr size_t kMostScenes = 16;   // that are kept

double cpu_now() { return double(std::clock()) / CLOCKS_PER_SEC; }

Picture colors_of(const Picture& film) {
    Picture out(film.width, film.height, {"R", "G", "B"});
    for (size_t p = 0; p < out.values.size() / 3; ++p) std::copy_n(&film.values[p * size_t(film.channels)], 3, &out.values[3 * p]);
    return out;
}

}  // namespace

void Renderer::say(const Diagnostics& said) {
    const std::string text = said.text();
    if (!text.empty() && !std::exchange(said_[text], true)) fmt::print(stderr, "{}", text);
}

Value<std::shared_ptr<const Scene>> Renderer::scene(const Request& request, const std::string& reading) {
    if (const auto found = scenes_.find(reading); found != scenes_.end()) return found->second;
    Request shown = request;
    shown.import.shown_only = true;
    Loaded loaded = load(shown);
    say(loaded.said);
    if (!loaded.scene) return tl::unexpected(std::string());
    const auto scene = std::make_shared<const Scene>(std::move(*loaded.scene));
    if (scenes_.size() < kMostScenes) scenes_[reading] = scene;
    return scene;
}

Value<std::shared_ptr<const CompiledScene>> Renderer::compiled(const Request& request, const std::string& reading) {
    const auto read = scene(request, reading);
    if (!read) return tl::unexpected(read.error());
    Diagnostics said;
    auto out = compile(**read, request.compile, said);
    say(said);
    if (!out) return tl::unexpected(std::string());
    return out;
}

Value<Run> Renderer::run(const Request& request, const std::string& reading, const Monitor& monitor) {
    const auto read = scene(request, reading);
    if (!read) return tl::unexpected(read.error());
    Scene copy = **read;
    Diagnostics said;
    Run out;
    const double start = cpu_now();
    const auto built = compile(std::move(copy), request.compile, said);
    out.build_seconds = cpu_now() - start;
    say(said);
    if (!built) return tl::unexpected(std::string());
    auto film = render(*built, request.render, monitor);
    if (!film) return tl::unexpected(film.error());
    out.picture = colors_of(film->picture);
    out.stats = film->stats;
    return out;
}

}  // namespace alidade::tradeoff
