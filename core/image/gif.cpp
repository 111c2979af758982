// SPDX-License-Identifier: Apache-2.0
/// The first picture of a GIF, by giflib. One that does not fill the file's screen is left to the module.
#include "core/image/codec.h"

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <bitset>
#include <cstring>
#include <memory>

namespace alidade::image {
namespace {

int read_some_gif(GifFileType* file, GifByteType* to, int count) {
    auto& rest = *static_cast<std::span<const std::byte>*>(file->UserData);
    const size_t n = std::min(rest.size(), size_t(count));
    std::memcpy(to, rest.data(), n);
    rest = rest.subspan(n);
    return int(n);
}

struct CloseGif {
    void operator()(GifFileType* file) const { DGifCloseFile(file, nullptr); }
};

/// Which numbers are transparent in the next picture. Of several blocks ahead of it, each may name one, as in POV-Ray.
using ClearNumbers = std::bitset<256>;

bool read_gif_extension(GifFileType* file, ClearNumbers& clear) {
    int code = 0;
    GifByteType* block = nullptr;
    bool good = DGifGetExtension(file, &code, &block) == GIF_OK;
    GraphicsControlBlock control;
    if (good && block && code == GRAPHICS_EXT_FUNC_CODE && DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK && control.TransparentColor != NO_TRANSPARENT_COLOR) clear.set(size_t(control.TransparentColor));
    while (good && block) good = DGifGetExtensionNext(file, &block) == GIF_OK;
    return good;
}

/// Goes to the pixels of the first picture; false if there is none.
bool find_gif_picture(GifFileType* file, ClearNumbers& clear) {
    for (GifRecordType type{}; DGifGetRecordType(file, &type) == GIF_OK;) {
        if (type == IMAGE_DESC_RECORD_TYPE) return DGifGetImageDesc(file) == GIF_OK;
        if (type != EXTENSION_RECORD_TYPE || !read_gif_extension(file, clear)) return false;
    }
    return false;
}

/// The row in which the numbers end, if it is not the last.
std::optional<int> read_gif_rows(GifFileType* file, std::vector<uint8_t>& to) {
    constexpr int kPasses[][2] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}}, kOne[][2] = {{0, 1}};   // the format's appendix E, "Interlaced Images"
    for (const auto& [first, step] : file->Image.Interlace ? std::span<const int[2]>(kPasses) : std::span<const int[2]>(kOne))
        for (int y = first; y < file->SHeight; y += step)
            if (DGifGetLine(file, &to[size_t(y) * size_t(file->SWidth)], file->SWidth) != GIF_OK) return y;
    return std::nullopt;
}

std::string gif_error(const GifFileType* file, int code) {
    const char* why = GifErrorString(file ? file->Error : code);
    return fmt::format("broken GIF: {}", why ? why : "it has no picture");
}

/// Colours that the palette does not have are black.
void look_up(const ColorMapObject& map, const ClearNumbers& clear, Stored& stored) {
    float* to = stored.picture.values.data();
    for (const uint8_t number : stored.palette) {
        const GifColorType color = number < map.ColorCount ? map.Colors[number] : GifColorType{0, 0, 0};
        for (const GifByteType channel : {color.Red, color.Green, color.Blue}) *to++ = float(channel / 255.0);
        *to++ = clear[number] ? 0.0f : 1.0f;
    }
}

}  // namespace

Result<Stored> decode_gif(std::span<const std::byte> bytes) {
    std::span<const std::byte> rest = bytes;
    int error = 0;
    ClearNumbers clear;
    const std::unique_ptr<GifFileType, CloseGif> file(DGifOpen(&rest, read_some_gif, &error));
    if (!file || !find_gif_picture(file.get(), clear)) return tl::unexpected(gif_error(file.get(), error));
    const GifImageDesc& picture = file->Image;
    const ColorMapObject* const map = picture.ColorMap ? picture.ColorMap : file->SColorMap;
    if (!map || picture.Left != 0 || picture.Top != 0 || picture.Width != file->SWidth || picture.Height != file->SHeight) return decode_by_module(bytes);
    if (auto fits = check_size(uint64_t(file->SWidth), uint64_t(file->SHeight), 4, bytes.size()); !fits) return tl::unexpected(fits.error());
    Stored stored{Picture(file->SWidth, file->SHeight, {"R", "G", "B", "A"}), 255u};
    stored.palette.resize(size_t(file->SWidth) * size_t(file->SHeight));
    if (const auto row = read_gif_rows(file.get(), stored.palette)) return tl::unexpected(fmt::format("{}, in row {} of {}", gif_error(file.get(), 0), *row, file->SHeight));
    look_up(*map, clear, stored);
    return stored;
}

}  // namespace alidade::image
