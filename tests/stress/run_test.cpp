// SPDX-License-Identifier: Apache-2.0
/// A run finds wrong answers, takes accelerators of strangers, and keeps its budgets.
#include "stress/prediction.h"
#include "stress/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace alidade::test {
namespace {

using testing::HasSubstr;

/// A structure of our own: two halves of the mesh, each in brute force. It loses every triangle whose number divides by `lost`.
class TwoHalves : public Accelerator {
  public:
    TwoHalves(const TriangleView& mesh, const AccelOptions& options, size_t lost) : middle_(uint32_t(mesh.triangles.size() / 2)) {
        std::vector<Index3> triangles(mesh.triangles.begin(), mesh.triangles.end());
        for (size_t i = lost; lost && i < triangles.size(); i += lost) triangles[i] = Index3(0);
        const auto brute = accelerators().front().over_triangles;
        for (const auto half : {std::span(triangles).first(middle_), std::span(triangles).subspan(middle_)}) {
            halves_.push_back(brute({mesh.positions, mesh.exact_positions, half}, options));
            stats_.bytes += halves_.back()->stats().bytes, stats_.primitives += half.size();
        }
    }
    bool intersect(const Ray& ray, Hit& hit, WorkCounters& work, uint32_t instance) const override {
        bool found = false;
        for (uint32_t i = 0; i < 2; ++i) {
            Hit candidate;
            if (!halves_[i]->intersect(ray, candidate, work, instance)) continue;
            candidate.primitive += i * middle_;
            if (comes_before(candidate.t, candidate.instance, candidate.primitive, hit)) hit = candidate, found = true;
        }
        return found;
    }
    bool occluded(const Ray& ray, WorkCounters& work) const override { return halves_[0]->occluded(ray, work) || halves_[1]->occluded(ray, work); }
    void all_hits(const Ray&, std::vector<Hit>&, WorkCounters&, uint32_t) const override {}
    bool candidates(const Shaft&, size_t, std::vector<uint32_t>&) const override { return false; }
    Bounds bounds() const override {
        Bounds box = halves_[0]->bounds();
        box.extend(halves_[1]->bounds());
        return box;
    }
    const BuildStats& stats() const override { return stats_; }

  private:
    uint32_t middle_;
    std::vector<std::unique_ptr<Accelerator>> halves_;
    BuildStats stats_;
};

template <size_t lost> std::unique_ptr<Accelerator> over_triangles(const TriangleView& mesh, const AccelOptions& options) { return std::make_unique<TwoHalves>(mesh, options, lost); }
std::unique_ptr<Accelerator> over_set(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options) { return accelerators().front().over_set(std::move(set), options); }

constexpr AcceleratorEntry kHalves{"halves", "two lists", over_triangles<0>, over_set}, kLossy{"lossy", "loses a triangle in seven", over_triangles<7>, over_set};

StressOptions quick() {
    StressOptions options;
    options.rounds = 1, options.oracle_tests = 1e5;
    return options;
}

const StressPeerFigures& peer_of(const StressFigures& figures, std::string_view name) {
    return *std::find_if(figures.peers.begin(), figures.peers.end(), [&](const StressPeerFigures& peer) { return peer.name == name; });
}

TEST(StressRun, TakesAStrangersAccelerator) {
    const std::vector<AcceleratorEntry> entries{*find_accelerator("bvh"), kHalves};
    for (const char* kind : {"soup", "nested"}) {
        const StressFigures figures = stress_entries(find_stress_kind(kind)->make(600, 1), entries, 16, quick());
        EXPECT_TRUE(figures.disagreements.empty()) << figures.disagreements.front().sentence();
        const StressPeerFigures &bvh = peer_of(figures, "bvh"), &halves = peer_of(figures, "halves");
        for (size_t s = 0; s < 4; ++s) {
            EXPECT_EQ(halves.rays[s].hits, bvh.rays[s].hits);
            EXPECT_GT(*halves.rays[s].triangles, *bvh.rays[s].triangles) << "a list looks at more";
        }
        EXPECT_GT(halves.structure.bytes, 600u * 12);
    }
}

TEST(StressRun, NamesTheFirstRayOfWhoIsWrong) {
    const StressScene scene = find_stress_kind("scan")->make(2000, 1);
    const std::vector<RaySet> rays = stress_rays(scene, camera_rays(scene, 24), 1);
    for (const bool lossy_first : {false, true}) {
        std::vector<AcceleratorEntry> entries{*find_accelerator("grid"), kLossy};
        if (lossy_first) std::swap(entries[0], entries[1]);
        const auto peers = make_peers(entries, std::array{Precision::float_});
        const StressFigures figures = run_stress(scene, rays, peers, quick());
        ASSERT_GE(figures.disagreements.size(), 3u) << "for each set of rays, but perhaps any hits";
        const StressDisagreement& wrong = figures.disagreements.front();
        EXPECT_EQ(wrong.peer, "lossy");
        EXPECT_GT(wrong.wrong, 10u);
        EXPECT_EQ(wrong.wanted.primitive % 7, 0u) << "what it lost";
        EXPECT_THAT(wrong.sentence(), HasSubstr("lossy in float, primary ray "));
        // The first ray by an oracle of this test: the first one whose nearest triangle is lost.
        const auto brute = make_own_peer(accelerators().front(), {});
        brute->build(scene);
        std::vector<StressHit> hits(rays[0].rays.size());
        brute->closest(rays[0].rays, hits);
        const auto lost = std::find_if(hits.begin(), hits.end(), [](const StressHit& hit) { return hit.hits() && hit.primitive >= 7 && hit.primitive % 7 == 0; });
        EXPECT_EQ(wrong.ray, size_t(lost - hits.begin()));
        EXPECT_EQ(wrong.wanted, *lost);
    }
}

/// Rounds t, as a tracer in float does, and loses hits behind a plane if it is asked to.
class Coarse : public StressPeer {
  public:
    Coarse(bool loses, bool is_accountable) : own_(make_own_peer(*find_accelerator("bvh"), {})), loses_(loses) { name = "coarse", accountable = is_accountable; }
    void build(const StressScene& scene) override { own_->build(scene); }
    void drop() override { own_->drop(); }
    void closest(std::span<const StressRay> rays, std::span<StressHit> hits) override {
        own_->closest(rays, hits);
        for (StressHit& hit : hits) hit = loses_ && hit.primitive % 5 == 0 ? StressHit() : StressHit{double(float(hit.t)), hit.instance, hit.primitive, 0, 0};
    }
    void any(std::span<const StressRay> rays, std::span<uint8_t> hit) override { own_->any(rays, hit); }
    StressStructure structure() const override { return {}; }

