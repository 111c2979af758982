// SPDX-License-Identifier: Apache-2.0
/// Structures in files: mapped ones answer as those that were saved, bit for bit, and no file, however it came to be, does more than be refused.
#include "accel/load.h"
#include "core/draws.h"
#include "core/fingerprint.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"
#include "tests/core/folder_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

namespace alidade::test {

using namespace numerics;
using testing::HasSubstr;

namespace {

class Saved : public FolderTest {
  protected:
    std::string why_not(const std::string& file, const TriangleMesh& mesh, Precision precision = Precision::float_) const {
        const auto loaded = load_accelerator(file, mesh.view(), {precision});
        return loaded ? "nothing" : loaded.error();
    }
    std::string saved(const TriangleMesh& mesh, Precision precision = Precision::float_, const char* name = "bvh") const {
        const auto done = build(*find_accelerator(name), mesh, {precision})->save(at("saved"), mesh.view());
        EXPECT_TRUE(done) << done.error();
        return text("saved");
    }
};

std::vector<TriangleMesh> meshes() {
    std::vector<TriangleMesh> all = small_meshes();
    all.push_back(battens(60)), all.push_back(geodesic_sphere(10, 0.2));
    TriangleMesh holes = geodesic_sphere(4);
    holes.name = "with triangles that are removed";
    holes.triangles.insert(holes.triangles.begin() + 9, {Index3(3, 3, 3), Index3(1, 2, 2)});
    all.push_back(holes);
    all.push_back(TriangleMesh("nothing", {Vec3(0)}, {}));
    return all;
}

/// One file serves each test of triangles.
TEST_F(Saved, AnswersAreThoseOfTheSavedStructure) {
    size_t hits = 0, asked = 0;
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        for (const TriangleMesh& source : meshes()) {
            const TriangleMesh mesh = source.read_at(precision);
            for (const char* name : {"bvh", "hlbvh"}) {
                saved(mesh, precision, name);
                for (const Intersect how : {Intersect::exact, Intersect::robust, Intersect::fast}) {
                    const AccelOptions options{precision, Isa::best, 1, how};
                    const auto built = build(*find_accelerator(name), mesh, options);
                    const auto loaded = load_accelerator(at("saved"), mesh.view(), options);
                    ASSERT_TRUE(loaded) << mesh.name << ": " << loaded.error();
                    const BuildStats &got = (*loaded)->stats(), &want = built->stats();
                    EXPECT_EQ(std::tie(got.primitives, got.references, got.splits, got.split_candidates, got.nodes, got.leaves, got.depth, got.sah_cost, got.removed),
                              std::tie(want.primitives, want.references, want.splits, want.split_candidates, want.nodes, want.leaves, want.depth, want.sah_cost, want.removed));
                    EXPECT_EQ((*loaded)->bounds().min, built->bounds().min);
                    EXPECT_EQ((*loaded)->bounds().max, built->bounds().max);
                    WorkCounters got_work, want_work;
                    for (size_t i = 0; i < run_size(60, 1000) && !mesh.triangles.empty(); ++i) {
                        const Ray ray = ray_classes()[i % ray_classes().size()].make(mesh, RandomKey(151, 0, i, 0));
                        const Answers answered = answers(*built, ray);
                        hits += answered.occluded, ++asked;
                        ASSERT_EQ(difference(answers(**loaded, ray), answered), "") << mesh.name << ": " << describe(ray);
                        Hit a, b;
                        built->intersect(ray, a, want_work), (*loaded)->intersect(ray, b, got_work);
                    }
                    EXPECT_EQ(std::pair(got_work.boxes, got_work.filtered), std::pair(want_work.boxes, want_work.filtered));
                }
            }
        }
    }
    EXPECT_GT(hits, asked / 4);
}

/// Bytes are those of the structure alone: no times, no memory that was never written, and no threads.
TEST_F(Saved, TheSameStructureGivesTheSameBytes) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        const TriangleMesh mesh = soup(9000, 0.05, 4).read_at(precision);
        const std::string first = saved(mesh, precision);
        ASSERT_TRUE(build(*find_accelerator("bvh"), mesh, {precision, Isa::scalar, 3, Intersect::fast})->save(at("again"), mesh.view()));
        EXPECT_TRUE(first == text("again"));
        ASSERT_TRUE((*load_accelerator(at("saved"), mesh.view(), {precision}))->save(at("copy"), mesh.view()));
        EXPECT_TRUE(first == text("copy"));
    }
}

