// SPDX-License-Identifier: Apache-2.0
/// Primitives compressed by Draco, against the same primitives uncompressed. The oracle is Draco's encoder, without quantisation.
#include "scene/queries.h"
#include "tests/importers/gltf_text.h"

#include <cmath>
#include <draco/compression/encode.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <random>

namespace alidade::gltf_test {
namespace {

using testing::HasSubstr;

constexpr uint32_t kSide = 7, kPoints = kSide * kSide, kFaces = 2 * (kSide - 1) * (kSide - 1);

/// A bumpy grid with positions, and a vertex colour of bytes.
struct Grid {
    std::string positions, colors, indices;
    draco::Mesh mesh;

    Grid() {
        mesh.set_num_points(kPoints);
        const int position = add(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32, 40), color = add(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8, 7);
        for (uint32_t p = 0; p < kPoints; ++p) {
            const uint32_t x = p % kSide, y = p / kSide;
            const float at[3] = {float(x), float(y) * 1.1f, std::sin(float(x + 3 * y))};
            const uint8_t rgba[4] = {uint8_t(x * 30), uint8_t(y * 30), uint8_t(x * y), 255};
            mesh.attribute(position)->SetAttributeValue(draco::AttributeValueIndex(p), at);
            mesh.attribute(color)->SetAttributeValue(draco::AttributeValueIndex(p), rgba);
            positions.append(reinterpret_cast<const char*>(at), sizeof at);
            colors.append(reinterpret_cast<const char*>(rgba), sizeof rgba);
        }
        for (uint32_t y = 0; y + 1 < kSide; ++y)
            for (uint32_t x = 0; x + 1 < kSide; ++x) {
                const uint32_t a = y * kSide + x;
                add_face(a, a + 1, a + kSide + 1);
                add_face(a, a + kSide + 1, a + kSide);
            }
    }

    std::string encoded(int method) {
        draco::Encoder encoder;
        encoder.SetEncodingMethod(method);
        draco::EncoderBuffer buffer;
        EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
        return {buffer.data(), buffer.size()};
    }

  private:
    int add(draco::GeometryAttribute::Type type, int8_t components, draco::DataType data_type, uint32_t unique_id) {
        draco::GeometryAttribute a;
        a.Init(type, nullptr, uint8_t(components), data_type, data_type == draco::DT_UINT8, components * draco::DataTypeLength(data_type), 0);
        const int id = mesh.AddAttribute(a, true, kPoints);
        mesh.attribute(id)->set_unique_id(unique_id);
        return id;
    }
    void add_face(uint32_t a, uint32_t b, uint32_t c) {
        mesh.AddFace({draco::PointIndex(a), draco::PointIndex(b), draco::PointIndex(c)});
        indices += packed<uint16_t>({uint16_t(a), uint16_t(b), uint16_t(c)});
    }
};

std::string accessors(const std::string& a, const std::string& b, const std::string& c, uint64_t points = kPoints, uint64_t faces = kFaces) {
    return fmt::format(R"("accessors":[{{{}"componentType":5126,"count":{},"type":"VEC3"}},{{{}"componentType":5121,"normalized":true,"count":{},"type":"VEC4"}},{{{}"componentType":5123,"count":{},"type":"SCALAR"}}])",
                       a, points, b, points, c, 3 * faces);
}

constexpr const char* kAttributes = R"("attributes":{"POSITION":0,"COLOR_0":1})";
constexpr const char* kIds = R"("attributes":{"POSITION":40,"COLOR_0":7})";

std::string file(const std::string& primitive, const std::string& accessors, const std::string& views, const std::string& data) {
    return fmt::format(R"("scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{}]}}],{},"bufferViews":[{}],"buffers":[{}])",
                       primitive, accessors, views, buffer_json(data));
}

std::string primitive(const std::string& ids = kIds, const std::string& more = R"(,"indices":2)") {
    return fmt::format(R"({{{}{},"extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0,{}}}}}}})", kAttributes, more, ids);
}

