// SPDX-License-Identifier: Apache-2.0
#include "core/float_mode.h"
#include "core/parallel.h"
#include "eval/texture_reads.h"
#include "tracer/cameras.h"
#include "tracer/layers.h"
#include "tracer/sample_stop.h"
#include "tracer/supersampling.h"
#include "tracer/textures.h"
#include "tracer/tiles.h"

#include <charconv>
#include <chrono>
#include <ctime>
#include <fmt/format.h>
#include <mutex>
#include <new>
#include <stdexcept>

namespace alidade {
namespace {

/// Everything that a tile needs and that does not change.
struct Job {
    const CompiledScene& scene;
    const RenderOptions& options;
    CameraRays camera;
    StartInside around;
    Radiance radiance;
    Layers layers;
    TileGrid grid;
    const SamplerEntry& sampler;
    int spp, max_depth;
    SampleStop sample_stop;
    const std::atomic<bool>* stop;
    std::optional<SignalId> normal;   ///< of the camera
    bool is_pov;                      ///< has it materials of POV scenes?

    bool stopped() const { return stop && stop->load(std::memory_order_relaxed); }
};

bool has_pov_materials(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return std::any_of(m.layers.begin(), m.layers.end(), [](const auto& layer) { return std::holds_alternative<PovFinish>(layer); });
    });
}

/// The first few by their numbers, and by their names if they have any.
std::string list_of_cameras(const CompiledScene& scene) {
    constexpr size_t kListed = 20;
    std::string list;
    for (size_t i = 0; i < std::min(scene.cameras.size(), kListed); ++i) {
        const std::string& name = scene.cameras[i].camera.name;
        list += fmt::format("{}{}{}", i ? ", " : "", i, name.empty() ? "" : fmt::format(" '{}'", name));
    }
    return scene.cameras.size() > kListed ? list + " ..." : list;
}

tl::expected<const Camera*, std::string> choose_camera(const CompiledScene& scene, const std::string& name) {
    if (name.empty()) return &scene.cameras.front().camera;
    for (const PlacedCamera& c : scene.cameras)
        if (c.camera.name == name) return &c.camera;
    size_t index = 0;
    const auto [end, bad] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (bad == std::errc() && end == name.data() + name.size() && index < scene.cameras.size()) return &scene.cameras[index].camera;
    return tl::unexpected(fmt::format("there is no camera '{}': the scene has {}, named or numbered {}", name, scene.cameras.size(), list_of_cameras(scene)));
}

/// The camera with the lens that the user asked for.
Camera with_lens(Camera camera, const RenderOptions& options) {
    if (options.aperture) camera.aperture = *options.aperture;
    if (options.focus) camera.focal_point = camera.location + normalized(camera.direction) * *options.focus;
    return camera;
}

tl::expected<Radiance, std::string> choose_kernel(const CompiledScene& scene, const std::string& name) {
    for (const Integrator& i : integrator_table())
        if (name == i.entry.name) return i.kernels[scene.features];
    return tl::unexpected(fmt::format("there is no integrator '{}': info --features lists them", name));
}

enum Dimension : uint64_t { kPixelDimension, kLensDimension };

RandomKey pixel_key(const Job& job, int x, int y) {
    const uint64_t index = uint64_t(int64_t(y) * job.options.width + x);   // beside the picture, too
    return {job.options.seed, uint64_t(job.options.frame), index};
}

/// Where in the pixel and on the lens a pixel's samples are, asked one after the other.
class SamplePlaces {
  public:
    SamplePlaces(const Job& job, RandomKey pixel) : job_(job), pixel_(pixel) {}

    struct Place {
        Vec2 in_pixel{0.5}, on_lens{0.5};
    };
    Place at(uint32_t sample) {
        const bool lens = job_.camera.has_lens();
        if (job_.spp == 1) return {Vec2(0.5), lens ? SampleKey(job_.sampler.pair, pixel_, 0, 1).pair(Coordinates::lens, kLensDimension) : Vec2(0.5)};
        const uint32_t k = sample % kSampleBlock;
        if (k == 0) fill(sample, lens);
        return {in_pixel_[k], lens ? on_lens_[k] : Vec2(0.5)};
    }