/// What `robust` saved has wider boxes. It says so: they are not widened again, whoever saves it once more, and the other tests hit the same.
TEST_F(Saved, WidenedBoxesAreWidenedOnce) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        const TriangleMesh mesh = soup(3000, 0.05, 4).read_at(precision);
        const AccelOptions robust{precision, Isa::best, 1, Intersect::robust}, exact{precision};
        ASSERT_TRUE(build(*find_accelerator("bvh"), mesh, robust)->save(at("wide"), mesh.view()));
        const std::string wide = text("wide");
        EXPECT_TRUE(saved(mesh, precision) != wide);
        ASSERT_TRUE((*load_accelerator(at("wide"), mesh.view(), robust))->save(at("again"), mesh.view()));
        EXPECT_TRUE(wide == text("again"));
        const auto loaded = load_accelerator(at("wide"), mesh.view(), exact);
        ASSERT_TRUE((*loaded)->save(at("exact"), mesh.view()));
        EXPECT_TRUE(wide == text("exact"));
        ASSERT_TRUE((*load_accelerator(at("saved"), mesh.view(), robust))->save(at("late"), mesh.view()));
        EXPECT_TRUE(wide == text("late"));
        const auto built = build(*find_accelerator("bvh"), mesh, exact);
        for (size_t i = 0; i < run_size(200, 2000); ++i) {
            const Ray ray = ray_classes()[i % ray_classes().size()].make(mesh, RandomKey(152, 0, i, 0));
            ASSERT_EQ(difference(answers(**loaded, ray), answers(*built, ray)), "") << describe(ray);
        }
    }
}

/// Who replaces a file does not touch those who have mapped it.
TEST_F(Saved, AReplacedFileStaysMapped) {
    const TriangleMesh mesh = torus(16, 10).read_at(Precision::float_), other = cube(3).read_at(Precision::float_);
    saved(mesh);
    const auto loaded = load_accelerator(at("saved"), mesh.view(), {});
    ASSERT_TRUE(loaded);
    saved(other);
    EXPECT_THAT(why_not(at("saved"), mesh), HasSubstr("built over other triangles"));
    const auto built = build(*find_accelerator("bvh"), mesh, {});
    for (size_t i = 0; i < 100; ++i) {
        const Ray ray = ray_classes().front().make(mesh, RandomKey(152, 0, i, 0));
        ASSERT_EQ(difference(answers(**loaded, ray), answers(*built, ray)), "");
    }
}

TEST_F(Saved, WhatIsNoSuchFileIsToldSo) {
    const TriangleMesh mesh = cube(2).read_at(Precision::float_);
    const std::string bytes = saved(mesh);
    EXPECT_THAT(why_not(at("nowhere"), mesh), HasSubstr("No such file"));
    EXPECT_THAT(why_not(folder_.string(), mesh), HasSubstr("not a regular file"));
    EXPECT_THAT(why_not(put("empty", ""), mesh), HasSubstr("holds no BVH"));
    EXPECT_THAT(why_not(put("text", std::string(5000, 'x')), mesh), HasSubstr("holds no BVH"));
    EXPECT_THAT(why_not(at("saved"), mesh, Precision::double_), HasSubstr("float, asked for are double"));
    EXPECT_THAT(why_not(put("longer", bytes + "x"), mesh), HasSubstr(std::to_string(bytes.size() + 1) + " bytes of " + std::to_string(bytes.size())));
    std::string other = bytes;
    other[8] = 2;
    EXPECT_THAT(why_not(put("version", other), mesh), HasSubstr("version 2, this program reads 1"));
    other = bytes, std::reverse(other.begin() + 12, other.begin() + 16);
    EXPECT_THAT(why_not(put("order", other), mesh), HasSubstr("order of bytes"));
    TriangleMesh moved = mesh;
    moved.positions[3].x = std::nextafter(moved.positions[3].x, 9.0f);
    EXPECT_THAT(why_not(at("saved"), moved), HasSubstr("built over other triangles"));
    TriangleMesh turned = mesh;
    std::swap(turned.triangles[0].x, turned.triangles[0].y);
    EXPECT_THAT(why_not(at("saved"), turned), HasSubstr("built over other triangles"));
}