std::string compressed_file(const std::string& data, const std::string& primitives = primitive(), uint64_t points = kPoints, uint64_t faces = kFaces) {
    return file(primitives, accessors("", "", "", points, faces), fmt::format(R"({{"buffer":0,"byteLength":{}}})", data.size()), data);
}

std::string plain_file(const Grid& grid) {
    const std::string data = grid.positions + grid.colors + grid.indices;
    const std::string views = fmt::format(R"({{"buffer":0,"byteLength":{}}},{{"buffer":0,"byteOffset":{},"byteLength":{}}},{{"buffer":0,"byteOffset":{},"byteLength":{}}})", grid.positions.size(),
                                          grid.positions.size(), grid.colors.size(), grid.positions.size() + grid.colors.size(), grid.indices.size());
    return file(fmt::format(R"({{{},"indices":2}})", kAttributes), accessors(R"("bufferView":0,)", R"("bufferView":1,)", R"("bufferView":2,)"), views, data);
}

/// The corners of all triangles with their attributes, in an order that does not depend on the numbers of vertices.
std::vector<std::array<float, 21>> soup(const Mesh& m) {
    std::vector<std::array<float, 21>> out;
    for (const Index3& t : m.triangles) {
        std::array<std::array<float, 7>, 3> corners;
        for (int c = 0; c < 3; ++c) {
            const Vec3f& p = m.positions[t[c]];
            const Vec4f& k = m.colors.at(0).values[t[c]];
            corners[size_t(c)] = {p.x, p.y, p.z, k.x, k.y, k.z, k.w};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::array<float, 21> flat;
        for (size_t i = 0; i < 21; ++i) flat[i] = corners[i / 7][i % 7];
        out.push_back(flat);
    }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(Draco, BothMethodsGiveTheTrianglesOfThePlainFile) {
    Grid grid;
    const Scene plain = scene_of(plain_file(grid));
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const Scene got = scene_of(compressed_file(grid.encoded(method)) + R"(,"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"])");
        ASSERT_EQ(mesh_of(got).positions.size(), kPoints);
        EXPECT_EQ(soup(mesh_of(got)), soup(mesh_of(plain))) << "method " << method;
    }
}

/// Strips, and primitives without indices, come out as the compressed triangles.
TEST(Draco, TheTrianglesAreThoseOfTheData) {
    Grid grid;
    const auto want = soup(mesh_of(scene_of(plain_file(grid))));
    const std::string data = grid.encoded(draco::MESH_EDGEBREAKER_ENCODING);
    EXPECT_EQ(soup(mesh_of(scene_of(compressed_file(data, primitive(kIds, ""))))), want);
    EXPECT_EQ(soup(mesh_of(scene_of(compressed_file(data, primitive(kIds, R"(,"mode":5,"indices":2)"), kPoints, 33)))), want);
}

/// Two meshes of the same data share a shape; data with other attributes do not, even through the same accessors.
TEST(Draco, SharedDataAreSharedShapes) {
    Grid grid;
    const std::string data = grid.encoded(draco::MESH_EDGEBREAKER_ENCODING);
    const auto two = [&](const std::string& second_view) {
        std::string second = primitive();
        second.replace(second.find(R"("bufferView":0)"), 14, R"("bufferView":)" + second_view);
        return scene_of(fmt::format(R"("meshes":[{{"primitives":[{}]}},{{"primitives":[{}]}}],{},"bufferViews":[{{"buffer":0,"byteLength":{}}},{{"buffer":0,"byteLength":{}}}],"buffers":[{}])",
                                    primitive(), second, accessors("", "", ""), data.size(), data.size(), buffer_json(data)));
    };
    EXPECT_EQ(two("0").shapes.size(), 1u);
    const Scene apart = two("1");
    ASSERT_EQ(apart.shapes.size(), 2u);
    EXPECT_EQ(soup(mesh_of(apart, 0)), soup(mesh_of(apart, 1)));
}

// ---- what is refused ----

void expect_refused(const std::string& members, const std::string& message) {
    const auto result = import_text(with_asset(members));
    ASSERT_FALSE(result) << message;
    EXPECT_THAT(result.error().text(), HasSubstr("test.gltf:/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression" + message));
}

TEST(DracoRefused, CountsThatDiffer) {
    Grid grid;
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const std::string data = grid.encoded(method);
        for (const uint64_t points : {kPoints - 1, kPoints + 1})
            expect_refused(compressed_file(data, primitive(), points), fmt::format("/attributes/COLOR_0: error: the accessor has {} elements, but 49 vertices are compressed", points));
        expect_refused(compressed_file(data, primitive(), kPoints, kFaces + 1), ": error: the accessor of the indices has 219 elements, but 72 triangles are compressed");
    }
}

