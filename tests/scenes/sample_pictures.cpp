// SPDX-License-Identifier: Apache-2.0
#include "tests/scenes/sample_pictures.h"
#include "tests/core/gif.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace alidade::test {

namespace {

constexpr uint32_t kSampleWidth = 7, kSampleHeight = 5;

std::string big_endian(uint32_t n) { return {char(n >> 24), char(n >> 16), char(n >> 8), char(n)}; }

uint32_t crc(const std::string& bytes) {
    uint32_t c = ~0u;
    for (const char byte : bytes) {
        c ^= uint8_t(byte);
        for (int i = 0; i < 8; ++i) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
    }
    return ~c;
}

std::string chunk(const std::string& type, const std::string& data) { return big_endian(uint32_t(data.size())) + type + data + big_endian(crc(type + data)); }

/// One block of a deflate stream that compresses nothing.
std::string stored(const std::string& data) {
    uint32_t a = 1, b = 0;
    for (const char byte : data) a = (a + uint8_t(byte)) % 65521, b = (b + a) % 65521;
    const uint32_t size = uint32_t(data.size()), not_size = ~size;
    return std::string("\x78\x01\x01", 3) + char(size) + char(size >> 8) + char(not_size) + char(not_size >> 8) + data + big_endian(b << 16 | a);
}

enum class Kind : char { grey = 0, rgb = 2, palette = 3, rgba = 6 };

/// A PNG file; `samples` without the filters of the rows.
std::string png(Kind kind, int bits, const std::string& samples, const std::string& chunks = "", uint32_t width = kSampleWidth, uint32_t height = kSampleHeight) {
    std::string rows;
    const size_t stride = samples.size() / height;
    for (size_t y = 0; y < height; ++y) rows += '\0' + samples.substr(y * stride, stride);
    const std::string header = big_endian(width) + big_endian(height) + char(bits) + char(kind) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunks + chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

/// Numbers that look random, and are the same everywhere.
std::string noise(size_t bytes, uint32_t seed) {
    std::string out;
    for (size_t i = 0; i < bytes; ++i) out += char((seed = seed * 1664525u + 1013904223u) >> 24);
    return out;
}

std::string smooth() {
    constexpr uint32_t kSide = 32;
    std::string out;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const double turn = 2 * 3.14159265358979 / kSide;
            const auto level = uint16_t(std::lround(32000 + 20000 * std::sin(turn * x) * std::cos(2 * turn * y)));
            out += char(level >> 8), out += char(level);
        }
    return png(Kind::grey, 16, out, "", kSide, kSide);
}

void write(const std::filesystem::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

}  // namespace

void write_sample_pictures(const std::filesystem::path& folder) {
    constexpr size_t kPixels = size_t(kSampleWidth) * kSampleHeight;
    const std::string colours = noise(3 * kPixels, 1);
    write(folder / "plain.png", png(Kind::rgb, 8, colours));
    write(folder / "srgb.png", png(Kind::rgb, 8, colours, chunk("sRGB", std::string(1, '\0'))));
    write(folder / "gamma.png", png(Kind::rgb, 8, colours, chunk("gAMA", big_endian(55556))));
    write(folder / "grey.png", png(Kind::grey, 8, noise(kPixels, 2)));
    write(folder / "alpha.png", png(Kind::rgba, 8, noise(4 * kPixels, 3)));
    std::string numbers = noise(kPixels, 4);
    for (char& n : numbers) n = char(uint8_t(n) % 3);
    const std::string three = std::string("\xff\x40\x20\x30\xe0\x50\x20\x60\xf0", 9), palette = chunk("PLTE", three) + chunk("tRNS", std::string("\xff\x80", 2));
    write(folder / "palette.png", png(Kind::palette, 8, numbers, palette));
    write(folder / "palette.gif", gif_file({kSampleWidth, kSampleHeight}, three + std::string(3, '\x7f'), gif_clear(1) + gif_frame({kSampleWidth, kSampleHeight}, numbers)));
    write(folder / "deep.png", png(Kind::rgb, 16, noise(6 * kPixels, 5)));
    write(folder / "deep_grey.png", png(Kind::grey, 16, noise(2 * kPixels, 6)));
    write(folder / "smooth.png", smooth());
    write(folder / "grey.pgm", "P5\n7 5\n255\n" + noise(kPixels, 2));
    write(folder / "plain.ppm", "P6\n7 5\n255\n" + colours);
}

}  // namespace alidade::test
