// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/picture.h"

#include "core/image_colors.h"
#include "eval/texture_reads.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace alidade {

namespace {

/// The exponent of a file's own gamma, or of the scene's words; 0 for the sRGB curve.
double decoding(const PatternPicture& how, const StoredPicture& stored) {
    constexpr double kCurve = 0;
    if (stored.levels == 0 && how.code != PictureCode::power) return 1;
    switch (how.code) {
        case PictureCode::stored: return 1;
        case PictureCode::srgb: return kCurve;
        case PictureCode::power: return how.gamma;
        case PictureCode::told_or_srgb:
        case PictureCode::told_or_stored: break;
    }
    return stored.srgb || stored.gamma == 0 ? kCurve : 1 / stored.gamma;
}

/// Nothing says what the numbers are: they are those of the scene.
bool is_untold(const PatternPicture& how, const StoredPicture& stored) {
    return how.code == PictureCode::stored || (how.code == PictureCode::told_or_stored && !stored.srgb && stored.gamma == 0 && stored.levels != 0);
}

/// Catmull and Rom's cubic at a distance.
double cubic_weight(double distance) {
    const double x = std::abs(distance);
    if (x < 1) return (1.5 * x - 2.5) * x * x + 1;
    return x < 2 ? ((-0.5 * x + 2.5) * x - 4) * x + 2 : 0;
}

double weight(PictureFilter filter, double dx, double dy) {
    if (filter == PictureFilter::bilinear) return (1 - std::abs(dx)) * (1 - std::abs(dy));
    if (filter == PictureFilter::bicubic) return cubic_weight(dx) * cubic_weight(dy);
    return 1 / std::max(dx * dx + dy * dy, 1e-30);
}

/// The grey of a grey, of 255: POV-Ray's sum in single precision falls below a third of the levels, and is cut.
double truncated_grey(float level) {
    const float sum = (level * 0.297f + level * 0.589f) + level * 0.114f;
    return double(std::floor(sum * 255.0f));
}

double turns(double y, double x) { return std::atan2(y, x) / (2 * kPi); }
double fraction(double x) { return x - std::floor(x); }

/// In pixels: what is so near to the next one is in it (by experiment), as on a plane whose points are at zero but for rounding.
constexpr double kNextPixel = 1e-10;

}  // namespace

tl::expected<SpacePicture, std::string> SpacePicture::make(const PatternPicture& how, const Image& image, const RenderSettings& settings) {
    auto stored = image.bytes.empty() ? read_stored_picture(image.path) : decode_stored_picture(image.bytes);
    if (!stored) return tl::unexpected(stored.error());
    auto colors = colors_alone(std::move(stored->picture));
    if (!colors) return tl::unexpected(std::move(colors.error()));
    stored->picture = std::move(*colors);
    SpacePicture out;
    out.how_ = how;
    out.truncated_ = stored->format == "png" && stored->levels == 255 && stored->picture.channels == 1;   // of other formats, POV-Ray has colours
    out.transmits_red_ = stored->format != "tiff" && stored->palette.empty();
    out.decode(*stored, settings);
    out.set_clearings(std::move(stored->palette));
    out.picture_ = std::move(stored->picture);
    return out;
}