TEST_F(Saved, NoCutAndNoChangedByteGoesUnseen) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        const TriangleMesh mesh = cube(2).read_at(precision);
        const std::string bytes = saved(mesh, precision);
        for (size_t i = 0; i < bytes.size(); i += 7) {
            std::string other = bytes;
            other[i] = char(other[i] ^ (1 << i % 8));
            ASSERT_THAT(why_not(put("changed", other), mesh, precision), HasSubstr("changed")) << i;
            ASSERT_TRUE(i % 2 || why_not(put("cut", bytes.substr(0, i)), mesh, precision) != "nothing") << i;
        }
    }
}

TEST_F(Saved, WhatHasNoFormatSaysSo) {
    const TriangleMesh mesh = cube(2).read_at(Precision::float_);
    for (const AcceleratorEntry& entry : accelerators()) {
        const bool can = std::string_view(entry.name).ends_with("bvh");
        EXPECT_EQ(build(entry, mesh, {})->save(at(entry.name), mesh.view()).has_value(), can) << entry.name;
        EXPECT_EQ(std::filesystem::exists(at(entry.name)), can) << entry.name;
    }
    const auto nowhere = build(*find_accelerator("bvh"), mesh, {})->save(at("no/folder"), mesh.view());
    ASSERT_FALSE(nowhere);
    EXPECT_THAT(nowhere.error(), HasSubstr("cannot write"));
}

/// A file as docs/accelerators.md describes it, that can be forged: its checksum is made right again.
class Forged {
  public:
    static constexpr size_t kHead = 256, kNode = 256, kBlock = 320, kChild = 192, kId = 288;

    explicit Forged(std::string bytes) : bytes_(std::move(bytes)) {}
    size_t nodes() const { return get<uint64_t>(56); }
    size_t blocks() const { return get<uint64_t>(64); }
    size_t node(size_t i) const { return kHead + i * kNode; }
    size_t block(size_t i) const { return kHead + nodes() * kNode + i * kBlock; }

    template <class T> T get(size_t at) const {
        T value;
        std::memcpy(&value, bytes_.data() + at, sizeof(T));
        return value;
    }
    template <class T> Forged& set(size_t at, T value) {
        std::memcpy(bytes_.data() + at, &value, sizeof(T));
        return *this;
    }
    size_t size() const { return bytes_.size(); }

    std::string sealed() {
        set<uint64_t>(40, 0);
        const auto all = std::as_bytes(std::span(bytes_));
        const size_t removed = std::clamp(block(blocks()), kHead, all.size()), first = std::clamp(block(0), kHead, removed);   // sizes may be claimed
        uint64_t sum = fingerprint_of_array(all.first(kHead));
        for (const auto part : {all.subspan(kHead, first - kHead), all.subspan(first, removed - first), all.subspan(removed)}) sum = fingerprint_of_array(part, sum);
        return set(40, sum).bytes_;
    }

  private:
    std::string bytes_;
};

