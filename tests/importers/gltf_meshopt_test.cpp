// SPDX-License-Identifier: Apache-2.0
/// Compressed buffer views. The oracle of the three modes is meshoptimizer's encoder; that of the filters is the text of EXT_meshopt_compression.
#include "importers/gltf/meshopt.h"
#include "scene/queries.h"
#include "tests/importers/gltf_text.h"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>
#include <random>

namespace alidade::gltf_test {
namespace {

using gltf::Bytes;
using testing::HasSubstr;

struct View {
    std::string mode, filter;
    size_t stride = 0, count = 0;
    std::string data;   ///< compressed
};

std::string extension(const View& v, size_t offset) {
    const std::string filter = v.filter.empty() ? "" : fmt::format(R"(,"filter":"{}")", v.filter);
    return fmt::format(R"("extensions":{{"EXT_meshopt_compression":{{"buffer":0,"byteOffset":{},"byteLength":{},"byteStride":{},"count":{},"mode":"{}"{}}}}})",
                       offset, v.data.size(), v.stride, v.count, v.mode, filter);
}

std::string encoded_vertices(const std::string& plain, size_t stride) {
    const size_t count = plain.size() / stride;
    std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
    out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), plain.data(), count, stride));
    return out;
}

std::string encoded_indices(const std::vector<uint32_t>& indices, bool triangles) {
    std::string out(meshopt_encodeIndexBufferBound(indices.size(), 1000) + meshopt_encodeIndexSequenceBound(indices.size(), 1000), '\0');
    auto* to = reinterpret_cast<unsigned char*>(out.data());
    out.resize(triangles ? meshopt_encodeIndexBuffer(to, out.size(), indices.data(), indices.size())
                         : meshopt_encodeIndexSequence(to, out.size(), indices.data(), indices.size()));
    return out;
}

/// What the one view of a file decodes to; empty, and the messages in `said`, if it does not.
std::string decoded(const View& v, std::string* said = nullptr) {
    gltf::Json root = gltf::Json::parse(fmt::format(R"({{"buffers":[{{}},{{}}],"bufferViews":[{{"buffer":1,"byteLength":{},{}}}]}})", v.stride * v.count, extension(v, 0)));
    std::vector<Bytes> buffers{Bytes(v.data.begin(), v.data.end()), {}};
    gltf::Reporter report("test.gltf", false);
    gltf::decompress_views(root, buffers, report);
    if (said) *said = report.diagnostics().text();
    if (report.failed()) return {};
    const Bytes& out = buffers[root["bufferViews"][0]["buffer"].get<size_t>()];
    EXPECT_EQ(out.size(), root["bufferViews"][0]["byteLength"].get<size_t>());
    return std::string(out.begin(), out.end());
}

/// A grid of 9 x 9 vertices and its triangles.
struct Grid {
    std::vector<float> positions;
    std::vector<uint32_t> indices;
    Grid() {
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) positions.insert(positions.end(), {float(x), float(y) / 3, std::sin(float(x * y))});
        for (uint32_t y = 0; y < 8; ++y)
            for (uint32_t x = 0; x < 8; ++x) {
                const uint32_t a = 9 * y + x;
                for (const uint32_t i : {a, a + 1, a + 10, a, a + 10, a + 9}) indices.push_back(i);
            }
    }
    std::string position_bytes() const { return {reinterpret_cast<const char*>(positions.data()), positions.size() * 4}; }
    template <class T> std::string index_bytes() const {
        std::string out;
        for (const uint32_t i : indices) out += packed<T>({T(i)});
        return out;
    }
};

/// The grid as a file whose index view is `indices`, compressed or plain.
std::string grid_file(const std::string& views, const std::string& buffers, int component_type) {
    const Grid grid;
    return fmt::format(R"("scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":81,"type":"VEC3"}},{{"bufferView":1,"componentType":{},"count":{},"type":"SCALAR"}}],
        "bufferViews":[{}],"buffers":[{}])", component_type, grid.indices.size(), views, buffers);
}