/// Each channel of colour is a function of its code; alpha is as it is.
void SpacePicture::decode(StoredPicture& stored, const RenderSettings& settings) {
    Picture& p = stored.picture;
    const int colors = p.channels < 3 ? 1 : 3;
    const double exponent = decoding(how_, stored);
    const bool untold = is_untold(how_, stored), encode = how_.scene_gamma && !untold;
    constexpr double kNeutral = 0.01;                                // POV-Ray leaves such powers away
    const double power = exponent / (encode && !settings.srgb_coded ? settings.assumed_gamma : 1);
    const bool is_power = exponent != 0 && !(encode && settings.srgb_coded);
    const auto decoded = [&](double x) {
        const bool cancels = exponent == 0 && encode && settings.srgb_coded;
        if (untold || cancels || (is_power && std::abs(power - 1) <= kNeutral)) return x;
        if (is_power) return std::pow(x, power);
        const double linear = exponent == 0 ? srgb_to_linear(x) : std::pow(x, exponent);
        if (!encode) return linear;
        return settings.srgb_coded ? linear_to_srgb(linear) : std::pow(linear, 1 / settings.assumed_gamma);
    };
    std::vector<float> codes;                                        // of 8 and 16 bits: a table is faster than powers
    for (uint32_t k = 0; stored.levels && k <= stored.levels; ++k) {
        const double code = double(k) / stored.levels, v = decoded(code);
        constexpr double kRounding = 1e-9;
        decoded_ = decoded_ || v != code;
        codes.push_back(float(truncated_ && v != code ? std::floor(v * 255 + kRounding) / 255 : v));
    }
    for (size_t pixel = 0; pixel + size_t(p.channels) <= p.values.size(); pixel += size_t(p.channels))
        for (int c = 0; c < colors; ++c) {
            float& v = p.values[pixel + size_t(c)];
            v = stored.levels ? codes[size_t(std::lround(std::clamp(double(v), 0.0, 1.0) * stored.levels))] : float(decoded(double(v)));
        }
}

/// The last that is said of a colour holds. Of a palette, it takes the place of the file's own alpha.
void SpacePicture::set_clearings(std::vector<uint8_t> palette) {
    palette_ = std::move(palette);
    for (const PatternPicture::Clearing& c : how_.clearings)
        for (size_t i = 0; i < clear_.size(); ++i) {
            if (c.color ? size_t(*c.color) != i || palette_.empty() : false) continue;
            if (c.filter) clear_[i].filter = *c.filter;
            if (c.transmit) clear_[i].transmit = c.transmit;
        }
}

/// In pixels from the lower left corner, within the picture.
std::optional<Vec2> SpacePicture::pixel(const Vec3& p) const {
    double u = p.x, v = p.y;
    if (how_.map != PictureMap::planar) u = fraction(turns(p.z, p.x));
    if (how_.map == PictureMap::spherical) {
        const double r = length(p);
        v = 0.5 + std::asin(r > 0 ? std::clamp(p.y / r, -1.0, 1.0) : 0) / kPi;
    } else if (how_.map == PictureMap::toroidal) {
        v = 0.5 + turns(p.y, std::hypot(p.x, p.z) - 1);
    }
    if (!std::isfinite(u) || !std::isfinite(v)) return std::nullopt;
    const auto around = [](double x, int size) { return x < 0 || x * size + kNextPixel >= size; };
    const bool around_u = around(u, picture_.width), around_v = around(v, picture_.height), ends = how_.map == PictureMap::planar || how_.map == PictureMap::cylindrical;
    if (how_.once && ends && (around_u || around_v)) return std::nullopt;
    return Vec2(fraction(u) * picture_.width, fraction(v) * picture_.height);
}

/// By columns from the left and rows from below: repeated, or, of a picture that is not, those at the edge.
SpacePicture::Texel SpacePicture::texel(int x, int y) const {
    const auto within = [&](int i, int size) { return how_.once ? std::clamp(i, 0, size - 1) : (i % size + size) % size; };
    x = within(x, picture_.width), y = picture_.height - 1 - within(y, picture_.height);
    const float* p = picture_.at(x, y);
    ++texture_reads;
    Texel out;
    const bool grey = picture_.channels < 3, has_alpha = picture_.channels == 2 || picture_.channels >= 4;
    out.rgba = Vec4(p[0], p[grey ? 0 : 1], p[grey ? 0 : 2], has_alpha ? 1 - double(p[grey ? 1 : 3]) : 0);
    const size_t color = palette_.empty() ? 0 : palette_[size_t(y) * size_t(picture_.width) + size_t(x)];
    const double shown = truncated_ && !decoded_ ? truncated_grey(p[0]) / 255 : grey ? double(p[0]) : pov_grey(Color(out.rgba));
    const double red = grey ? shown : double(p[0]);
    switch (how_.value) {
        case PictureValue::grey: out.value = shown; break;
        case PictureValue::transmission: out.value = has_alpha || !transmits_red_ ? out.rgba.w : red; break;
        case PictureValue::palette: out.value = palette_.empty() ? shown : double(color); break;
        case PictureValue::number: out.value = palette_.empty() ? red * 255 : double(color); break;
    }
    const Clear& more = clear_[color];
    out.filter = more.filter;
    if (more.transmit) out.rgba.w = palette_.empty() ? out.rgba.w + *more.transmit : *more.transmit;
    return out;
}