  private:
    std::unique_ptr<StressPeer> own_;
    bool loses_;
};

TEST(StressRun, BelievesBruteForceAndNotWhoIsInexact) {
    const StressScene scene = find_stress_kind("scan")->make(2000, 1);
    const std::vector<RaySet> rays = stress_rays(scene, camera_rays(scene, 24), 1);
    for (const bool loses : {false, true}) {
        auto peers = make_peers(accelerators().subspan(1, 1), std::array{Precision::float_});
        peers.push_back(std::make_unique<Coarse>(loses, false));
        const StressFigures figures = run_stress(scene, rays, peers, quick());
        EXPECT_TRUE(figures.disagreements.empty()) << "ours are right";
        peers.back() = std::make_unique<Coarse>(loses, true);
        EXPECT_EQ(run_stress(scene, rays, peers, quick()).disagreements.size(), loses ? 3u : 0u) << "those that ask for the closest hit";
        EXPECT_EQ(figures.peers[1].rays[0].unlike > 0, loses);
        EXPECT_FALSE(figures.peers[1].rays[0].boxes.has_value());
    }
}

/// Who says to be exact, and is not, is the reference here: two others and the sample of brute force find the same rays wrong.
TEST(StressRun, CountsAWrongRayOnceWhoeverFindsIt) {
    const StressScene scene = find_stress_kind("scan")->make(500, 1);
    const std::vector<RaySet> rays = stress_rays(scene, camera_rays(scene, 6), 1);
    const std::array entries{*find_accelerator("bvh"), *find_accelerator("grid")};
    auto peers = make_peers(entries, std::array{Precision::float_});
    peers.insert(peers.begin(), std::make_unique<Coarse>(true, true));
    peers.front()->exact = true;
    const StressFigures figures = run_stress(scene, rays, peers, quick());
    ASSERT_EQ(figures.disagreements.front().rays, "primary");
    EXPECT_EQ(figures.disagreements.front().peer, "coarse");
    EXPECT_GT(peer_of(figures, "bvh").rays[0].unlike, 3u);
    EXPECT_EQ(figures.disagreements.front().wrong, peer_of(figures, "bvh").rays[0].unlike);
}

TEST(StressRun, BruteForceAlsoJudgesStrangersAlone) {
    const StressScene scene = find_stress_kind("scan")->make(2000, 1);
    StressOptions options = quick();
    options.oracle_tests = 1e6;
    EXPECT_FALSE(stress_entries(scene, std::array{kLossy}, 24, options).disagreements.empty());
    EXPECT_TRUE(stress_entries(scene, std::array{kHalves}, 24, options).disagreements.empty());
}

TEST(StressRun, LeavesOutWhatDoesNotFit) {
    const StressScene scene = find_stress_kind("soup")->make(20000, 1);
    const std::vector<RaySet> rays = stress_rays(scene, camera_rays(scene, 16), 1);
    const auto peers = make_peers(accelerators().subspan(1), std::array{Precision::float_});
    StressPace slow{1000, 1, 1e-6, 60000, 120000}, large{1000, 1e-4, 1e-6, 6e9, 12e9}, fine{1000, 1e-4, 1e-6, 60000, 120000};
    StressOptions options = quick();
    options.seconds = 10, options.bytes = size_t(1) << 30;
    const StressFigures figures = run_stress(scene, rays, peers, options, std::array{slow, large, fine});
    EXPECT_THAT(figures.peers[0].left_out, HasSubstr("takes about 37 s"));
    EXPECT_THAT(figures.peers[1].left_out, HasSubstr("needs about 312 GB while it is built"));
    EXPECT_EQ(figures.peers[2].left_out, "");
    EXPECT_EQ(figures.peers[2].rays.size(), 4u);
    EXPECT_TRUE(figures.peers[0].rays.empty());
    options.seconds = 60;
    EXPECT_EQ(run_stress(scene, rays, peers, options, std::array{slow, large, fine}).peers[0].left_out, "") << "37 s fit";
    options.clock_factor = 2;
    EXPECT_THAT(run_stress(scene, rays, peers, options, std::array{slow, large, fine}).peers[0].left_out, HasSubstr("takes about 75 s")) << "on a machine that others use, too";
}

TEST(StressRun, ATimeThatIsOverIsSaid) {
    const StressScene scene = find_stress_kind("soup")->make(2000, 1);
    const std::vector<RaySet> rays = stress_rays(scene, camera_rays(scene, 16), 1);
    StressOptions options = quick();
    options.seconds = 0;
    const StressFigures figures = run_stress(scene, rays, make_peers(accelerators().subspan(1, 1), std::array{Precision::float_}), options);
    for (const StressRayFigures& each : figures.peers[0].rays) EXPECT_NE(each.left_out, "") << each.rays;
}

TEST(StressRun, StopsWhenAsked) {
    const std::atomic<bool> stop = true;
    StressOptions options = quick();
    options.stop = &stop;
    const StressFigures figures = stress_entries(find_stress_kind("soup")->make(500, 1), accelerators(), 8, options);
    EXPECT_TRUE(figures.interrupted);
    for (const StressPeerFigures& peer : figures.peers) EXPECT_EQ(peer.left_out, "interrupted");
}

TEST(StressMeasure, MediansAndSpreads) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_TRUE(std::isnan(median({})));
    const Spread spread = spread_of({5, 1, 3});
    EXPECT_EQ(spread.median, 3);
    EXPECT_EQ(spread.low, 1);
    EXPECT_EQ(spread.high, 5);
}