TEST(DracoRefused, AttributesThatAreNotThere) {
    Grid grid;
    const std::string data = grid.encoded(draco::MESH_EDGEBREAKER_ENCODING);
    expect_refused(compressed_file(data, primitive(R"("attributes":{"POSITION":41})")), "/attributes/POSITION: error: no attribute 41 is compressed");
    expect_refused(compressed_file(data, primitive(R"("attributes":{"POSITION":7})")), "/attributes/POSITION: error: 4 numbers a vertex are compressed, but the accessor is VEC3");
    expect_refused(compressed_file(data, primitive(kIds, R"(,"mode":0)")), ": error: only triangles and triangle strips can be compressed");
}

std::string varint(uint64_t v) {
    std::string out;
    for (; v >= 128; v >>= 7) out += char(v | 128);
    return out + char(v);
}

/// The heads of bitstreams. Claims that accessors repeat are held against the bytes there are.
TEST(DracoRefused, Heads) {
    const std::string rest(100, '\0');
    expect_refused(compressed_file("CARDO" + rest), ": error: the compressed data are not Draco's");
    expect_refused(compressed_file(std::string("DRACO\x02\x01\x01\x01\0\0", 11) + rest), ": error: Draco bitstream 2.1 is not supported, only 2.2 is");
    expect_refused(compressed_file(std::string("DRACO\x02\x02\0\x01\0\0", 11) + rest), ": error: the compressed data are points, not a mesh");
    expect_refused(compressed_file(std::string("DRACO\x02\x02\x01\x01\0\0\0", 12)), ": error: the compressed data end inside their header");
    const uint64_t faces = 1000000000, points = 500000000;
    const std::string heads[] = {std::string("DRACO\x02\x02\x01\x01\0\0\0", 12) + varint(points) + varint(faces), std::string("DRACO\x02\x02\x01\0\0\0", 11) + varint(faces) + varint(points)};
    for (const std::string& head : heads)
        expect_refused(compressed_file(head + rest, primitive(), points, faces), fmt::format(": error: 1000000000 triangles and 500000000 vertices cannot have been compressed to {} bytes", head.size() + 100));
}

/// Whatever happens to the compressed bytes, the importer ends, and a scene that comes out holds together.
TEST(DracoRefused, DamagedDataEnd) {
    Grid grid;
    std::mt19937 random(11);
    size_t refused = 0;
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const std::string whole = grid.encoded(method);
        for (int i = 0; i < 1500; ++i) {
            std::string data = whole;
            if (i % 3 == 0) data.resize(1 + random() % data.size());
            for (int k = 0; k <= i % 5; ++k) data[random() % data.size()] = char(random());
            const auto result = import_text(with_asset(compressed_file(data)));
            EXPECT_TRUE(!result || !validate(result->scene).has_errors());
            refused += !result;
        }
    }
    EXPECT_GT(refused, 500u);
}

}  // namespace
}  // namespace alidade::gltf_test