/// A file whose views are compressed, and whose uncompressed buffer has no data at all, is the same scene as the plain file.
TEST(Meshopt, EveryModeGivesTheSceneOfThePlainFile) {
    const Grid grid;
    for (const bool triangles : {true, false}) {
        for (const size_t bytes : {size_t(2), size_t(4)}) {
            const std::string indices = bytes == 2 ? grid.index_bytes<uint16_t>() : grid.index_bytes<uint32_t>();
            const std::string plain = grid.position_bytes() + indices;
            const std::string plain_views = fmt::format(R"({{"buffer":0,"byteLength":972}},{{"buffer":0,"byteOffset":972,"byteLength":{}}})", indices.size());
            const View a{"ATTRIBUTES", "", 12, 81, encoded_vertices(grid.position_bytes(), 12)};
            const View b{triangles ? "TRIANGLES" : "INDICES", "", bytes, grid.indices.size(), encoded_indices(grid.indices, triangles)};
            const std::string views = fmt::format(R"({{"buffer":1,"byteLength":972,{}}},{{"buffer":1,"byteOffset":972,"byteLength":{},{}}})", extension(a, 0), indices.size(), extension(b, a.data.size()));
            const std::string fallback = fmt::format(R"(,{{"byteLength":{},"extensions":{{"EXT_meshopt_compression":{{"fallback":true}}}}}})", plain.size());
            const int type = bytes == 2 ? 5123 : 5125;
            const Scene want = scene_of(grid_file(plain_views, buffer_json(plain), type));
            const Scene got = scene_of(grid_file(views, buffer_json(a.data + b.data) + fallback, type) +
                                       R"(,"extensionsUsed":["EXT_meshopt_compression"],"extensionsRequired":["EXT_meshopt_compression"])");
            ASSERT_EQ(std::get<Mesh>(want.shapes.at(0).geometry).triangles.size(), 128u);
            // The codec may rotate a triangle, which changes no surface: compare from the smallest corner on.
            Scene a_scene = want, b_scene = got;
            for (Scene* s : {&a_scene, &b_scene})
                for (Index3& t : std::get<Mesh>(s->shapes[0].geometry).triangles)
                    while (t.x > t.y || t.x > t.z) t = Index3(t.y, t.z, t.x);
            EXPECT_EQ(dump(b_scene), dump(a_scene)) << b.mode << " of " << bytes << " bytes";
        }
    }
}

