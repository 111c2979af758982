// SPDX-License-Identifier: Apache-2.0
#include "tracer/textures.h"

#include "core/image_colors.h"
#include "core/parallel.h"
#include "eval/texture_reads.h"

#include <fmt/format.h>
#include <limits>
#include <map>

namespace alidade {
namespace {

/// Which decoding of which image a signal reads.
using PictureKey = std::pair<uint32_t, bool>;   // image, srgb

tl::expected<Picture, std::string> decode(const Image& image, bool srgb) {
    // A float file holds linear values whatever the material says of it.
    const Encoding encoding = srgb ? Encoding::automatic : Encoding::linear;
    return (image.bytes.empty() ? read_picture(image.path, encoding) : decode_picture(image.bytes, encoding)).and_then(colors_alone);
}

/// A texture coordinate brought near [0, 1), where it is the same under the wrap mode: what is left fits an int, however large the number was.
double reduced(double x, Wrap wrap) {
    if (!std::isfinite(x)) return 0;
    switch (wrap) {
        case Wrap::repeat: return x - std::floor(x);
        case Wrap::mirror: return x - 2 * std::floor(x / 2);
        case Wrap::clamp:
        case Wrap::once: break;
    }
    return std::clamp(x, -2.0, 3.0);
}

/// The texel index of coordinate `i` under a wrap mode, or -1 outside of a `once` image.
int wrapped(int i, int size, Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat: return (i % size + size) % size;
        case Wrap::clamp: return std::clamp(i, 0, size - 1);
        case Wrap::mirror: {
            const int64_t period = 2 * int64_t(size), k = (i % period + period) % period;
            return int(k < size ? k : period - 1 - k);
        }
        case Wrap::once: break;
    }
    return i < 0 || i >= size ? -1 : i;
}

/// RGBA of a texel: gray is repeated, a missing alpha is 1.
Vec4 texel(const Picture& picture, int x, int y) {
    if (x < 0 || y < 0) return Vec4(0);
    const float* p = picture.at(x, y);
    ++texture_reads;
    switch (picture.channels) {
        case 1: return {p[0], p[0], p[0], 1};
        case 2: return {p[0], p[0], p[0], p[1]};
        case 3: return {p[0], p[1], p[2], 1};
        default: return {p[0], p[1], p[2], p[3]};
    }
}

}  // namespace

Textures::Textures(const Scene& scene, const std::vector<SignalId>& used, int threads, Diagnostics& said)
    : signals_(scene.signals), resource_of_(scene.signals.size(), kNoId) {
    std::map<PictureKey, uint32_t> index;
    std::vector<PictureKey> keys;
    for (const SignalId id : used) {
        const auto* image = std::get_if<ImageSignal>(&signals_[id.index].what);
        if (!image) continue;
        const auto [at, added] = index.try_emplace({image->image.index, image->srgb}, uint32_t(keys.size()));
        if (added) keys.push_back(at->first);
        resource_of_[id.index] = at->second;
    }
    add_patterns(scene, used, said);
    pictures_.resize(keys.size());
    std::vector<std::string> failures(keys.size());
    parallel_for(keys.size(), threads, [&](size_t i) {
        auto picture = decode(scene.images[keys[i].first], keys[i].second);
        if (picture) pictures_[i] = std::move(*picture);
        else failures[i] = picture.error();
    });
    for (size_t i = 0; i < keys.size(); ++i) {
        const Image& image = scene.images[keys[i].first];
        if (!failures[i].empty()) said.error(image.from, fmt::format("image '{}' cannot be read: {}", image.path.empty() ? image.name : image.path, failures[i]));
    }
}

void Textures::add_patterns(const Scene& scene, const std::vector<SignalId>& used, Diagnostics& said) {
    const auto keep = [&](SignalId id, const PatternSignal& pattern, const auto& make, auto& all) {
        auto source = source_of(pattern, scene);
        if (!source) return said.error(signals_[id.index].from, source.error());
        auto made = make(std::move(*source));
        if (!made) return said.error(signals_[id.index].from, made.error());
        resource_of_[id.index] = uint32_t(all.size());
        all.push_back(std::move(*made));
    };
    for (const SignalId id : used) {
        if (resource_of_[id.index] != kNoId) continue;
        const auto& what = signals_[id.index].what;
        if (const auto* pattern = std::get_if<PatternSignal>(&what)) keep(id, *pattern, [&](PatternSource source) { return Pattern::make(*pattern, std::move(source)); }, patterns_);
        if (const auto* relief = std::get_if<ReliefSignal>(&what)) keep(id, relief->pattern, [&](PatternSource source) { return Relief::make(*relief, std::move(source)); }, reliefs_);
    }
}

tl::expected<PatternSource, std::string> Textures::source_of(const PatternSignal& signal, const Scene& scene) {
    PatternSource source;
    if (signal.source) source.grey = [this, pigment = *signal.source](const Vec3& place) { return pov_grey(this->pigment(pigment, place).color); };
    if (signal.function) {
        const auto number = [this](SignalId pattern, const Vec3& p) { return patterns_[resource_of_[pattern.index]].value(p); };
        const auto color = [this](SignalId pigment, const Vec3& p) { return components(this->pigment(pigment, p)); };
        auto runner = FunctionRunner::make(scene, *signal.function, {number, color});
        if (!runner) return tl::unexpected(runner.error());
        source.grey = pattern_of_function(std::move(*runner));
    }
    if (!signal.picture) return source;
    auto picture = space_pictures_.get(*signal.picture, scene);
    if (!picture) return tl::unexpected(picture.error());
    source.picture = std::move(*picture);
    return source;
}

