// SPDX-License-Identifier: Apache-2.0
#include "core/image_module/gif.h"

#include <algorithm>
#include <cstring>
#include <gif_lib.h>
#include <memory>

namespace alidade {

namespace {

struct Rest {
    const std::byte* at;
    size_t left;
};

int read_some(GifFileType* file, GifByteType* to, int count) {
    auto& rest = *static_cast<Rest*>(file->UserData);
    const size_t n = std::min(rest.left, size_t(count));
    std::memcpy(to, rest.at, n);
    rest.at += n, rest.left -= n;
    return int(n);
}

struct Close {
    void operator()(GifFileType* file) const { DGifCloseFile(file, nullptr); }
};

bool skip_extension(GifFileType* file) {
    int code = 0;
    GifByteType* block = nullptr;
    bool good = DGifGetExtension(file, &code, &block) == GIF_OK;
    while (good && block) good = DGifGetExtensionNext(file, &block) == GIF_OK;
    return good;
}

/// Goes to the pixels of the first picture; false if there is none.
bool find_picture(GifFileType* file) {
    for (GifRecordType type{}; DGifGetRecordType(file, &type) == GIF_OK;) {
        if (type == IMAGE_DESC_RECORD_TYPE) return DGifGetImageDesc(file) == GIF_OK;
        if (type != EXTENSION_RECORD_TYPE || !skip_extension(file)) return false;
    }
    return false;
}

bool read_rows(GifFileType* file, int first, int step, std::vector<uint8_t>& to) {
    for (int y = first; y < file->SHeight; y += step)
        if (DGifGetLine(file, &to[size_t(y) * size_t(file->SWidth)], file->SWidth) != GIF_OK) return false;
    return true;
}

}  // namespace

GifPicture gif_picture(const void* bytes, size_t size) {
    Rest rest{static_cast<const std::byte*>(bytes), size};
    const std::unique_ptr<GifFileType, Close> file(DGifOpen(&rest, read_some, nullptr));
    if (!file || !find_picture(file.get())) return {};
    const GifImageDesc& picture = file->Image;
    const ColorMapObject* const map = picture.ColorMap ? picture.ColorMap : file->SColorMap;
    if (!map || picture.Left != 0 || picture.Top != 0 || picture.Width != file->SWidth || picture.Height != file->SHeight) return {};
    GifPicture out;
    for (int i = 0; i < std::min(map->ColorCount, 256); ++i) out.colors[size_t(i)] = {map->Colors[i].Red, map->Colors[i].Green, map->Colors[i].Blue};
    out.numbers.resize(size_t(file->SWidth) * size_t(file->SHeight));
    constexpr int kPasses[][2] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};   // the format's appendix E, "Interlaced Images"
    bool good = true;
    if (!picture.Interlace) good = read_rows(file.get(), 0, 1, out.numbers);
    else
        for (const auto& [first, step] : kPasses) good = good && read_rows(file.get(), first, step, out.numbers);
    return good ? out : GifPicture();
}

}  // namespace alidade