bool SpacePicture::is_numbered() const { return how_.value == PictureValue::number || (how_.value == PictureValue::palette && !palette_.empty()); }

/// Numbers are whole also between pixels. Where all pixels around are alike, POV-Ray's rounding makes it the next lower one at some points.
SpacePicture::Texel SpacePicture::sampled(const Vec2& at) const {
    Texel out = between(at);
    constexpr double kRounding = 1e-6;
    if (is_numbered()) out.value = std::floor(out.value + kRounding);
    return out;
}

SpacePicture::Texel SpacePicture::between(const Vec2& at) const {
    if (how_.filter == PictureFilter::none) return texel(int(std::floor(at.x + kNextPixel)), int(std::floor(at.y + kNextPixel)));
    // Centres of pixels are at halves.
    const int i = int(std::floor(at.x - 0.5)), j = int(std::floor(at.y - 0.5)), more = how_.filter == PictureFilter::bicubic ? 1 : 0;
    const double s = at.x - 0.5 - i, t = at.y - 0.5 - j;
    Texel sum;
    double all = 0;
    for (int y = -more; y <= 1 + more; ++y)
        for (int x = -more; x <= 1 + more; ++x) {
            const double w = weight(how_.filter, s - x, t - y);
            const Texel one = texel(i + x, j + y);
            sum = {sum.rgba + one.rgba * w, sum.filter + one.filter * w, sum.value + one.value * w};
            all += w;
        }
    return {sum.rgba / all, sum.filter / all, sum.value / all};
}

PigmentColor SpacePicture::color(const Vec3& place) const {
    const auto at = pixel(place);
    if (!at) return {Color(1), 0, 1, true};
    const Texel t = sampled(*at);
    const double shown = 1 - t.rgba.w;                               // also of what `transmit` says: measured
    return {Color(t.rgba) / (how_.premultiplied && shown > 0 ? shown : 1), t.filter, t.rgba.w};
}

double SpacePicture::value(const Vec3& place) const {
    const auto at = pixel(place);
    if (!at) return 0;
    const double value = sampled(*at).value;
    return is_numbered() ? value : std::clamp(value, 0.0, 1.0);   // the cubic goes beyond both
}

Vec2 SpacePicture::rise(const Vec3& place) const {
    const auto at = pixel(place);
    if (!at) return Vec2(0);
    const Vec2 size(picture_.width, picture_.height);
    const auto beside = [&](double x) { return sampled(glm::mod(*at + Vec2(x, -1), size)).value; };   // around the edges also with `once`
    const double here = sampled(*at).value, left = beside(-1), right = beside(1);
    return {(right - left) / 2, here - (left + right) / 2};
}

auto SpacePictures::get(const PatternPicture& how, const Scene& scene) -> tl::expected<std::shared_ptr<const SpacePicture>, std::string> {
    for (const auto& known : known_)
        if (known->how() == how) return known;
    const Image& image = scene.images[how.image.index];
    auto made = SpacePicture::make(how, image, scene.settings);
    if (!made) return tl::unexpected(fmt::format("image '{}' cannot be read: {}", image.path.empty() ? image.name : image.path, made.error()));
    return known_.emplace_back(std::make_shared<const SpacePicture>(std::move(*made)));
}

}  // namespace alidade
