// SPDX-License-Identifier: Apache-2.0
/// What settings are measured against.
#include "tools/analytic.h"
#include "tools/tradeoff/experiment.h"

#include "core/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace alidade::tradeoff {
namespace {

/// Options of which the reference takes the best that is varied: a visible table. Others stay as they are by default.
struct Best {
    const char* name;
    enum class Is { largest, double_, absent } is;
};
constexpr Best kBest[] = {
    {"max-depth", Best::Is::largest}, {"light-samples", Best::Is::largest}, {"decimate", Best::Is::largest}, {"subdivide", Best::Is::largest},
    {"precision", Best::Is::double_}, {"adaptive", Best::Is::absent},       {"threads", Best::Is::absent},   {"spp", Best::Is::absent},
    {"seed", Best::Is::absent},     {"intersect", Best::Is::absent},
};

/// POV-Ray's own antialiasing at its finest: 49 samples in each pixel.
constexpr const char* kPovray = "povray +I{scene} +L{folder} +W{width} +H{height} +A0.0 +AM1 +R7 -J +FN16 +WT1 -D -P +O{out}";

constexpr int kFewestSamples = 64, kMostSamples = 1024;

/// Samples of each half: four times those of the finest setting, within limits.
int default_samples(const std::vector<Row>& rows) {
    int most = 1;
    for (const Row& row : rows) most = std::max(most, row.request.render.spp);
    return std::max(most, int(std::clamp<int64_t>(4 * int64_t(most), kFewestSamples, kMostSamples)));
}

/// "self:256" -> 256; 0: none of these.
Value<int> own_samples(const Job& job, const std::vector<Row>& rows) {
    if (job.reference.empty() || job.reference == "self") return default_samples(rows);
    if (!job.reference.starts_with("self:")) return 0;
    const auto samples = parse_integer(std::string_view(job.reference).substr(5), 2, 1 << 20);
    if (!samples) return tl::unexpected(fmt::format("--reference: {}", samples.error()));
    return int(*samples);
}

bool is_exact(const Job& job) { return find_analytic(job.scene) && (job.reference.empty() || job.reference == "exact"); }

Setting best_options(const Job& job) {
    Setting options = job.base;
    for (const Best& best : kBest) {
        std::vector<std::string> values;
        for (const Axis& axis : job.axes)
            if (axis.name == best.name) values = axis.values;
        const bool varied = !values.empty();
        if (best.is == Best::Is::absent || varied) std::erase_if(options, [&](const Choice& choice) { return choice.name == best.name; });
        if (!varied || best.is == Best::Is::absent) continue;
        const auto number = [](const std::string& value) { return parse_number(value, -kInf).value_or(0); };
        const std::string largest = *std::max_element(values.begin(), values.end(), [&](const std::string& a, const std::string& b) { return number(a) < number(b); });
        options.push_back({best.name, best.is == Best::Is::double_ ? "double" : largest});
    }
    return combined(options, job.reference_with);
}

/// Seeds that no setting has.
std::array<uint64_t, 2> other_seeds(const Job& job, const std::vector<Row>& rows) {
    std::set<uint64_t> used;
    for (const Row& row : rows)
        for (int i = 0; i < job.seeds; ++i) used.insert(row.request.render.seed + uint64_t(i));
    uint64_t next = 1000003;
    const auto unused = [&] {
        while (used.contains(next)) ++next;
        return next++;
    };
    const uint64_t first = unused();
    return {first, unused()};
}

Value<Setting> own_options(const Job& job, const std::vector<Row>& rows) {
    const auto samples = own_samples(job, rows);
    if (!samples) return tl::unexpected(samples.error());
    Setting options = best_options(job);
    const bool told = std::any_of(options.begin(), options.end(), [](const Choice& choice) { return choice.name == "spp"; });
    if (!told) options.push_back({"spp", std::to_string(*samples)});
    if (const auto parsed = parse_request(job.scene, options); !parsed) return tl::unexpected(fmt::format("--reference-with: {}", parsed.error()));
    return options;
}

Value<Reference> own_reference(const Job& job, const std::vector<Row>& rows, Renderer& renderer, bool clip) {
    const auto options = own_options(job, rows);
    if (!options) return tl::unexpected(options.error());
    Reference out;
    Picture halves[2];
    const auto seeds = other_seeds(job, rows);
    Progress progress(job.progress, stderr);
    for (size_t i = 0; i < 2; ++i) {
        auto request = parse_request(job.scene, *options);
        request->render.seed = seeds[i];
        Monitor monitor;
        monitor.progress = [&progress, i](size_t done, size_t tiles) { progress.update(i * tiles + done, 2 * tiles); };
        auto run = renderer.run(*request, reading_of(*options), monitor);
        if (!run) return tl::unexpected(run.error());
        halves[i] = std::move(run->picture);
    }
    out.own = errors_of_halves(halves[0], halves[1], clip);
    out.picture = halves[0];
    for (size_t i = 0; i < out.picture.values.size(); ++i) out.picture.values[i] = 0.5F * (halves[0].values[i] + halves[1].values[i]);
    out.what = *reference_name(job, rows);
    return out;
}

/// A number that a file of `levels` steps rounds lies anywhere within a step: the variance is a twelfth of its square.
double rounding_error(const Picture& picture, uint32_t levels) {
    double sum = 0;
    for (const float value : picture.values) {
        const double code = linear_to_srgb(std::clamp(double(value), 0.0, 1.0)), half = 0.5 / levels;
        const double step = srgb_to_linear(std::min(code + half, 1.0)) - srgb_to_linear(std::max(code - half, 0.0));
        sum += step * step / 12;
    }
    return std::sqrt(sum / double(std::max<size_t>(picture.values.size(), 1)));
}

Value<Reference> of_file(const std::string& path, const std::string& what) {
    auto file = read_linear(path);
    if (!file) return tl::unexpected(fmt::format("the reference {}", file.error()));
    Reference out{what, std::move(file->picture), {}, file->levels > 0};
    if (file->levels > 0) out.own["rmse"] = rounding_error(out.picture, file->levels);
    return out;
}

Value<Reference> of_povray(const Job& job, const RenderOptions& render, const std::string& what) {
    auto run = run_external(*parse_external(kPovray), {}, {job.scene, render.width, render.height, job.timeout});
    if (!run) return tl::unexpected(run.error());
    Reference out{what, std::move(run->picture), {}, run->display};
    return out;
}

Value<Reference> made(const Job& job, const std::vector<Row>& rows, Renderer& renderer, bool clip) {
    const RenderOptions& render = rows[0].request.render;
    const std::string what = *reference_name(job, rows);
    if (is_exact(job)) return Reference{what, analytic_picture(*find_analytic(job.scene), render.width, render.height), {}, false};
    if (*own_samples(job, rows) > 0) return own_reference(job, rows, renderer, clip);
    return job.reference == "povray" ? of_povray(job, render, what) : of_file(job.reference, what);
}

/// A picture with more than 8 bits, for the next run.
std::string kept_in(const Store& store) { return store.folder() + "/reference.pfm"; }

}  // namespace