  private:
    void fill(uint32_t sample, bool lens) {
        sample_block(job_.sampler, SampleKey::domain(pixel_, Coordinates::pixel, kPixelDimension), sample, uint32_t(job_.spp), in_pixel_);
        if (lens) sample_block(job_.sampler, SampleKey::domain(pixel_, Coordinates::lens, kLensDimension), sample, uint32_t(job_.spp), on_lens_);
    }

    const Job& job_;
    const RandomKey pixel_;
    SampleBlock in_pixel_, on_lens_;
};

/// A camera's normal bends its rays as one of a surface would bend that surface's, at a point of the picture.
/// Source   POV-Ray 3.7 reference, 3.4.2.3.6 "Camera Ray Perturbation"; verified by probing.
void bend(const Job& job, const Vec2& at, Ray& ray) {
    const Vec3 dir = normalized(ray.dir), bent = job.scene.textures->bent(*job.normal, PatternFrame{Vec3(at.x, at.y, 0)}, dir);
    ray.dir = std::isnan(bent.x) ? dir : normalized(bent);
}

/// One camera ray through the point (x, y) of the picture and the point `on_lens` of the unit square, and what it brings.
Color take_ray(const Job& job, Tracing& tracing, const SampleKey& key, double x, double y, const Vec2& on_lens, PixelSamples& pixel) {
    RayState state;
    state.key = key;
    state.time = float(job.options.time);
    Ray ray = job.camera.at(x, y, on_lens);
    if (job.normal) bend(job, job.camera.bent_at(x, y), ray);
    ray.time = state.time;
    ++tracing.stats.camera_rays;
    FirstHit first;
    const bool beyond = ray.tmax < ray.tmin;   // the edge of a round picture, where there is nothing
    if (beyond) first.shows = 1;
    const Color radiance = beyond ? Color(0) : job.radiance(tracing, ray, state, first);
    pixel.add(radiance, first, first.hit ? job.scene.slots[first.slot].material : kNoId);
    return radiance;
}

uint64_t tests_done(const WorkCounters& work) { return work.boxes + work.filtered + work.primitives; }

/// All samples of a pixel: as many as asked for, or fewer where its own tell that it is known well enough. Nothing if the render was stopped.
std::optional<PixelSamples> sample_pixel(const Job& job, Tracing& tracing, int x, int y) {
    PixelSamples pixel;
    const RandomKey of_pixel = pixel_key(job, x, y);
    SamplePlaces places(job, of_pixel);
    NoiseEstimate noise, noise_of_alpha;
    const uint64_t before = tests_done(tracing.stats.work);
    for (int s = 0; s < job.spp; ++s) {
        if (job.stopped()) return std::nullopt;
        const double shown = pixel.sum.shows;
        const SamplePlaces::Place place = places.at(uint32_t(s));
        const Color radiance = take_ray(job, tracing, {job.sampler.pair, of_pixel, uint32_t(s), uint32_t(job.spp)}, x + place.in_pixel.x, y + place.in_pixel.y, place.on_lens, pixel);
        if (job.stopped()) return std::nullopt;
        if (!job.sample_stop.asks()) continue;
        noise.add(radiance);
        if (tracing.alpha) noise_of_alpha.add(Color(pixel.sum.shows - shown));
        if (pixel.samples < job.spp && job.sample_stop.enough(noise, pixel.samples) && (!tracing.alpha || job.sample_stop.enough(noise_of_alpha, pixel.samples))) {
            ++tracing.stats.pixels_ended_early;
            break;
        }
    }
    ++tracing.stats.pixels;
    pixel.work = tests_done(tracing.stats.work) - before;
    return pixel;
}

bool is_coded(const RenderSettings& settings) { return settings.srgb_coded || settings.assumed_gamma != 1; }

