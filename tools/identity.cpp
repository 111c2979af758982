// SPDX-License-Identifier: Apache-2.0
#include "tools/identity.h"

#include "core/fingerprint.h"
#include "core/image.h"
#include "scene/queries.h"
#include "tracer/compiled_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

namespace alidade {

/// Builds are told apart by when they were written.
std::string program_identity() {
    struct stat s {};
    const bool known = ::stat("/proc/self/exe", &s) == 0;
    return fmt::format("alidade {} ({} bytes, written at {}.{:09})", ALIDADE_VERSION, known ? s.st_size : 0, known ? s.st_mtim.tv_sec : 0, known ? s.st_mtim.tv_nsec : 0);
}

namespace {

std::string fingerprint_of(const Scene& scene) {
    uint64_t sum = fingerprint(dump(scene, MeshLists::fingerprints));
    for (const Image& image : scene.images) {
        if (image.path.empty()) continue;
        const auto bytes = read_file(image.path);
        sum = bytes ? fingerprint(*bytes, sum) : fingerprint(bytes.error(), sum);
    }
    return fmt::format("{:016x}", sum);
}

std::string text(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : "-"; }

std::string text(const std::optional<Supersampling>& value) {
    if (!value) return "-";
    const auto& [method, threshold, gamma, jitter, depth] = *value;
    return fmt::format("{}/{}/{}/{}/{}", method, threshold, gamma, jitter, depth);
}

std::string text(const std::optional<LensNoise>& value) { return value ? fmt::format("{}/{}/{}", value->variance, value->confidence, value->fewest) : "-"; }

}  // namespace

Identity identity(const CompiledScene& scene, const RenderOptions& options) {
    // All members by name: who adds one has to say here whether it decides pixels.
    const auto& [width, height, region, camera, integrator, spp, supersampling, adaptive, lens_noise, sampler, light_samples, aperture, focus, seed, frame, max_depth, exposure, alpha, aovs, tile, threads, time] = options;
    static_cast<void>(threads);
    const Region part = region.value_or(Region{0, 0, width, height});
    return {{"program", program_identity()},
            {"size", fmt::format("{}x{}", width, height)},
            {"part", fmt::format("{},{},{},{}", part.x0, part.y0, part.x1, part.y1)},
            {"antialiasing", fmt::format("{} spp={} adaptive={} lens={} sampler={} tile={}", text(supersampling), spp, adaptive, text(lens_noise), sampler, tile)},
            {"camera", fmt::format("'{}' aperture={} focus={} exposure={}", camera, text(aperture), text(focus), exposure)},
            {"integrator", fmt::format("{} light_samples={} max_depth={} seed={} frame={} time={} alpha={} aovs={}", integrator, light_samples, max_depth, seed, frame, time, int(alpha), fmt::join(aovs, ","))},
            {"scene", fingerprint_of(scene.scene)}};
}

}  // namespace alidade
