// SPDX-License-Identifier: Apache-2.0
/// PNG, by libpng. Its gAMA, cHRM and iCCP chunks are not applied (glTF 2.0, section 3.8.4.1, forbids it): Encoding says what the
/// numbers mean. Who reads the stored numbers is told the gamma.
#include "core/deep_png.h"
#include "core/image/codec.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>

namespace alidade::image {
namespace {

constexpr const char* kNoColor = "PNG holds colour, but the picture has no channels R, G, B or Y";

/// What libpng's callbacks need. It reports an error by longjmp, which skips destructors: so the functions that call
/// setjmp (read_header, read_rows, write_rows) own nothing, and everything that must be freed lives here or in their callers.
struct Codec {
    png_structp png = nullptr;
    png_infop info = nullptr;
    char error[160] = "";
};

struct Reader : Codec {
    std::span<const std::byte> rest;

    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

struct Writer : Codec {
    Bytes bytes;

    ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Header {
    png_uint_32 width = 0, height = 0;
    int bits = 0, channels = 0;   ///< of a decoded pixel; filled after the transforms are set
    double gamma = 0;             ///< as in StoredPicture
    bool srgb = false;            ///< likewise
    bool palette = false;         ///< samples are numbers of colours
};

void on_error(png_structp png, png_const_charp message) {
    auto* codec = static_cast<Codec*>(png_get_error_ptr(png));
    std::snprintf(codec->error, sizeof codec->error, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep out, size_t size) {
    auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
    if (reader->rest.size() < size) png_error(png, "the file ends too early");
    std::memcpy(out, reader->rest.data(), size);
    reader->rest = reader->rest.subspan(size);
}

/// Reads up to the pixels and asks for whole samples of 8 or 16 bits, and alpha instead of tRNS where there is no palette.
bool read_header(Reader& reader, Header& header) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_read_fn(reader.png, &reader, on_read);
    png_read_info(reader.png, reader.info);
    header.palette = png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE;
    if (header.palette) png_set_packing(reader.png);
    else png_set_expand(reader.png);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    header.width = png_get_image_width(reader.png, reader.info);
    header.height = png_get_image_height(reader.png, reader.info);
    header.srgb = png_get_valid(reader.png, reader.info, PNG_INFO_sRGB) != 0;
    if (!header.srgb) png_get_gAMA(reader.png, reader.info, &header.gamma);   // 0 stays where there is none
    png_read_update_info(reader.png, reader.info);
    header.bits = png_get_bit_depth(reader.png, reader.info);
    header.channels = png_get_channels(reader.png, reader.info);
    return true;
}

bool read_rows(Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

void on_write(png_structp png, png_bytep data, size_t size) {
    auto* writer = static_cast<Writer*>(png_get_io_ptr(png));
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    writer->bytes.insert(writer->bytes.end(), bytes, bytes + size);
}
void on_flush(png_structp) {}

/// Rows of 16-bit samples, which are encoded as sRGB, or nobody says how.
bool write_rows(Writer& writer, const Picture& picture, int color_type, bool srgb, png_bytepp rows) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    png_set_write_fn(writer.png, &writer, on_write, on_flush);
    png_set_IHDR(writer.png, writer.info, png_uint_32(picture.width), png_uint_32(picture.height), 16, color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (srgb) png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(writer.png, 3);
    png_write_info(writer.png, writer.info);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(writer.png);
    png_write_image(writer.png, rows);
    png_write_end(writer.png, nullptr);
    return true;
}

/// The file's samples as bytes, row after row. libpng makes its row buffers, a few bytes a pixel of one row, before the pixels are counted;
/// its own limit on the width bounds them.
Result<std::vector<uint8_t>> read_samples(Reader& reader, Header& header) {
    auto refused = [&] { return tl::unexpected(fmt::format("broken PNG: {}", reader.error)); };
    const size_t file_bytes = reader.rest.size();
    if (!read_header(reader, header)) return refused();
    if (auto fits = check_size(header.width, header.height, uint64_t(header.channels), file_bytes); !fits) return tl::unexpected(fits.error());

    const size_t stride = size_t(header.width) * size_t(header.channels) * size_t(header.bits / 8);
    std::vector<uint8_t> samples(stride * header.height);
    std::vector<png_bytep> rows(header.height);
    for (size_t y = 0; y < rows.size(); ++y) rows[y] = &samples[y * stride];
    if (!read_rows(reader, rows.data())) return refused();
    return samples;
}

std::vector<std::string> channel_names(int count) {
    switch (count) {
        case 1: return {"Y"};
        case 2: return {"Y", "A"};
        case 3: return {"R", "G", "B"};
        default: return {"R", "G", "B", "A"};
    }
}

/// A pixel's number in the palette -> its colour. Numbers beyond the palette are black, as libpng has them.
Stored looked_up(const Reader& reader, const Header& header, std::vector<uint8_t> numbers) {
    png_colorp colors = nullptr;
    png_bytep alphas = nullptr;
    int color_count = 0, alpha_count = 0;
    png_get_PLTE(reader.png, reader.info, &colors, &color_count);
    png_get_tRNS(reader.png, reader.info, &alphas, &alpha_count, nullptr);
    Stored stored{Picture(int(header.width), int(header.height), channel_names(alpha_count ? 4 : 3)), 255u, header.gamma, header.srgb, std::move(numbers)};
    float* to = stored.picture.values.data();
    for (const uint8_t number : stored.palette) {
        const png_color c = number < color_count ? colors[number] : png_color{0, 0, 0};
        for (const png_byte channel : {c.red, c.green, c.blue}) *to++ = float(channel / 255.0);
        if (alpha_count) *to++ = number < alpha_count ? float(alphas[number] / 255.0) : 1.0f;
    }
    return stored;
}

}  // namespace

Result<Stored> decode_png(std::span<const std::byte> bytes) {
    Reader reader;
    reader.rest = bytes;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<Codec*>(&reader), on_error, on_warning);
    if (reader.png) reader.info = png_create_info_struct(reader.png);
    if (!reader.info) return tl::unexpected(std::string("not enough memory"));