/// POV-Ray's scenes are calculated with in a coding of their own, which is undone at the end; films are linear.
Color linear(const Color& radiance, const RenderSettings& settings) {
    if (!is_coded(settings)) return radiance;
    Color out;
    for (int i = 0; i < 3; ++i) {
        const double coded = std::max(radiance[i], 0.0);
        out[i] = settings.srgb_coded ? srgb_to_linear(coded) : std::pow(coded, settings.assumed_gamma);
    }
    return out;
}

/// Linear, as a film has it; `shows`: what shows through, with Alpha::straight perhaps less when this is done.
Color in_film(const Color& radiance, Alpha alpha, const RenderSettings& settings, double& shows) {
    if (alpha != Alpha::straight) return linear(radiance, settings);
    const double covered = std::clamp(std::max(1 - shows, pov_grey(radiance)), 0.0, 1.0);
    shows = 1 - covered;
    return covered > 0 ? linear(radiance / covered, settings) * covered : linear(radiance, settings);
}

void write_pixel(const Job& job, PixelSamples pixel, int x, int y, Picture& picture) {
    const RenderSettings& settings = job.scene.scene.settings;
    const Color& sum = pixel.radiance;
    if (job.is_pov && (std::isnan(sum.x) || std::isnan(sum.y) || std::isnan(sum.z))) pixel.radiance = Color(0);   // a ray of it meets a surface without a normal (PovSurface): so POV-Ray's pictures have it
    if (is_coded(settings) || job.options.alpha == Alpha::straight) {
        const double count = pixel.samples;
        double shows = pixel.sum.shows / count;
        pixel.radiance = in_film(pixel.radiance / count, job.options.alpha, settings, shows) * count;
        pixel.sum.shows = shows * count;
    }
    job.layers.write(pixel, std::exp2(job.options.exposure), picture.at(x, y));
}

/// The pixels `tile` of a block. False if the render was stopped: then none of them is there.
bool render_block(const Job& job, Tracing& tracing, const Region& square, const Region& tile, Picture& picture) {
    BlockRays rays;
    rays.take = [&](const PixelRay& r) {
        const SampleKey key{job.sampler.pair, pixel_key(job, r.x, r.y), r.index, r.count};
        const Vec2 moved = r.jitter > 0 ? (key.pair(Coordinates::pixel, kPixelDimension) - Vec2(0.5)) * r.jitter : Vec2(0);
        const uint64_t before = tests_done(tracing.stats.work);
        PixelSamples out;
        take_ray(job, tracing, key, r.x + r.at.x + moved.x, r.y + r.at.y + moved.y, job.camera.has_lens() ? key.pair(Coordinates::lens, kLensDimension) : Vec2(0.5), out);
        out.work = tests_done(tracing.stats.work) - before;
        return out;
    };
    const RenderSettings& settings = job.scene.scene.settings;
    rays.comparable = [&](const Color& c) { return settings.srgb_coded ? c : linear(c, settings); };   // as POV-Ray does where no gamma is assumed
    rays.stopped = [&] { return job.stopped(); };
    const auto pixels = supersample(*job.options.supersampling, square, tile, rays);
    if (!pixels || job.stopped()) return false;
    auto pixel = pixels->begin();
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) write_pixel(job, *pixel++, x, y, picture);
    tracing.stats.pixels += pixels->size();
    return true;
}

/// A tile's pixels depend on nothing but their own coordinates, so neither the order of tiles nor their size shows. False if the render was stopped:
/// the pixel under way, and those after it, are left as they are.
bool render_tile(const Job& job, size_t i, Picture& picture, RenderStats& stats) {
    const DefaultFloatMode mode;
    Tracing tracing{job.scene, job.around, job.max_depth, job.options.light_samples, job.scene.scene.settings.adc_bailout, job.options.alpha != Alpha::none, job.layers.any(), stats};
    tracing.stop = job.stop;
    const Region tile = job.grid.tile(i);
    if (job.options.supersampling) return render_block(job, tracing, job.grid.square(i), tile, picture);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::optional<PixelSamples> pixel = sample_pixel(job, tracing, x, y);
            if (!pixel) return false;
            write_pixel(job, *pixel, x, y, picture);
        }
    return true;
}

