// SPDX-License-Identifier: Apache-2.0
/// What a user can ask of a render. The command line has one option for each; `tradeoff --vary` takes the same names.
#pragma once

#include "accel/accelerator.h"
#include "core/image.h"
#include "core/vec.h"
#include "scene/scene.h"

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace alidade {

struct CompileOptions {
    std::string accel = "auto";
    Precision precision = Precision::float_;
    Intersect intersect = Intersect::exact;
    Isa isa = Isa::best;
    int threads = 0;                       ///< 0: all
    std::optional<Color> environment;      ///< a constant sky instead of the scene's
    std::string environment_file;          ///< an equirectangular picture instead of it
    bool lazy = false;                     ///< a mesh's structure is built when the first ray enters its box
    bool full_kernel = false;              ///< the kernel with every feature, needed or not: to measure what they would cost
};

/// Pixels x0 <= x < x1, y0 <= y < y1, from the top left.
struct Region {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// POV-Ray's antialiasing: pixels that differ from their neighbours by more than `threshold` are sampled more often.
/// Source   POV-Ray 3.7 reference, 3.2.5.4 "Anti-Aliasing Options"; weights and order verified by probing.
struct Supersampling {
    int method = 1;                        ///< 1: a grid in pixels that differ from the one to the left or above; 2: pixels whose corners differ are divided
    double threshold = 0.3;                ///< of the sum of differences of red, green and blue, coded by `gamma`, and alpha
    double gamma = 2.5;
    double jitter = 0;                     ///< rays are moved at random by so much of the distance between them
    int depth = 3;                         ///< method 1: the grid has so many rows; method 2: a pixel is divided so often, less 1
};

/// Has the picture a channel "A"? What shows through of POV-Ray's background (skies that light have none) is missing there, and in the colour, which is multiplied by it.
enum class Alpha : uint8_t {
    none,
    associated,   ///< for files whose colour is so, too
    straight,     ///< for files whose colour is not: what is brighter than its alpha raises it, and a scene's coding is undone of the colour without alpha. As POV-Ray's are
};

struct RenderOptions {
    int width = 640, height = 480;
    std::optional<Region> region;          ///< the rest stays black, opaque and uncovered; the picture keeps its size
    std::string camera;                    ///< a name, or a number from 0; empty: the scene's first, else one that frames everything
    std::string integrator = "whitted";
    int spp = 0;                           ///< samples a pixel; 1: the pixel's centre; 0: as the scene says
    std::optional<Supersampling> supersampling;   ///< instead of `spp` samples
    double adaptive = 0;                   ///< a pixel ends when the standard error of its mean, as displayed (1: black to white), is below; 0: none does
    std::optional<LensNoise> lens_noise;   ///< a pixel ends by this instead
    std::string sampler = "sobol";         ///< a name of the table in tracer/sampler.h: how samples are spread
    int light_samples = 1;                 ///< shadow rays to each light with an extent, and to the sky, a surface point
    std::optional<double> aperture;        ///< diameter of the lens, world units, instead of the camera's; 0: pinhole
    std::optional<double> focus;           ///< distance from the eye to the plane in focus, world units, instead of the camera's
    uint64_t seed = 0;
    int frame = 0;
    int max_depth = -1;                    ///< recursion limit; -1: as the scene says, else 8
    double exposure = 0;                   ///< EV: colours are multiplied by 2^exposure
    Alpha alpha = Alpha::none;
    std::vector<std::string> aovs;         ///< names of the table in tracer/film.h
    int tile = 16;
    int threads = 0;
    double time = 0;
};

/// How the caller watches a render, ends it early, and spares it what is done already. `progress` is called under a lock, at most once a tile;
/// the others by several threads at once. Tiles are those of tile_grid(), by number.
struct Monitor {
    std::function<void(size_t tiles_done, size_t tiles)> progress;
    const std::atomic<bool>* stop = nullptr;
    std::function<bool(size_t tile, Picture& picture)> recall = {};       ///< puts the pixels of a tile that is known into the picture; false: it is rendered
    std::function<void(size_t tile, const Picture& picture)> keep = {};   ///< after a tile was rendered
};

}  // namespace alidade
