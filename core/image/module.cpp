// SPDX-License-Identifier: Apache-2.0
/// The OpenImageIO module: which formats it is asked for, where it is found, and the program's side of core/image_module/abi.h.
#include "core/image/codec.h"
#include "core/image_module/abi.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace alidade {
namespace {

using namespace std::string_view_literals;
using image::Bytes;
using image::Result;
using image::Stored;

/// A format that is read, by its magic bytes at an offset.
struct Readable {
    const char* format;   ///< OpenImageIO's name
    size_t offset;
    std::string_view magic;
};
constexpr Readable kReadable[] = {
    {"jpeg", 0, "\xff\xd8\xff"sv},  {"webp", 8, "WEBPVP8"sv},          {"tiff", 0, "II*\0"sv},         {"tiff", 0, "MM\0*"sv},
    {"tiff", 0, "II+\0"sv},         {"tiff", 0, "MM\0+"sv},            {"hdr", 0, "#?RADIANCE"sv},     {"hdr", 0, "#?RGBE"sv},
    {"bmp", 0, "BM"sv},             {"gif", 0, "GIF8"sv},              {"psd", 0, "8BPS"sv},           {"dds", 0, "DDS "sv},
    {"dpx", 0, "SDPX"sv},           {"dpx", 0, "XPDS"sv},              {"jpeg2000", 4, "jP  \r\n"sv},  {"jpeg2000", 0, "\xff\x4f\xff\x51"sv},
};

/// A format that is written. WebP could hold alpha, but OpenImageIO 2.4 writes its colour wrong then.
struct Writable {
    const char* ending;
    const char* format;
    bool alpha, floats;
};
constexpr Writable kWritable[] = {
    {".jpg", "jpeg", false, false}, {".jpeg", "jpeg", false, false}, {".webp", "webp", false, false}, {".tif", "tiff", true, false},
    {".tiff", "tiff", true, false}, {".hdr", "hdr", false, true},    {".tga", "targa", true, false}, {".bmp", "bmp", true, false},
};

Result<const Writable*> find_writable(const std::string& ending) {
    for (const Writable& w : kWritable)
        if (ending == w.ending) return &w;
    return tl::unexpected(fmt::format("no picture format that can be written has the ending {}", ending));
}

/// TGA has no magic bytes: a header whose fields all make sense is taken for one.
bool looks_like_tga(std::span<const std::byte> bytes) {
    if (bytes.size() < 18) return false;
    const auto field = [&](size_t i) { return std::to_integer<unsigned>(bytes[i]); };
    const unsigned map = field(1), kind = field(2), depth = field(16);
    const bool known_kind = (kind >= 1 && kind <= 3) || (kind >= 9 && kind <= 11);
    return map <= 1 && known_kind && (depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32);
}

const char* recognise(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const Readable& r : kReadable)
        if (text.size() >= r.offset && text.substr(r.offset).starts_with(r.magic)) return r.format;
    return looks_like_tga(bytes) ? "targa" : nullptr;
}

std::atomic<bool> module_is_open{false};

/// ALIDADE_MODULES if it is set; else beside the program, and in the library folder beside the program's (<prefix>/bin and <prefix>/lib/alidade).
std::vector<std::filesystem::path> module_folders() {
    if (const char* folder = std::getenv("ALIDADE_MODULES"); folder && *folder) return {folder};
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    if (error || program.empty()) return {};
    return {program, program.parent_path() / ALIDADE_LIBDIR};
}

Result<const AlidadeImageModule*> open_module() {
    constexpr const char* kName = "alidade_oiio.so";
    const std::vector<std::filesystem::path> folders = module_folders();
    for (const std::filesystem::path& folder : folders) {
        const std::string path = folder / kName;
        std::error_code error;
        if (!std::filesystem::exists(path, error)) continue;
        void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!library) return tl::unexpected(fmt::format("the image module does not open: {}", dlerror()));
        const auto entry = reinterpret_cast<decltype(&alidade_image_module)>(dlsym(library, ALIDADE_IMAGE_ENTRY));
        if (!entry || entry()->abi != ALIDADE_IMAGE_ABI) return tl::unexpected(fmt::format("the image module {} is of another version", path));
        module_is_open = true;
        return entry();
    }
    std::vector<std::string> looked_in(folders.begin(), folders.end());
    return tl::unexpected(fmt::format("the image module {}, which reads formats other than PNG, JPEG, GIF, PPM, PFM and EXR, and writes JPEG and others, is not in {} "
                                      "(ALIDADE_MODULES names another folder)", kName, fmt::join(looked_in, ", ")));
}