void add(RenderStats& sum, const RenderStats& b) {
    sum.camera_rays += b.camera_rays;
    sum.shadow_rays += b.shadow_rays;
    sum.secondary_rays += b.secondary_rays;
    sum.pixels += b.pixels;
    sum.pixels_ended_early += b.pixels_ended_early;
    sum.work += b.work;
    sum.texture_reads += b.texture_reads;
}

/// Of one pixel and light: samples are numbered in 32 bits.
constexpr int64_t kMostSamples = int64_t(1) << 31;

/// Renders all tiles; false if stopped early. Costs are whole numbers: their sum does not depend on the order.
bool run(const Job& job, const Monitor& monitor, Film& film) {
    const size_t tiles = job.grid.count();
    std::mutex mutex;
    size_t done = 0;
    parallel_for(tiles, job.options.threads, [&](size_t tile) {
        if (job.stopped()) return;
        RenderStats stats;
        const bool known = monitor.recall && monitor.recall(tile, film.picture);
        const uint64_t read_before = texture_reads;
        const bool whole = known || render_tile(job, tile, film.picture, stats);
        stats.texture_reads = texture_reads - read_before;
        if (whole && !known && monitor.keep) monitor.keep(tile, film.picture);
        const std::lock_guard lock(mutex);
        add(film.stats, stats);
        if (!whole) return;
        ++done;
        if (monitor.progress) monitor.progress(done, tiles);
    });
    film.stats.tiles = tiles;
    film.stats.tiles_done = done;
    return done == tiles;
}

/// Throws what names the picture and its size.
Picture empty_picture(const RenderOptions& options, const std::vector<std::string>& channels) try {
    return Picture(options.width, options.height, channels);
} catch (const std::bad_alloc&) {
    const double bytes = double(options.width) * options.height * double(channels.size() * sizeof(float));
    throw std::runtime_error(fmt::format("out of memory: a picture of {}x{} pixels with {} channels takes {:.1f} GB; ask for a smaller one, or for fewer layers", options.width, options.height, channels.size(), bytes / 1e9));
}

}  // namespace

tl::expected<Film, std::string> render(const CompiledScene& scene, const RenderOptions& options, const Monitor& monitor) {
    const auto grid = tile_grid(options);
    if (!grid) return tl::unexpected(grid.error());
    const auto camera = choose_camera(scene, options.camera);
    if (!camera) return tl::unexpected(camera.error());
    const auto kernel = choose_kernel(scene, options.integrator);
    if (!kernel) return tl::unexpected(kernel.error());
    auto layers = Layers::parse(options.aovs, options.alpha != Alpha::none);
    if (!layers) return tl::unexpected(layers.error());
    const SamplerEntry* sampler = find_sampler(options.sampler);
    if (!sampler) return tl::unexpected(fmt::format("there is no sampler '{}': info --features lists them", options.sampler));
    const int spp = options.spp ? options.spp : scene.scene.settings.default_spp;
    if (int64_t(spp) * options.light_samples > kMostSamples)
        return tl::unexpected(fmt::format("{} samples a pixel times {} a light are more than {}", spp, options.light_samples, kMostSamples));
    const int depth = options.max_depth >= 0 ? options.max_depth : scene.scene.settings.max_depth.value_or(8);
    const Camera seen_by = with_lens(**camera, options);
    const Job job{scene, options, CameraRays(seen_by, options.width, options.height), StartInside(scene, seen_by), *kernel, *layers, *grid, *sampler, spp, depth, SampleStop(options, spp), monitor.stop, (**camera).normal, has_pov_materials(scene.scene)};
    Film film;
    film.picture = empty_picture(options, layers->channels());
    if (options.alpha != Alpha::none)   // what is not rendered is black, not missing
        for (size_t i = 3; i < film.picture.values.size(); i += size_t(film.picture.channels)) film.picture.values[i] = 1;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    film.complete = run(job, monitor, film);
    film.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    film.stats.cpu_seconds = double(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    return film;
}

}  // namespace alidade
