// SPDX-License-Identifier: Apache-2.0
/// JPEG of one or three components, by libjpeg. Others (CMYK) are left to the module.
#include "core/image/codec.h"

#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>   // jpeglib.h needs it
#include <jerror.h>
#include <jpeglib.h>

namespace alidade::image {
namespace {

/// What libjpeg's callbacks need. An error leaves by longjmp, which skips destructors: so the functions that call setjmp (read_jpeg_header, read_jpeg_rows) own nothing,
/// and everything that must be freed lives here or in their callers.
struct JpegReader {
    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf escape;
    char error[JMSG_LENGTH_MAX] = "";

    JpegReader() = default;
    JpegReader(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&info); }
};

[[noreturn]] void on_jpeg_error(j_common_ptr info) {
    auto* reader = static_cast<JpegReader*>(info->client_data);
    info->err->format_message(info, reader->error);
    std::longjmp(reader->escape, 1);
}

/// libjpeg goes on behind damage with a warning, and fills what is missing with grey: here that is an error. What is no damage to a pixel is passed.
void on_jpeg_message(j_common_ptr info, int level) {
    const int code = info->err->msg_code;
    if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_JFIF_MAJOR && code != JWRN_ADOBE_XFORM) on_jpeg_error(info);
}

void say_nothing(j_common_ptr) {}

/// A scan of a few bytes costs as much time as there are pixels. Encoders make 10 scans, the most careful ones some 20.
constexpr int kMostScans = 100;

void on_jpeg_progress(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= kMostScans) return;
    auto* reader = static_cast<JpegReader*>(info->client_data);
    std::snprintf(reader->error, sizeof reader->error, "it has more than %d scans", kMostScans);
    std::longjmp(reader->escape, 1);
}

bool read_jpeg_header(JpegReader& reader, std::span<const std::byte> bytes) {
    reader.info.err = jpeg_std_error(&reader.errors);
    reader.info.client_data = &reader;
    reader.errors.error_exit = on_jpeg_error, reader.errors.emit_message = on_jpeg_message, reader.errors.output_message = say_nothing;
    if (setjmp(reader.escape)) return false;
    jpeg_create_decompress(&reader.info);
    reader.progress.progress_monitor = on_jpeg_progress, reader.info.progress = &reader.progress;
    jpeg_mem_src(&reader.info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_save_markers(&reader.info, JPEG_APP0 + 1, 0xffff);   // Exif
    jpeg_read_header(&reader.info, TRUE);
    return true;
}

/// All rows, one behind the other.
bool read_jpeg_rows(JpegReader& reader, uint8_t* samples, size_t stride) {
    if (setjmp(reader.escape)) return false;
    jpeg_start_decompress(&reader.info);
    while (reader.info.output_scanline < reader.info.output_height) {
        JSAMPROW row = samples + stride * reader.info.output_scanline;
        jpeg_read_scanlines(&reader.info, &row, 1);
    }
    jpeg_finish_decompress(&reader.info);
    return true;
}

/// Tag 0x0112 of the first directory of a TIFF header; 1, as they come, if it has none or is broken. Source   Exif 2.3, 4.6.
uint32_t orientation_in(std::span<const uint8_t> tiff) {
    const bool little = !tiff.empty() && tiff[0] == 'I';
    const auto number = [&](size_t at, size_t size) {
        size_t value = 0;
        for (size_t i = 0; i < size && at + size <= tiff.size(); ++i) value = value << 8 | tiff[little ? at + size - 1 - i : at + i];
        return value;
    };
    const size_t directory = number(4, 4), entries = number(directory, 2);
    for (size_t entry = directory + 2; entry < directory + 2 + 12 * entries; entry += 12)
        if (number(entry, 2) == 0x0112) return uint32_t(number(entry + 8, 2));
    return 1;
}

uint32_t orientation_of(const JpegReader& reader) {
    constexpr std::string_view kExif("Exif\0\0", 6);
    for (auto* marker = reader.info.marker_list; marker; marker = marker->next)
        if (std::string_view(reinterpret_cast<const char*>(marker->data), marker->data_length).starts_with(kExif))
            return orientation_in(std::span(marker->data, marker->data_length).subspan(kExif.size()));
    return 1;
}

}  // namespace

Result<Stored> decode_jpeg(std::span<const std::byte> bytes) {
    JpegReader reader;
    if (!read_jpeg_header(reader, bytes)) return tl::unexpected(fmt::format("broken JPEG: {}, ahead of the pixels", reader.error));
    const size_t width = reader.info.image_width, height = reader.info.image_height, channels = size_t(reader.info.num_components);
    if (channels != 1 && channels != 3) return decode_by_module(bytes);
    if (auto fits = check_size(width, height, channels, bytes.size()); !fits) return tl::unexpected(fits.error());
    const uint32_t orientation = orientation_of(reader);   // with the last row libjpeg forgets the markers
    std::vector<uint8_t> samples(width * height * channels);
    if (!read_jpeg_rows(reader, samples.data(), width * channels)) return tl::unexpected(fmt::format("broken JPEG: {}, in row {} of {}", reader.error, reader.info.output_scanline, height));
    Stored stored{Picture(int(width), int(height), channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"}), 255u};
    for (size_t i = 0; i < samples.size(); ++i) stored.picture.values[i] = float(samples[i] / 255.0);
    note_orientation(stored, orientation);
    return stored;
}

}  // namespace alidade::image