/// Opened once, and never closed.
const Result<const AlidadeImageModule*>& module() {
    static const Result<const AlidadeImageModule*> opened = open_module();
    return opened;
}

struct Decoding {
    Stored stored;
    size_t file_bytes = 0;
};

float* allocate(AlidadeImageCall* call, const AlidadeImageInfo* info) try {
    auto& decoding = *static_cast<Decoding*>(call->context);
    if (auto fits = image::check_size(info->width, info->height, info->channels, decoding.file_bytes); !fits) {
        std::snprintf(call->error, sizeof call->error, "%s", fits.error().c_str());
        return nullptr;
    }
    decoding.stored.picture = Picture(int(info->width), int(info->height), std::vector<std::string>(info->names, info->names + info->channels));
    if (info->more_pages) decoding.stored.left_out.push_back("further pages");
    image::note_orientation(decoding.stored, info->orientation);
    decoding.stored.levels = info->bits ? (1u << info->bits) - 1 : 0;
    return decoding.stored.picture.values.data();
} catch (const std::bad_alloc&) {
    std::snprintf(call->error, sizeof call->error, "not enough memory");
    return nullptr;
}

int keep_file(AlidadeImageCall* call, const void* bytes, size_t size) try {
    const auto* begin = static_cast<const std::byte*>(bytes);
    static_cast<Bytes*>(call->context)->assign(begin, begin + size);
    return 1;
} catch (const std::bad_alloc&) {
    std::snprintf(call->error, sizeof call->error, "not enough memory");
    return 0;
}

}  // namespace

bool image_module_loaded() { return module_is_open; }

namespace image {

Result<Stored> decode_by_module(std::span<const std::byte> bytes) {
    const char* format = recognise(bytes);
    if (!format) return tl::unexpected(std::string("it is in no picture format that is known here"));
    const auto& opened = module();
    if (!opened) return tl::unexpected(opened.error());
    Decoding decoding;
    decoding.file_bytes = bytes.size();
    AlidadeImageCall call{&decoding, allocate, nullptr, ""};
    if (!(*opened)->decode(format, bytes.data(), bytes.size(), &call)) return tl::unexpected(fmt::format("broken {}: {}", format, call.error));
    decoding.stored.format = format;
    return std::move(decoding.stored);
}

Result<void> check_module_writes(const std::string& ending) {
    const auto target = find_writable(ending);
    if (!target) return tl::unexpected(target.error());
    const auto& opened = module();
    return opened ? Result<void>() : tl::unexpected(opened.error());
}

Result<Bytes> encode_by_module(const Picture& picture, const std::string& ending) {
    const auto found = find_writable(ending);
    if (!found) return tl::unexpected(found.error());
    const Writable* target = *found;
    ColorChannels colors = color_channels(picture);
    if (colors.count == 0) return tl::unexpected(fmt::format("{} holds colour, but the picture has no channels R, G, B or Y", target->format));
    colors.count = 3;
    if (!target->alpha) colors.alpha = -1;   // over black
    const bool with_alpha = colors.alpha >= 0;
    const auto& opened = module();
    if (!opened) return tl::unexpected(opened.error());

    const char* const names[] = {"R", "G", "B", "A"};
    const AlidadeImageInfo info{uint32_t(picture.width), uint32_t(picture.height), with_alpha ? 4u : 3u, target->floats ? 0u : 8u, names, 0, 1};
    Bytes bytes;
    AlidadeImageCall call{&bytes, nullptr, keep_file, ""};
    const auto encode = [&](const void* pixels) { return (*opened)->encode(target->format, &info, pixels, &call); };
    const bool done = target->floats ? encode(straight_colors(picture, colors, with_alpha).data()) : encode(encode_8bit(picture, colors, with_alpha).data());
    if (!done) return tl::unexpected(std::string(call.error));
    return bytes;
}

}  // namespace image
}  // namespace alidade