/// What is not shown may stay unread: its views then ask nothing of the buffer without data that they share with what is shown.
TEST(Meshopt, WhatIsNotShownLeavesTheFallbackUnread) {
    const Grid grid;
    const View a{"ATTRIBUTES", "", 12, 81, encoded_vertices(grid.position_bytes(), 12)};
    const View b{"TRIANGLES", "", 4, grid.indices.size(), encoded_indices(grid.indices, true)};
    const std::string file = fmt::format(R"("scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}},{{"mesh":1}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}},{{"primitives":[{{"attributes":{{"POSITION":2}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":81,"type":"VEC3"}},{{"bufferView":1,"componentType":5125,"count":{0},"type":"SCALAR"}},{{"bufferView":2,"componentType":5126,"count":81,"type":"VEC3"}}],
        "bufferViews":[{{"buffer":1,"byteLength":972,{1}}},{{"buffer":1,"byteOffset":972,"byteLength":{2},{3}}},{{"buffer":1,"byteLength":972,{1}}}],
        "buffers":[{4},{{"byteLength":{5},"extensions":{{"EXT_meshopt_compression":{{"fallback":true}}}}}}],
        "extensionsUsed":["EXT_meshopt_compression"],"extensionsRequired":["EXT_meshopt_compression"])",
        grid.indices.size(), extension(a, 0), 4 * grid.indices.size(), extension(b, a.data.size()), buffer_json(a.data + b.data), 972 + 4 * grid.indices.size());
    ImportOptions shown;
    shown.shown_only = true;
    EXPECT_EQ(std::get<Mesh>(scene_of(file, shown).shapes.at(0).geometry).triangles.size(), 128u);
    EXPECT_EQ(std::get<Mesh>(scene_of(file).shapes.at(0).geometry).triangles.size(), 128u);
}

// ---- filters ----

/// A signed component of `bits`, normalised to [-1, 1].
template <class T> double unit(T v) { return std::max(double(v) / std::numeric_limits<T>::max(), -1.0); }

/// Octahedral: z = 1 - |x| - |y|, the lower half folded over, then normalised. The third component holds what 1 is.
template <class T> void check_octahedral() {
    std::mt19937 random(7);
    std::string plain;
    std::vector<std::array<T, 4>> in;
    for (int i = 0; i < 100; ++i) {
        const int one = std::numeric_limits<T>::max() >> (i % 3);
        const auto component = [&] { return T(int(random() % unsigned(2 * one + 1)) - one); };
        in.push_back({component(), component(), T(one), T(i)});
        plain.append(reinterpret_cast<const char*>(in.back().data()), sizeof in.back());
    }
    const std::string out = decoded({"ATTRIBUTES", "OCTAHEDRAL", 4 * sizeof(T), in.size(), encoded_vertices(plain, 4 * sizeof(T))});
    ASSERT_EQ(out.size(), plain.size());
    for (size_t i = 0; i < in.size(); ++i) {
        double x = double(in[i][0]) / in[i][2], y = double(in[i][1]) / in[i][2];
        const double z = 1 - std::abs(x) - std::abs(y), t = std::min(z, 0.0);
        x += x >= 0 ? t : -t, y += y >= 0 ? t : -t;
        const double length = std::sqrt(x * x + y * y + z * z);
        std::array<T, 4> got;
        std::memcpy(got.data(), out.data() + i * sizeof got, sizeof got);
        const double step = 1.0 / std::numeric_limits<T>::max();
        EXPECT_NEAR(unit(got[0]), x / length, step) << i;
        EXPECT_NEAR(unit(got[1]), y / length, step) << i;
        EXPECT_NEAR(unit(got[2]), z / length, step) << i;
        EXPECT_EQ(got[3], in[i][3]) << "the fourth component is not touched";
    }
}
TEST(MeshoptFilter, Octahedral) {
    check_octahedral<int8_t>();
    check_octahedral<int16_t>();
}

/// Quaternion: three components times sqrt(2), the largest one left out; its place is in the two lowest bits of the fourth.
TEST(MeshoptFilter, Quaternion) {
    std::mt19937 random(8);
    std::normal_distribution<double> normal;
    std::string plain;
    std::vector<std::array<double, 4>> want;
    for (int i = 0; i < 200; ++i) {
        std::array<double, 4> q{normal(random), normal(random), normal(random), normal(random)};
        const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        size_t largest = 0;
        for (size_t c = 1; c < 4; ++c) largest = std::abs(q[c]) > std::abs(q[largest]) ? c : largest;
        const double sign = q[largest] < 0 ? -1 : 1;
        for (double& c : q) c *= sign / length;
        std::array<int16_t, 4> in{};
        for (size_t k = 0; k < 3; ++k) in[k] = int16_t(std::lround(q[(largest + 1 + k) % 4] * std::sqrt(2.0) * 32767));
        in[3] = int16_t((32767 & ~3) | int(largest));
        plain.append(reinterpret_cast<const char*>(in.data()), sizeof in);
        want.push_back(q);
    }
    const std::string out = decoded({"ATTRIBUTES", "QUATERNION", 8, want.size(), encoded_vertices(plain, 8)});
    ASSERT_EQ(out.size(), plain.size());
    for (size_t i = 0; i < want.size(); ++i) {
        int16_t got[4];
        std::memcpy(got, out.data() + 8 * i, 8);
        for (size_t c = 0; c < 4; ++c) EXPECT_NEAR(unit(got[c]), want[i][c], 2e-4) << i << " " << c;
    }
}

/// Exponential: 8 bits of exponent over 24 bits of mantissa, both signed: exactly m 2^e.
TEST(MeshoptFilter, Exponential) {
    std::mt19937 random(9);
    std::vector<float> want;
    std::string plain;
    for (int i = 0; i < 300; ++i) {
        const int e = int(random() % 60) - 40, m = int(random() % (1u << 24)) - (1 << 23);
        want.push_back(std::ldexp(float(m), e));
        plain += packed<uint32_t>({uint32_t(e) << 24 | (uint32_t(m) & 0xffffff)});
    }
    const std::string out = decoded({"ATTRIBUTES", "EXPONENTIAL", 12, 100, encoded_vertices(plain, 12)});
    ASSERT_EQ(out.size(), plain.size());
    EXPECT_EQ(std::memcmp(out.data(), want.data(), out.size()), 0);
}

// ---- what is refused ----

struct Refused {
    View view;
    const char* message;
};
void PrintTo(const Refused& r, std::ostream* out) { *out << r.message; }

class MeshoptRefused : public testing::TestWithParam<Refused> {};

TEST_P(MeshoptRefused, AtTheExtension) {
    View view = GetParam().view;
    if (view.data.empty()) view.data = encoded_vertices(std::string(48, 'x'), 12);
    std::string said;
    EXPECT_EQ(decoded(view, &said), "");
    EXPECT_THAT(said, HasSubstr(std::string("test.gltf:/bufferViews/0/extensions/EXT_meshopt_compression: error: ") + GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(Rules, MeshoptRefused, testing::Values(
    Refused{{"ATTRIBUTES", "", 6, 8, ""}, "attributes need a byteStride that is a multiple of 4, not 6"},
    Refused{{"INDICES", "", 8, 3, ""}, "indices need a byteStride of 2 or 4, not 8"},
    Refused{{"TRIANGLES", "", 4, 4, ""}, "triangles need a count that is a multiple of 3, not 4"},
    Refused{{"TRIANGLES", "OCTAHEDRAL", 4, 3, ""}, "only attributes can have a filter"},
    Refused{{"ATTRIBUTES", "OCTAHEDRAL", 12, 4, ""}, "the filter OCTAHEDRAL needs a byteStride of 4 or 8, not 12"},
    Refused{{"ATTRIBUTES", "QUATERNION", 4, 12, ""}, "the filter QUATERNION needs a byteStride of 8, not 4"},
    Refused{{"ATTRIBUTES", "", 12, 2000000000, ""}, "2000000000 elements cannot have been compressed to"},
    Refused{{"TRIANGLES", "", 4, 1999999998, ""}, "1999999998 elements cannot have been compressed to"},
    Refused{{"INDICES", "", 4, 2000000000, ""}, "2000000000 elements cannot have been compressed to"},
    Refused{{"ATTRIBUTES", "", 12, 4, std::string(50, '\0')}, "the compressed data are damaged"},
    Refused{{"ATTRIBUTES", "COLOR", 4, 12, ""}, "this form of KHR_meshopt_compression is not supported"},
    Refused{{"ATTRIBUTES", "", 12, 4, "\xa1" + std::string(49, '\0')}, "this form of KHR_meshopt_compression is not supported"}));

/// Views that all use the same bytes could ask for any amount of memory.
TEST(Meshopt, BytesCannotBeUsedAgainAndAgain) {
    const std::string data = encoded_vertices(std::string(256 * 256, '\0'), 256);
    const View view{"ATTRIBUTES", "", 256, 256, data};
    std::string views;
    for (int i = 0; i < 1000; ++i) views += fmt::format(R"({}{{"buffer":1,"byteLength":65536,{}}})", i ? "," : "", extension(view, 0));
    const auto result = import_text(with_asset(fmt::format(R"("bufferViews":[{}],"buffers":[{},{{"byteLength":65536}}])", views, buffer_json(data))));
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().text(), HasSubstr("the compressed views use the bytes of their buffers many times over"));
}

/// Whatever happens to the compressed bytes, decoding ends, in a message or in bytes of the right number.
TEST(Meshopt, DamagedDataEnd) {
    const Grid grid;
    const View views[] = {{"ATTRIBUTES", "", 12, 81, encoded_vertices(grid.position_bytes(), 12)},
                          {"ATTRIBUTES", "EXPONENTIAL", 12, 81, encoded_vertices(grid.position_bytes(), 12)},
                          {"TRIANGLES", "", 2, grid.indices.size(), encoded_indices(grid.indices, true)},
                          {"INDICES", "", 4, grid.indices.size(), encoded_indices(grid.indices, false)}};
    std::mt19937 random(10);
    size_t refused = 0, read = 0;
    for (const View& view : views) {
        for (int i = 0; i < 2000; ++i) {
            View damaged = view;
            if (i % 2) damaged.data.resize(1 + random() % view.data.size());
            for (int k = 0; k < i % 7; ++k) damaged.data[random() % damaged.data.size()] = char(random());
            ++(decoded(damaged).empty() ? refused : read);
        }
    }
    EXPECT_GT(refused, 3000u);
    EXPECT_GT(read, 1000u);
}

}  // namespace
}  // namespace alidade::gltf_test
