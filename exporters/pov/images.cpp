// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/images.h"

#include "core/deep_png.h"
#include "core/image_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace alidade::pov_export {

namespace {

/// From (u, v) with v downwards to the same with v upwards, and back.
constexpr Mat3 flipped_v() { return Mat3(1, 0, 0, 0, -1, 0, 0, 1, 1); }

bool is_same(const Transform& a, const Transform& b) { return a.linear == b.linear && a.translation == b.translation; }

std::span<const std::byte> as_bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

bool is_png(const std::string& bytes) { return picture_format(bytes).ending == std::string_view(".png"); }
bool is_jpeg(const std::string& bytes) { return picture_format(bytes).ending == std::string_view(".jpg"); }

/// What POV-Ray calls the format of a file of this name.
const char* format_word(const std::string& name) {
    static constexpr std::pair<std::string_view, const char*> kWords[] = {{".jpg", "jpeg"}, {".jpeg", "jpeg"}, {".ppm", "ppm"}, {".pgm", "pgm"}, {".tga", "tga"}, {".gif", "gif"},
                                                                          {".tif", "tiff"}, {".tiff", "tiff"}, {".exr", "exr"}, {".hdr", "hdr"}, {".bmp", "bmp"}, {".iff", "iff"}};
    for (const auto& [ending, word] : kWords)
        if (name.ends_with(ending)) return word;
    return "png";
}

constexpr size_t kPngBits = 24, kPngColourType = 25;

bool names_transparent_colours(const std::string& png) { return png.find("tRNS") != std::string::npos; }

/// PNG: of a colour type with alpha, or with transparent colours.
bool png_has_alpha(const std::string& bytes) { return bytes.size() > kPngColourType && ((bytes[kPngColourType] & 4) != 0 || names_transparent_colours(bytes)); }

/// POV-Ray takes tRNS of palettes alone: of RGB it sees nothing, of grey it crashes. Of grey up to 8 bits it loses a step at 84 of 256 levels.
bool pov_misreads(const std::string& png) {
    if (png.size() <= kPngColourType) return false;
    enum : char { grey = 0, rgb = 2 };
    const char type = png[kPngColourType];
    return (type == grey && png[kPngBits] <= 8) || ((type == grey || type == rgb) && names_transparent_colours(png));
}

/// Of a PNG file by its head alone.
std::optional<std::pair<int, int>> png_size(const std::string& bytes) {
    constexpr size_t kWidth = 16, kHeight = 20;
    if (!is_png(bytes) || bytes.size() <= kPngColourType) return std::nullopt;
    const auto number = [&](size_t at) {
        uint32_t value = 0;
        for (size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
        return value;
    };
    const uint32_t width = number(kWidth), height = number(kHeight);
    if (width > INT32_MAX || height > INT32_MAX) return std::nullopt;
    return std::pair{int(width), int(height)};
}

/// Of a channel.
bool has_more_than_8_bits(const std::string& bytes) {
    if (is_jpeg(bytes)) return false;
    if (is_png(bytes)) return bytes.size() > kPngBits && bytes[kPngBits] > 8;
    const auto stored = decode_stored_picture(as_bytes(bytes));
    return stored && (stored->levels == 0 || stored->levels > 255);
}

tl::expected<Picture, std::string> decoded(const std::string& bytes, Encoding encoding) {
    return decode_picture(as_bytes(bytes), encoding).and_then(colors_alone);
}

/// What is made of a picture.
struct Remake {
    Vec4 tint;
    PictureAlpha alpha;
    bool srgb;     ///< as the picture's signal has it
    bool linear;   ///< 16 bits a channel that hold linear values; else 8, sRGB-encoded
};

/// The picture times the tint with its edges, as a PNG file. What is above 1 is cut off.
tl::expected<std::string, std::string> remade(const std::string& bytes, const Remake& how, const PictureEdges& edges) {
    const auto picture = decoded(bytes, how.srgb ? Encoding::automatic : Encoding::linear);
    if (!picture) return tl::unexpected(picture.error());
    const bool keeps = how.alpha == PictureAlpha::kept;
    Picture out(picture->width, picture->height, keeps ? std::vector<std::string>{"R", "G", "B", "A"} : std::vector<std::string>{"R", "G", "B"});
    const bool grey = picture->channels < 3;
    for (int y = 0; y < picture->height; ++y)
        for (int x = 0; x < picture->width; ++x) {
            const float* from = picture->at(x, y);
            float* to = out.at(x, y);
            const bool has = picture->channels == 2 || picture->channels >= 4;
            const double a = (has ? double(from[grey ? 1 : 3]) : 1) * how.tint.w;
            for (int c = 0; c < 3; ++c) to[c] = float(double(from[grey ? 0 : c]) * how.tint[c] * (keeps && a > 0 ? a : 1));   // encode_picture wants it premultiplied
            if (keeps) to[3] = float(a);
        }
    if (!edges.none()) out = with_edges(out, edges);
    const auto encoded = how.linear ? encode_linear_png(out) : encode_picture(out, ".png");
    if (!encoded) return tl::unexpected(encoded.error());
    return std::string(reinterpret_cast<const char*>(encoded->data()), encoded->size());
}

}  // namespace

const std::string* ImageWriter::encoded(ImageId id) {
    const Image& image = scene_.images[id.index];
    const auto [at, added] = bytes_.try_emplace(id.index);
    if (added) {
        at->second = OutputFiles::read(image);
        losses_.add("pictures that cannot be read", !at->second, "their factor alone");
    }
    return at->second ? &*at->second : nullptr;
}

bool ImageWriter::has_alpha(const ImageSignal& image) {
    const std::string* bytes = encoded(image.image);
    return bytes && !is_jpeg(*bytes) && (!is_png(*bytes) || png_has_alpha(*bytes));
}

double ImageWriter::mean(const ImageSignal& image, int channel, Encoding encoding) {
    const auto [at, added] = means_.try_emplace({image.image.index, channel, encoding}, 1);
    if (!added) return at->second;
    const std::string* bytes = encoded(image.image);
    const auto picture = bytes ? decoded(*bytes, encoding) : tl::unexpected(std::string());
    if (!picture || picture->values.empty()) return 1;
    const int c = picture->channels < 3 ? 0 : std::clamp(channel, 0, picture->channels - 1);
    double sum = 0;
    for (int y = 0; y < picture->height; ++y)
        for (int x = 0; x < picture->width; ++x) sum += double(picture->at(x, y)[c]);
    return at->second = sum / (double(picture->width) * double(picture->height));
}

ImageWriter::File ImageWriter::make_file(const ImageSignal& image, const Vec4& tint, PictureAlpha alpha) {
    const std::string* bytes = encoded(image.image);
    if (!bytes) return {};
    const bool alpha_fits = alpha == PictureAlpha::kept || !has_alpha(image), readable = is_jpeg(*bytes) || (is_png(*bytes) && !pov_misreads(*bytes));
    const PictureEdges& frame = edges(image).edges;
    const Image& source = scene_.images[image.image.index];
    if (tint == Vec4(1) && alpha_fits && readable && frame.none())
        return {fmt::format("{} {}", is_png(*bytes) ? "png" : "jpeg", quoted(files_.add_picture(source, *bytes)))};
    const bool opaque = alpha == PictureAlpha::kept && tint.w == 1 && !has_alpha(image);
    // 8 bits are too few for what becomes dark and is lit brightly.
    const bool linear = tint != Vec4(1) || !image.srgb || has_more_than_8_bits(*bytes);
    auto made = remade(*bytes, {tint, opaque ? PictureAlpha::removed : alpha, image.srgb, linear}, frame);
    if (!made) {
        losses_.add(fmt::format("picture '{}', which cannot be decoded", source.name), 1, "its factor alone");
        return {};
    }
    return {fmt::format("png {}", quoted(files_.add_picture(source, std::move(*made)))), linear};
}

const ImageWriter::File& ImageWriter::file(const ImageSignal& image, const Vec4& tint, PictureAlpha alpha) {
    const Key key{image.image.index, {tint.x, tint.y, tint.z, tint.w}, alpha, image.srgb, edges(image).edges};
    const auto known = made_.find(key);
    return known != made_.end() ? known->second : made_.emplace(key, make_file(image, tint, alpha)).first->second;
}

/// Nothing of a picture that cannot be read.
ImageWriter::Size ImageWriter::size(ImageId id) {
    const auto [at, added] = sizes_.try_emplace(id.index);
    const std::string* bytes = added ? encoded(id) : nullptr;
    if (!bytes) return at->second;
    if (const auto head = png_size(*bytes)) return at->second = {head->first, head->second};
    if (const auto picture = decoded(*bytes, Encoding::linear)) at->second = {picture->width, picture->height};
    return at->second;
}

const ImageWriter::Framed& ImageWriter::edges(const ImageSignal& image) {
    const Lookup lookup(image);
    const auto [at, added] = edges_.try_emplace(lookup);
    if (!added || !(lookup.clamps() || lookup.mirrors())) return at->second;
    if (!ranges_) ranges_ = ranges_of_clamped(scene_);
    const auto range = ranges_->find(lookup);
    const Size within = size(image.image);
    if (within.width > 0 && within.height > 0) at->second = {edges_of(lookup, range != ranges_->end() ? range->second : LookupRange(), within.width, within.height), within};
    return at->second;
}

void ImageWriter::picture(const char* word, const File& file, const ImageSignal& image, const char* more, double transmit) {
    sdl_.begin(word);
    sdl_.line(file.words, "gamma", image.srgb && !file.linear ? "srgb" : "1");
    if (image.wrap_u == Wrap::once && image.wrap_v == Wrap::once) sdl_.line("once");
    if (image.filter == Filter::linear) sdl_.line("interpolate 2");
    if (*more) sdl_.line(more);
    if (transmit > 0) sdl_.line("transmit all", transmit);
    sdl_.end();
}

/// From the unit square to where the texture coordinates look it up.
Transform ImageWriter::placement(const ImageSignal& image) {
    const Framed& framed = edges(image);
    const Transform frame = framed.edges.none() ? Transform() : place_of(framed.edges, framed.within.width, framed.within.height);
    const Mat3 m = flipped_v() * image.uv_transform * flipped_v();
    if (m == Mat3(1.0)) return frame;
    const auto back = inverse(Transform{Mat3(m[0].x, m[0].y, 0, m[1].x, m[1].y, 0, 0, 0, 1), Vec3(m[2].x, m[2].y, 0)});
    losses_.add("texture transforms that squeeze a picture flat", !back, "none");
    return back ? *back * frame : frame;
}

void ImageWriter::place(const ImageSignal& image) {
    if (const Transform there = placement(image); !is_same(there, Transform())) sdl_.line(there);
}

/// All of a picture without alpha hides lights, whatever it transmits, unless something else stands in the same pigment that does not.
void ImageWriter::image_map(const File& file, const ImageSignal& image, double transmit) {
    if (transmit > 0) sdl_.begin("average pigment_map"), sdl_.line("[ 1");
    picture("image_map", file, image, "", transmit);
    if (transmit > 0) sdl_.line("]"), sdl_.line("[ 0 color rgbt <0,0,0,1> ]"), sdl_.end();
}

bool ImageWriter::map(const ImageSignal& image, const Vec4& tint, PictureAlpha alpha, double transmit) {
    const File& there = file(image, tint, alpha);
    if (there.words.empty()) return false;
    sdl_.line("uv_mapping");
    image_map(there, image, transmit);
    place(image);
    return true;
}

bool ImageWriter::map_within(const ImageSignal& outer, const ImageSignal& image, const Vec4& tint, double transmit) {
    const File& there = file(image, tint, PictureAlpha::removed);
    if (there.words.empty()) return false;
    image_map(there, image, transmit);
    const Transform around = placement(outer), own = placement(image);
    if (!is_same(own, around)) sdl_.line(inverse(around).value_or(Transform()) * own);
    return true;
}

bool ImageWriter::alpha_pattern(const ImageSignal& image) {
    const File& mask = file(image, Vec4(1), PictureAlpha::kept);
    if (mask.words.empty()) return false;
    sdl_.line("uv_mapping");
    picture("image_pattern", mask, image, "use_alpha", 0);
    return true;
}

void ImageWriter::picture_code(const std::string& word, const PatternPicture& p) {
    const bool colours = word == kImageMap, linear = colours && !p.scene_gamma && p.code != PictureCode::stored;
    losses_.add("pictures decoded by the words of a scene that corrects nothing", linear, "other colours");
    // What the scene's own gamma decodes is encoded by it again.
    const bool untouched = colours && (p.code == PictureCode::stored || (p.code == PictureCode::told_or_stored && tells_nothing(p.image)));
    if (p.code == PictureCode::power) sdl_.line("gamma", p.gamma);
    else if (p.code == PictureCode::srgb || (untouched && scene_.settings.srgb_coded)) sdl_.line("gamma srgb");
    else if (untouched) sdl_.line("gamma", scene_.settings.assumed_gamma);
}

/// POV-Ray warns of such files in old scenes.
bool ImageWriter::tells_nothing(ImageId id) {
    const std::string* bytes = encoded(id);
    const auto stored = bytes ? decode_stored_picture(as_bytes(*bytes)) : tl::unexpected(std::string());
    return stored && stored->levels != 0 && !stored->srgb && stored->gamma == 0;
}

bool ImageWriter::pattern(const std::string& word, const PatternPicture& p, const std::function<void()>& more) {
    const std::string* bytes = encoded(p.image);
    if (!bytes) return false;
    const std::string name = files_.add_picture(scene_.images[p.image.index], *bytes);
    static constexpr const char* kMaps[] = {"0", "1", "2", "5"};
    static constexpr const char* kFilters[] = {"0", "2", "3", "4"};
    sdl_.begin(word);
    sdl_.line(format_word(name), quoted(name));
    picture_code(word, p);
    if (p.premultiplied) sdl_.line("premultiplied on");
    if (p.map != PictureMap::planar) sdl_.line("map_type", kMaps[size_t(p.map)]);
    if (p.filter != PictureFilter::none) sdl_.line("interpolate", kFilters[size_t(p.filter)]);
    if (p.once) sdl_.line("once");
    if (p.value == PictureValue::transmission) sdl_.line("use_alpha");
    if (p.value == PictureValue::palette) sdl_.line("use_index");
    for (const PatternPicture::Clearing& c : p.clearings) {
        const std::string which = c.color ? fmt::format("{},", *c.color) : "all";
        if (c.filter) sdl_.line("filter", which, *c.filter);
        if (c.transmit) sdl_.line("transmit", which, *c.transmit);
    }
    if (more) more();
    sdl_.end();
    return true;
}

bool ImageWriter::sky(ImageId id) {
    ImageSignal image;
    image.image = id, image.srgb = true;
    const File& there = file(image, Vec4(1), PictureAlpha::removed);
    if (there.words.empty()) return false;
    sdl_.begin("image_map");
    sdl_.line(there.words, "map_type 1");
    sdl_.end();
    return true;
}

}  // namespace alidade::pov_export