size_t Textures::bytes() const {
    size_t n = 0;
    for (const Picture& p : pictures_) n += p.values.size() * sizeof(float);
    for (const auto& p : space_pictures_.all()) n += p->bytes();
    return n;
}

Vec4 Textures::lookup(const ImageSignal& image, const Picture& picture, const Vec2& uv) const {
    // Texel centres are at (i + 1/2) / size.
    const double x = reduced(uv.x, image.wrap_u) * picture.width, y = reduced(uv.y, image.wrap_v) * picture.height;
    auto at = [&](int i, int j) { return texel(picture, wrapped(i, picture.width, image.wrap_u), wrapped(j, picture.height, image.wrap_v)); };
    if (image.filter == Filter::nearest) return at(int(std::floor(x)), int(std::floor(y)));
    const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5), s = x - 0.5 - fx, t = y - 0.5 - fy;
    const int i = int(fx), j = int(fy);
    return (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) + (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t;
}

Textures::Value Textures::mapped(const PatternSignal& signal, const Pattern& pattern, const ShadePoint& point, const Vec3& outside) const {
    const Vec3 at = pattern.place(signal.uv_mapped ? point.uv_place() : outside);
    if (const SpacePicture* picture = pattern.shown()) {
        const PigmentColor c = picture->color(at);
        return {Vec4(c.color, 1), c.filter, c.transmit, c.ended};
    }
    if (signal.map.empty()) {
        const double v = pattern.value_at(at);   // as POV-Ray's own map from black to white
        return {Vec4(v, v, v, 1), 0, 0};
    }
    Value total;
    alidade::for_each_share(signal.map, pattern, at, [&](uint32_t entry, double share) {
        const Value own = value(signal.map[entry].signal, point, at);
        total = {total.rgba + own.rgba * share, total.filter + own.filter * share, total.transmit + own.transmit * share, own.ended && share == 1};
    });
    return total;
}

Textures::Value Textures::value(SignalId signal, const ShadePoint& point, const Vec3& at) const {
    const auto& what = signals_[signal.index].what;
    if (const auto* constant = std::get_if<ConstantSignal>(&what)) return {constant->value, constant->filter, constant->transmit};
    if (const auto* product = std::get_if<ProductSignal>(&what)) return {value(product->a, point, at).rgba * value(product->b, point, at).rgba, 0, 0};
    if (const auto* channel = std::get_if<ChannelSignal>(&what)) return {Vec4(value(channel->of, point, at).rgba[channel->channel]), 0, 0};
    if (const auto* image = std::get_if<ImageSignal>(&what)) {
        const Vec3 uv = image->uv_transform * Vec3(point.uv(image->uv_set), 1);
        const Vec4 texel = lookup(*image, pictures_[resource_of_[signal.index]], Vec2(uv));
        return {texel, 0, 1 - texel.w};
    }
    if (const auto* pattern = std::get_if<PatternSignal>(&what)) return mapped(*pattern, patterns_[resource_of_[signal.index]], point, at);
    return {};
}

Vec4 Textures::evaluate(SignalId signal, const ShadePoint& point) const {
    const auto* constant = std::get_if<ConstantSignal>(&signals_[signal.index].what);
    return constant ? constant->value : value(signal, point, point.pattern_point()).rgba;
}

PigmentColor Textures::pigment(SignalId signal, const ShadePoint& point, const Vec3& at) const {
    if (const auto* constant = std::get_if<ConstantSignal>(&signals_[signal.index].what)) return {Color(constant->value), constant->filter, constant->transmit};
    const Value v = value(signal, point, at);
    return {Color(v.rgba), v.filter, v.transmit, v.ended};
}

PigmentColor Textures::pigment(SignalId signal, const Vec3& at) const {
    static const ShadePoint kNowhere;
    return pigment(signal, kNowhere, at);
}

Vec3 Textures::bent_there(SignalId id, const Vec3& place, const Vec3& n) const {
    const Relief& relief = reliefs_[resource_of_[id.index]];
    const std::vector<MapEntry>& map = std::get<ReliefSignal>(signals_[id.index].what).pattern.map;
    const Vec3 at = relief.place(place), there = relief.inwards(n);
    if (map.empty()) return relief.outwards(relief.bent(at, there));
    Vec3 sum(0);
    alidade::for_each_share(map, relief.pattern(), at, [&](uint32_t entry, double share) { sum += bent_there(map[entry].signal, at, there) * share; });
    return relief.outwards(sum);
}

Vec3 Textures::bent(SignalId relief, const PatternFrame& outer, const Vec3& n) const {
    const auto& signal = std::get<ReliefSignal>(signals_[relief.index].what);
    const PatternFrame frame = outer.under(signal.pattern);
    const Vec3 there = frame.normal_in * n;
    const Vec3 bent = bent_there(relief, frame.at, frame.mapped || reliefs_[resource_of_[relief.index]].scaled() ? normalized(there) : there);
    if (!std::isfinite(bent.x + bent.y + bent.z)) return Vec3(std::numeric_limits<double>::quiet_NaN());
    const Vec3 unit = normalized(frame.normal_out * bent);
    return std::abs(dot(unit, unit) - 1) < 1e-6 ? unit : n;   // a relief that cancels the normal leaves it as it is
}

PatternFrame pattern_frame(const ShadePoint& point) {
    const Vec3 place = point.uv_mapped ? point.uv_place() : point.position;
    if (!point.space) return {place, Mat3(1.0), Mat3(1.0), &point};
    return {point.space->from_world.point(place), glm::transpose(point.space->to_world.linear), glm::transpose(point.space->from_world.linear), &point};
}

}  // namespace alidade