    Header header;
    Result<std::vector<uint8_t>> samples = read_samples(reader, header);
    if (!samples) return tl::unexpected(samples.error());
    if (header.palette) return looked_up(reader, header, std::move(*samples));
    Stored stored{Picture(int(header.width), int(header.height), channel_names(header.channels)), header.bits == 16 ? 65535u : 255u, header.gamma, header.srgb, {}};
    for (size_t i = 0; i < stored.picture.values.size(); ++i) {
        uint16_t sample = (*samples)[header.bits == 16 ? 2 * i : i];
        if (header.bits == 16) std::memcpy(&sample, &(*samples)[2 * i], 2);
        stored.picture.values[i] = float(double(sample) / stored.levels);
    }
    return stored;
}

/// `format`: libpng's PNG_FORMAT_...; `codes`: of 8 or 16 bits, as the format has them.
static Result<Bytes> written(const Picture& picture, uint32_t format, const void* codes) {
    png_image out{};
    out.version = PNG_IMAGE_VERSION;
    out.width = png_uint_32(picture.width);
    out.height = png_uint_32(picture.height);
    out.format = format;
    // Without it, the smallest file of a few choices is looked for: a fifth smaller, eight times as slow, and longer than many a picture takes to render.
    out.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(out);
    Bytes bytes(size);
    const int done = png_image_write_to_memory(&out, bytes.data(), &size, 0, codes, 0, nullptr);
    png_image_free(&out);
    if (!done) return tl::unexpected(std::string(out.message));
    bytes.resize(size);
    return bytes;
}

Result<Bytes> encode_png(const Picture& picture) {
    const ColorChannels colors = color_channels(picture);
    if (colors.count == 0) return tl::unexpected(std::string(kNoColor));
    const bool with_alpha = colors.alpha >= 0;
    const std::vector<uint8_t> codes = encode_8bit(picture, colors, with_alpha);
    return written(picture, (colors.count == 3 ? PNG_FORMAT_FLAG_COLOR : 0u) | (with_alpha ? PNG_FORMAT_FLAG_ALPHA : 0u), codes.data());
}

static Result<Bytes> deep_written(const Picture& picture, int color_type, bool srgb, std::vector<uint16_t> codes) {
    std::vector<png_bytep> rows(size_t(picture.height));
    for (size_t y = 0; y < rows.size(); ++y) rows[y] = reinterpret_cast<png_bytep>(&codes[y * (codes.size() / rows.size())]);
    Writer writer;
    writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<Codec*>(&writer), on_error, on_warning);
    if (writer.png) writer.info = png_create_info_struct(writer.png);
    if (!writer.info) return tl::unexpected(std::string("not enough memory"));
    if (!write_rows(writer, picture, color_type, srgb, rows.data())) return tl::unexpected(std::string(writer.error));
    return std::move(writer.bytes);
}

Result<Bytes> encode_deep_png(const Picture& picture) {
    const ColorChannels colors = color_channels(picture);
    if (colors.count == 0) return tl::unexpected(std::string(kNoColor));
    const bool with_alpha = colors.alpha >= 0;
    return deep_written(picture, (colors.count == 3 ? PNG_COLOR_MASK_COLOR : 0) | (with_alpha ? PNG_COLOR_MASK_ALPHA : 0), true, encode_16bit(picture, colors, with_alpha));
}

}  // namespace alidade::image

namespace alidade {

static std::vector<uint16_t> codes_of(const Picture& picture) {
    std::vector<uint16_t> codes;
    codes.reserve(picture.values.size());
    for (const float value : picture.values) codes.push_back(uint16_t(value > 0 ? std::min(value, 1.0f) * 65535.0f + 0.5f : 0));   // NaN is 0
    return codes;
}

tl::expected<std::vector<std::byte>, std::string> encode_number_png(const Picture& picture) {
    if (picture.channels != 1 && picture.channels != 3 && picture.channels != 4) return tl::unexpected(std::string("a PNG file of numbers has channel Y, channels R, G, B, or R, G, B, A"));
    return image::deep_written(picture, (picture.channels > 1 ? PNG_COLOR_MASK_COLOR : 0) | (picture.channels == 4 ? PNG_COLOR_MASK_ALPHA : 0), false, codes_of(picture));
}

tl::expected<std::vector<std::byte>, std::string> encode_linear_png(const Picture& picture) {
    if (picture.channels != 3 && picture.channels != 4) return tl::unexpected(std::string("a linear PNG file has channels R, G, B, or R, G, B, A"));
    const std::vector<uint16_t> codes = codes_of(picture);
    return image::written(picture, picture.channels == 4 ? PNG_FORMAT_LINEAR_RGB_ALPHA : PNG_FORMAT_LINEAR_RGB, codes.data());
}

}  // namespace alidade
