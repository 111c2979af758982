// SPDX-License-Identifier: Apache-2.0
#include "tracer/layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alidade {
namespace {

constexpr const char* kDepth[] = {"depth.Z"};
constexpr const char* kNormal[] = {"normal.X", "normal.Y", "normal.Z"};
constexpr const char* kAlbedo[] = {"albedo.R", "albedo.G", "albedo.B"};
constexpr const char* kId[] = {"id.Y"};
constexpr const char* kMaterial[] = {"material.Y"};
constexpr const char* kUv[] = {"uv.U", "uv.V"};
constexpr const char* kWork[] = {"work.Y"};
constexpr const char* kCoverage[] = {"coverage.Y"};

using Write = void (*)(const PixelSamples&, float*);

double mean(double sum, int count) { return count ? sum / count : 0; }

void write_mean(const Vec3& sum, int count, float* out) {
    for (int i = 0; i < 3; ++i) out[i] = float(mean(sum[i], count));
}

constexpr AovEntry kTable[] = {
    {"depth", "distance from the camera's eye, world units; infinite where nothing is hit", kDepth},
    {"normal", "shading normal, world space, towards the eye", kNormal},
    {"albedo", "base colour of the first surface, linear", kAlbedo},
    {"id", "1 + number of the instance that the first sample hit; 0: none", kId},
    {"material", "1 + number of the material that the first sample hit, in the order of the file; 0: none", kMaterial},
    {"uv", "first texture coordinate set", kUv},
    {"work", "box and primitive tests of the pixel", kWork},
    {"coverage", "share of the pixel that surfaces cover, alpha counted", kCoverage},
};

/// One a row of the table.
constexpr Write kWriters[] = {
    [](const PixelSamples& p, float* out) { *out = p.hits ? float(p.sum.depth / p.hits) : std::numeric_limits<float>::infinity(); },
    [](const PixelSamples& p, float* out) { write_mean(p.sum.normal, p.hits, out); },
    [](const PixelSamples& p, float* out) { write_mean(p.sum.albedo, p.hits, out); },
    [](const PixelSamples& p, float* out) { *out = p.instance == kNoId ? 0 : float(p.instance + 1); },
    [](const PixelSamples& p, float* out) { *out = p.material == kNoId ? 0 : float(p.material + 1); },
    [](const PixelSamples& p, float* out) { out[0] = float(mean(p.sum.uv.x, p.hits)), out[1] = float(mean(p.sum.uv.y, p.hits)); },
    [](const PixelSamples& p, float* out) { *out = float(p.work); },
    [](const PixelSamples& p, float* out) { *out = float(mean(p.sum.coverage, p.samples)); },
};
static_assert(std::size(kTable) == std::size(kWriters));

}  // namespace

std::span<const AovEntry> aovs() { return kTable; }

void PixelSamples::add(const Color& r, const FirstHit& first, uint32_t material_of_first) {
    radiance += r;
    ++samples;
    sum.coverage += first.coverage, sum.shows += first.shows;
    if (!first.hit) return;
    if (!hits++) sum.depth = 0, instance = first.instance, material = material_of_first;
    sum.depth += first.depth;
    sum.normal += first.normal;
    sum.albedo += first.albedo;
    sum.uv += first.uv;
}

void PixelSamples::add(const PixelSamples& more) {
    radiance += more.radiance;
    samples += more.samples;
    work += more.work;
    sum.coverage += more.sum.coverage, sum.shows += more.sum.shows;
    if (!more.hits) return;
    if (!hits) sum.depth = 0, instance = more.instance, material = more.material;
    hits += more.hits;
    sum.depth += more.sum.depth;
    sum.normal += more.sum.normal;
    sum.albedo += more.sum.albedo;
    sum.uv += more.sum.uv;
}

tl::expected<Layers, std::string> Layers::parse(const std::vector<std::string>& names, bool with_alpha) {
    Layers out;
    out.alpha_ = with_alpha;
    for (const std::string& name : names) {
        const auto row = std::find_if(std::begin(kTable), std::end(kTable), [&](const AovEntry& e) { return name == e.name; });
        if (row == std::end(kTable)) {
            std::vector<const char*> known;
            for (const AovEntry& e : kTable) known.push_back(e.name);
            return tl::unexpected(fmt::format("there is no output layer '{}': choose from {}", name, fmt::join(known, ", ")));
        }
        const size_t index = size_t(row - std::begin(kTable));
        if (std::find(out.rows_.begin(), out.rows_.end(), index) == out.rows_.end()) out.rows_.push_back(index);
    }
    return out;
}

std::vector<std::string> Layers::channels() const {
    std::vector<std::string> out{"R", "G", "B"};
    if (alpha_) out.push_back("A");
    for (const size_t row : rows_) out.insert(out.end(), kTable[row].channels.begin(), kTable[row].channels.end());
    return out;
}

void Layers::write(const PixelSamples& pixel, double exposure_scale, float* out) const {
    write_mean(pixel.radiance * exposure_scale, pixel.samples, out);
    out += 3;
    if (alpha_) *out++ = float(std::clamp(1 - mean(pixel.sum.shows, pixel.samples), 0.0, 1.0));
    for (const size_t row : rows_) {
        kWriters[row](pixel, out);
        out += kTable[row].channels.size();
    }
}

}  // namespace alidade