/// Held against what is allocated: 64 MB that are written to and freed again.
TEST(StressMeasure, PeakMemoryIsWhatWasTakenAtOnce) {
    const PeakMemory mark;
    if (!mark.bytes()) GTEST_SKIP() << "the system has no mark that can be reset";
    constexpr size_t kMegabytes = 64;
    for (int i = 0; i < 3; ++i) {
        std::vector<uint8_t> memory(kMegabytes << 20, uint8_t(i + 1));
        EXPECT_EQ(memory[memory.size() / 2], i + 1);
    }
    EXPECT_GE(*mark.bytes(), (kMegabytes - 1) << 20) << "Linux counts pages in batches, a thread at a time";
#if !defined(ALIDADE_SANITIZED)   // which keep what was freed
    EXPECT_LE(*mark.bytes(), (kMegabytes + 16) << 20) << "once, not three times";
#endif
}

TEST(StressMeasure, TextsForPeople) {
    EXPECT_EQ(seconds_text(0.0213), "0.021 s");
    EXPECT_EQ(seconds_text(75.2), "75 s");
    EXPECT_EQ(bytes_text(999), "999 bytes");
    EXPECT_EQ(bytes_text(1.26e9), "1.3 GB");
    EXPECT_EQ(bytes_text(5.1e8), "510 MB");
}

}  // namespace
}  // namespace alidade::test