bool is_usual_reference(const Job& job) { return !is_exact(job) && (job.reference.empty() || job.reference == "self"); }

bool is_reference_file(const Job& job) {
    return !job.reference.empty() && job.reference != "exact" && job.reference != "povray" && job.reference != "self" && !job.reference.starts_with("self:");
}

Value<std::string> reference_name(const Job& job, const std::vector<Row>& rows) {
    if (is_analytic(job.scene) && !find_analytic(job.scene)) return std::string();   // which the renderer tells of
    if (is_exact(job)) return std::string("the closed form");
    if (job.reference == "exact") return tl::unexpected(std::string("--reference exact: only scenes analytic:NAME have one"));
    if (job.reference == "povray" && !job.scene.ends_with(".pov")) return tl::unexpected(std::string("--reference povray: this is no scene of POV-Ray; write one with alidade convert"));
    if (job.reference == "povray") return std::string("POV-Ray with 49 samples a pixel (+A0.0 +AM1 +R7)");
    const auto samples = own_samples(job, rows);
    if (!samples) return tl::unexpected(samples.error());
    if (*samples == 0) return fmt::format("the file {}", job.reference);
    const auto options = own_options(job, rows);
    if (!options) return tl::unexpected(options.error());
    std::string words;
    for (const std::string& word : as_words(*options)) words += " " + word;
    return fmt::format("the mean of two pictures of ours with{}", words);
}

Value<Reference> make_reference(const Job& job, const std::vector<Row>& rows, Renderer& renderer, Store& store, bool clip) {
    const RenderOptions& render = rows[0].request.render;
    Reference before;
    const auto take = [&before](const Json& known) {
        before.what = known.at("what").get<std::string>(), before.display = known.at("display").get<bool>();
        for (const auto& [name, value] : known.at("own").items()) before.own[name] = value.get<double>();
    };
    if (store.read("reference", take))
        if (auto file = read_linear(kept_in(store))) return before.picture = std::move(file->picture), before;
    auto out = made(job, rows, renderer, clip);
    if (!out) return out;
    if (out->picture.width != render.width || out->picture.height != render.height)
        return tl::unexpected(fmt::format("{} has {} x {} pixels, the settings' pictures have {} x {} (--size)", out->what, out->picture.width, out->picture.height, render.width, render.height));
    if (store.folder().empty()) return out;
    if (const auto written = write_picture(kept_in(store), out->picture); !written) return tl::unexpected(fmt::format("{}: {}", kept_in(store), written.error()));
    if (const auto kept = store.keep("reference", {{"what", out->what}, {"display", out->display}, {"own", out->own}}); !kept) return tl::unexpected(kept.error());
    return out;
}

}  // namespace alidade::tradeoff
