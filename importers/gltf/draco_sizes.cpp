// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/draco_sizes.h"

#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

namespace alidade::gltf {

tl::expected<DracoSizes, std::string> draco_sizes(std::span<const unsigned char> data) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return tl::unexpected(std::string("the compressed data are not Draco's"));
    if (header.version_major != 2 || header.version_minor != 2)
        return tl::unexpected(fmt::format("Draco bitstream {}.{} is not supported, only 2.2 is", header.version_major, header.version_minor));
    if (header.encoder_type != draco::TRIANGULAR_MESH) return tl::unexpected(std::string("the compressed data are points, not a mesh"));
    draco::GeometryMetadata metadata;
    bool good = true;
    if (header.flags & METADATA_FLAG_MASK) good = draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata);
    uint32_t faces = 0, points = 0;
    if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
        good = good && draco::DecodeVarint(&faces, &buffer) && draco::DecodeVarint(&points, &buffer);
    } else {
        uint8_t traversal = 0;
        good = good && buffer.Decode(&traversal) && draco::DecodeVarint(&points, &buffer) && draco::DecodeVarint(&faces, &buffer);
    }
    if (!good) return tl::unexpected(std::string("the compressed data end inside their header"));
    return DracoSizes{faces, points};
}

}  // namespace alidade::gltf