TEST_F(Saved, ForgedFilesAreRefused) {
    TriangleMesh mesh = geodesic_sphere(6);
    mesh.triangles.push_back(Index3(0, 0, 0)), mesh.triangles.push_back(Index3(0, 1, 4000000000u));
    mesh = mesh.read_at(Precision::float_);
    const Forged right(saved(mesh));
    ASSERT_EQ(why_not(put("right", Forged(right).sealed()), mesh), "nothing");
    ASSERT_GT(right.nodes(), 10u);
    size_t count = 0;
    const auto refused = [&](const char* what, Forged forged) {
        ++count;
        EXPECT_THAT(why_not(put(std::to_string(count), forged.sealed()), mesh), HasSubstr("no tree over the triangles")) << what;
    };
    const size_t child = right.node(0) + Forged::kChild, leaf_node = right.node(right.nodes() - 1) + Forged::kChild;
    const uint32_t last = right.get<uint32_t>(leaf_node);
    ASSERT_TRUE(last >> 31);
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    refused("a node that is its own child", Forged(right).set<uint32_t>(child, 0));
    refused("a child that does not exist", Forged(right).set(child, uint32_t(right.nodes())));
    refused("the same child twice", Forged(right).set(child + 4, right.get<uint32_t>(child)));
    size_t n = 0;   // a node with room for another child: the last node, which is some other's already
    while (n + 1 < right.nodes() && right.get<uint32_t>(right.node(n) + Forged::kChild + 28) != 1u << 31) ++n;
    ASSERT_LT(n + 1, right.nodes());
    Forged knotted = right;
    for (size_t plane = 0; plane < 6; ++plane) knotted.set(right.node(n) + 32 * plane + 28, right.get<float>(right.node(n) + 32 * plane));
    refused("a child that two have", knotted.set(right.node(n) + Forged::kChild + 28, uint32_t(right.nodes() - 1)));
    refused("a block that does not exist", Forged(right).set(leaf_node, uint32_t(1u << 31 | right.blocks() << 3)));
    refused("the same block twice", Forged(right).set(leaf_node + 4, last));
    refused("more triangles than a leaf has", Forged(right).set(leaf_node, last | 7u));
    refused("fewer triangles than a leaf has", Forged(right).set(leaf_node, last & ~7u));
    refused("a triangle that does not exist", Forged(right).set<uint32_t>(right.block(0) + Forged::kId, uint32_t(mesh.triangles.size())));
    refused("a triangle with a vertex that does not exist", Forged(right).set<uint32_t>(right.block(0) + Forged::kId, uint32_t(mesh.triangles.size() - 1)));
    refused("another triangle", Forged(right).set<uint32_t>(right.block(0) + Forged::kId, right.get<uint32_t>(right.block(1) + Forged::kId)));
    refused("a corner that is not the mesh's", Forged(right).set(right.block(0), nan));
    refused("a box that is not a number", Forged(right).set(right.node(0), nan));
    refused("a box without an end", Forged(right).set(right.node(0), -inf));
    refused("a box that is inside out", Forged(right).set(right.node(0), 9.0f));
    refused("bounds that are not a number", Forged(right).set(104, std::nan("")));
    refused("no bounds", Forged(right).set(104, kInf));
    refused("a removed triangle that does not exist", Forged(right).set<uint32_t>(right.block(right.blocks()), 4000000000u));
    refused("a removed triangle twice", Forged(right).set<uint32_t>(right.block(right.blocks()) + 4, right.get<uint32_t>(right.block(right.blocks()))));
    refused("a removed triangle that is in a leaf", Forged(right).set<uint32_t>(right.block(right.blocks()), 3));
}

/// Numbers in the head that would make sizes overflow.
TEST_F(Saved, ClaimedSizesAreNotBelieved) {
    const TriangleMesh mesh = geodesic_sphere(4).read_at(Precision::float_);
    const Forged right(saved(mesh));
    for (const size_t at : {32u, 56u, 64u, 72u})
        for (const uint64_t claim : {uint64_t(0), uint64_t(1), uint64_t(1) << 31, uint64_t(1) << 58, ~uint64_t(0), ~uint64_t(0) / 256 + 2}) {
            Forged forged = right;
            EXPECT_TRUE((at == 72 && claim == 0) || why_not(put("claims", forged.set(at, claim).sealed()), mesh) != "nothing") << at << ' ' << claim;
        }
}

/// Whatever is in a file that is taken, a ray comes back from it, with a triangle that there is.
TEST_F(Saved, RaysComeBackFromRandomlyForgedFiles) {
    const TriangleMesh mesh = geodesic_sphere(6, 0.2).read_at(Precision::float_);
    const Forged right(saved(mesh));
    size_t taken = 0;
    const size_t count = run_size(1000, 100000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(153, 0, n, 0));
        Forged forged = right;
        for (uint32_t k = 0; k <= draws.below(3); ++k) {
            const size_t at = draws.below(2) ? right.node(draws.below(uint32_t(right.nodes()))) + 4 * draws.below(56) : 56 + 4 * draws.below(uint32_t(right.size() / 4 - 14));
            const uint32_t old = right.get<uint32_t>(at);
            forged.set(at, draws.coin() ? old ^ 1u << draws.below(32) : draws.coin() ? uint32_t(draws.below(300)) : std::bit_cast<uint32_t>(float(draws.uniform(-2, 2))));
        }
        const auto loaded = load_accelerator(put("forged", forged.sealed()), mesh.view(), {});
        if (!loaded) continue;
        ++taken;
        for (size_t i = 0; i < 20; ++i) {
            const Answers got = answers(**loaded, ray_classes()[i % ray_classes().size()].make(mesh, RandomKey(154, 0, i, 0)));
            ASSERT_TRUE(!got.first.valid() || got.first.primitive < mesh.triangles.size());
        }
    }
    EXPECT_GT(taken, count / 20) << "boxes that are merely wrong cannot be told";
}

}  // namespace
}  // namespace alidade::test
