// SPDX-License-Identifier: Apache-2.0
/// JPEG files of smooth colours with some noise.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>
#include <string>
#include <vector>

namespace alidade::test {

struct JpegKind {
    int width = 37, height = 29, components = 3;
    bool progressive = false, subsampled = true;
    int restart_rows = 0;
    int scans_a_coefficient = 0;   ///< of one component: how many scans of its own each of the 63 behind the first has; 0: as is usual
    std::string exif = {};   ///< what stands behind "Exif\0\0"
};

inline std::vector<unsigned char> jpeg_row(const JpegKind& kind, int y) {
    std::vector<unsigned char> row(size_t(kind.width) * size_t(kind.components));
    for (size_t i = 0; i < row.size(); ++i) row[i] = static_cast<unsigned char>(i * 7 + size_t(y) * 5 + (i * i + size_t(y) * 31) % 23);
    return row;
}

/// One scan for the first coefficient, and as many as wanted for each other: all but the last bits, then one bit after the other.
inline std::vector<jpeg_scan_info> jpeg_scans(int a_coefficient) {
    std::vector<jpeg_scan_info> scans{{1, {0}, 0, 0, 0, 0}};
    for (int i = 1; i < 64; ++i)
        for (int low = a_coefficient - 1; low >= 0; --low) scans.push_back({1, {0}, i, i, low == a_coefficient - 1 ? 0 : low + 1, low});
    return scans;
}

inline std::vector<std::byte> jpeg_file(const JpegKind& kind) {
    jpeg_compress_struct out{};
    jpeg_error_mgr errors{};
    out.err = jpeg_std_error(&errors);
    jpeg_create_compress(&out);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&out, &buffer, &size);
    out.image_width = unsigned(kind.width), out.image_height = unsigned(kind.height), out.input_components = kind.components;
    out.in_color_space = kind.components == 1 ? JCS_GRAYSCALE : kind.components == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&out);
    if (kind.components == 3 && !kind.subsampled) out.comp_info[0].h_samp_factor = out.comp_info[0].v_samp_factor = 1;
    if (kind.progressive) jpeg_simple_progression(&out);
    const std::vector<jpeg_scan_info> scans = jpeg_scans(kind.scans_a_coefficient);
    if (kind.scans_a_coefficient > 0) out.scan_info = scans.data(), out.num_scans = int(scans.size());
    out.restart_in_rows = kind.restart_rows;
    jpeg_start_compress(&out, TRUE);
    const std::string exif = std::string("Exif\0\0", 6) + kind.exif;
    if (!kind.exif.empty()) jpeg_write_marker(&out, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(exif.data()), unsigned(exif.size()));
    for (int y = 0; y < kind.height; ++y) {
        std::vector<unsigned char> row = jpeg_row(kind, y);
        JSAMPROW at = row.data();
        jpeg_write_scanlines(&out, &at, 1);
    }
    jpeg_finish_compress(&out);
    jpeg_destroy_compress(&out);
    const auto* begin = reinterpret_cast<const std::byte*>(buffer);
    std::vector<std::byte> bytes(begin, begin + size);
    std::free(buffer);
    return bytes;
}

}  // namespace alidade::test
