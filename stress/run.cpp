// SPDX-License-Identifier: Apache-2.0
#include "stress/run.h"

#include "core/fingerprint.h"
#include "stress/instances.h"
#include "stress/oracle.h"
#include "stress/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <set>

namespace alidade {

namespace {

constexpr size_t kBatch = 1024;     // rays between looks at the clock
constexpr size_t kSettled = 64;     // rays of a set and a peer that brute force is asked about, where it differs
constexpr size_t kFewest = 16;      // rays of each set that brute force is asked in any case

class StressRun {
  public:
    StressRun(const StressScene& scene, std::span<const RaySet> sets, std::span<const std::unique_ptr<StressPeer>> peers, const StressOptions& options, std::span<const StressPace> paces)
        : scene_(scene), sets_(sets), peers_(peers), options_(options), paces_(paces.begin(), paces.end()), budget_(options), oracle_(scene) {
        paces_.resize(peers.size());
        for (const RaySet& set : sets) rays_ += set.rays.size();
    }

    StressFigures run() {
        out_.triangles = scene_.triangles(), out_.placed_triangles = scene_.placed_triangles();
        out_.places = scene_.places.size(), out_.scene_bytes = scene_.bytes();
        for (size_t i = 0; i < peers_.size(); ++i) build(i);
        for (int round = 1; round < options_.rounds / 2; ++round) build_again();
        for (size_t s = 0; s < sets_.size(); ++s) measure(s);
        for (const auto& peer : peers_) peer->drop();
        return std::move(out_);
    }

  private:
    struct Reference {
        size_t peer;
        std::vector<StressHit> hits;
    };

    /// What the rounds of a peer took for a set of rays.
    struct Rounds {
        std::vector<double> seconds;   // CPU time of each
        EventCounts events;            // of all

        bool empty() const { return seconds.empty(); }
        void add(double took, const EventCounts& counted) {
            for (size_t e = 0; e < kEvents; ++e) events[e] = empty() ? counted[e] : counted[e] && events[e] ? std::optional(*counted[e] + *events[e]) : std::nullopt;
            seconds.push_back(took);
        }
    };

    bool stopped() {
        if (options_.stop && *options_.stop) out_.interrupted = true;
        return out_.interrupted;
    }
    bool built(size_t i) const { return out_.peers[i].left_out.empty(); }
    double primitives() const { return double(scene_.primitives()); }

    void did(double work) {
        done_ += work;
        if (options_.progress) options_.progress(done_);
    }

    void build(size_t i) {
        StressPeerFigures figures;
        figures.name = peers_[i]->name, figures.precision = peers_[i]->precision;
        figures.left_out = stopped() ? "interrupted" : budget_.admit(paces_[i], primitives(), 1, rays_, scene_.bytes() + standing_);
        if (figures.left_out.empty()) {
            try {
                const PeakMemory mark;
                const double seconds = seconds_to_build(*peers_[i]);
                figures.builds = 1, figures.build_seconds = {seconds, seconds, seconds};
                figures.peak_bytes = mark.bytes(), figures.structure = peers_[i]->structure();
                standing_ += figures.structure.bytes;
                builds_.push_back({seconds});
            } catch (const std::bad_alloc&) {
                figures.left_out = "memory ended";
            }
        }
        if (!figures.left_out.empty()) peers_[i]->drop(), builds_.emplace_back();
        did(primitives());
        out_.peers.push_back(std::move(figures));
    }

    double seconds_to_build(StressPeer& peer) const {
        const auto now = peer.threads == 1 ? thread_seconds : wall_seconds;
        const double start = now();
        peer.build(scene_);
        return now() - start;
    }

    /// All once more, if half of the time is left for the rays.
    void build_again() {
        double all = 0;
        for (const auto& seconds : builds_) all += seconds.empty() ? 0 : seconds.back();
        for (size_t i = 0; i < peers_.size(); ++i) {
            did(primitives());
            if (!built(i) || stopped() || 2 * options_.clock_factor * all > budget_.spare()) continue;
            builds_[i].push_back(seconds_to_build(*peers_[i]));
            out_.peers[i].builds = int(builds_[i].size()), out_.peers[i].build_seconds = spread_of(builds_[i]);
        }
    }

    void measure(size_t s) {
        const RaySet& set = sets_[s];
        std::vector<Rounds> rounds(peers_.size());
        references_.clear();
        const double start = wall_seconds();
        for (const bool exact : {true, false})   // the exact ones first: the others are compared with them
            for (size_t i = 0; i < peers_.size(); ++i)
                if (built(i) && peers_[i]->exact == exact) first_round(i, set, rounds[i]);
        double round_takes = wall_seconds() - start;
        check_sample(set);
        for (int round = 1; round < options_.rounds; ++round) {
            if (stopped() || double(sets_.size() - s) * round_takes * 1.2 > budget_.left()) break;
            const double again = wall_seconds();
            for (size_t i = 0; i < peers_.size(); ++i) {
                if (!rounds[i].empty()) trace(i, set, rounds[i]);
            }
            round_takes = wall_seconds() - again;
        }
        for (size_t i = 0; i < peers_.size(); ++i) {
            did(double(set.rays.size()) * options_.rounds);
            if (rounds[i].empty()) continue;
            StressRayFigures& figures = out_.peers[i].rays.back();
            figures.rounds = int(rounds[i].seconds.size()), figures.seconds = spread_of(rounds[i].seconds);
            for (size_t e = 0; e < kEvents; ++e)
                if (rounds[i].events[e]) figures.events[e] = *rounds[i].events[e] / (double(set.rays.size()) * figures.rounds);
        }
    }

    void first_round(size_t i, const RaySet& set, Rounds& rounds) {
        StressRayFigures figures;
        figures.rays = set.name, figures.question = set.question, figures.count = set.rays.size();
        const auto before = peers_[i]->work();
        figures.left_out = stopped() ? "interrupted" : set.rays.empty() ? "there are none" : budget_.admit_round(paces_[i], primitives(), set.rays.size());
        if (figures.left_out.empty()) {
            if (trace(i, set, rounds)) {
                count(figures, before, peers_[i]->work());
                compare(i, set, figures);
            } else {
                figures.left_out = stopped() ? "interrupted" : "the time was over while they were traced";
            }
        }
        out_.peers[i].rays.push_back(std::move(figures));
    }

    /// All rays of a set, into got_. False if it was broken off: then it is no round.
    bool trace(size_t i, const RaySet& set, Rounds& rounds) {
        const std::span<const StressRay> rays = set.rays;
        got_.resize(rays.size()), any_.resize(set.question == Question::any ? rays.size() : 0);
        double seconds = 0;
        for (size_t first = 0; first < rays.size(); first += kBatch) {
            if (stopped() || budget_.left() < 0) return false;
            const size_t count = std::min(kBatch, rays.size() - first);
            if (first == 0) counters_.start();
            else counters_.resume();
            const double start = thread_seconds();
            if (set.question == Question::any) peers_[i]->any(rays.subspan(first, count), std::span(any_).subspan(first, count));
            else peers_[i]->closest(rays.subspan(first, count), std::span(got_).subspan(first, count));
            seconds += thread_seconds() - start;
            counters_.stop();
        }
        for (size_t k = 0; k < any_.size(); ++k) got_[k] = any_hit(any_[k] != 0);
        rounds.add(seconds, counters_.counts());
        return true;
    }

    void count(StressRayFigures& figures, const std::optional<WorkCounters>& before, const std::optional<WorkCounters>& after) const {
        figures.hits = size_t(std::count_if(got_.begin(), got_.end(), [](const StressHit& hit) { return hit.hits(); }));
        figures.hash = fingerprint(std::as_bytes(std::span(got_)));
        if (!before || !after) return;
        const double rays = double(got_.size());
        figures.boxes = double(after->boxes - before->boxes) / rays, figures.triangles = double(after->filtered - before->filtered) / rays;
        figures.decided = double(after->primitives - before->primitives) / rays;
    }

    /// Is `got`, of a peer, what brute force's `wanted` lets it say?
    bool agrees(size_t i, const StressHit& got, const StressHit& wanted, Question question) const { return peers_[i]->exact ? got == wanted : is_near(got, wanted, question); }

    /// With the first exact peer of the precision; an inexact one, if there is none, with any other.
    void compare(size_t i, const RaySet& set, StressRayFigures& figures) {
        auto found = references_.find(peers_[i]->precision);
        if (found == references_.end() && !peers_[i]->exact) found = references_.begin();
        if (found == references_.end()) return void(references_.emplace(peers_[i]->precision, Reference{i, got_}));
        const Reference& reference = found->second;
        for (size_t k = 0; k < got_.size(); ++k) {
            if (agrees(i, got_[k], reference.hits[k], set.question)) continue;
            if (++figures.unlike <= kSettled) settle(i, reference, set, k);
        }
    }

    /// Where brute force would take too much memory, the reference is believed.
    void settle(size_t i, const Reference& reference, const RaySet& set, size_t k) {
        const StressHit wanted = oracle_fits() ? oracle_.answer(set.rays[k], set.question, peers_[reference.peer]->precision) : reference.hits[k];
        if (!agrees(i, got_[k], wanted, set.question)) accuse(i, set, k, got_[k], wanted);
        if (!agrees(reference.peer, reference.hits[k], wanted, set.question)) accuse(reference.peer, set, k, reference.hits[k], wanted);
    }

    bool oracle_fits() const { return double(out_.scene_bytes + standing_) + primitives() * double(StressOracle::kBytes) <= double(options_.bytes); }

    void check_sample(const RaySet& set) {
        for (const auto& [precision, reference] : references_) {
            const double placed = std::max(1.0, double(out_.placed_triangles)), time_for = 0.2 * budget_.left() / (placed * 2e-9);
            const size_t wanted = std::max(kFewest, size_t(std::min(1e9, options_.oracle_tests / placed)));
            size_t count = oracle_fits() ? std::min(set.rays.size(), size_t(std::clamp(time_for, 0.0, double(wanted)))) : 0;
            for (size_t j = 0; j < count; ++j) {
                const size_t k = j * set.rays.size() / count;
                if (stopped() || budget_.left() < 0) count = j;
                else if (const StressHit right = oracle_.answer(set.rays[k], set.question, precision); !agrees(reference.peer, reference.hits[k], right, set.question)) accuse(reference.peer, set, k, reference.hits[k], right);
            }
            out_.checked.push_back({set.name, precision, count});
        }
    }

    void accuse(size_t i, const RaySet& set, size_t ray, const StressHit& got, const StressHit& wanted) {
        const StressPeer& peer = *peers_[i];
        if (!peer.accountable) return;
        for (StressDisagreement& known : out_.disagreements)
            if (known.peer == peer.name && known.precision == peer.precision && known.rays == set.name) {
                known.wrong += accused_.emplace(&known - out_.disagreements.data(), ray).second;
                if (ray < known.ray) known.ray = ray, known.asked = set.rays[ray], known.got = got, known.wanted = wanted;
                return;
            }
        accused_.emplace(out_.disagreements.size(), ray);
        out_.disagreements.push_back({peer.name, peer.precision, set.name, set.question, ray, 1, set.rays[ray], got, wanted});
    }

    const StressScene& scene_;
    std::span<const RaySet> sets_;
    std::span<const std::unique_ptr<StressPeer>> peers_;
    const StressOptions& options_;
    std::vector<StressPace> paces_;
    StressBudget budget_;
    StressOracle oracle_;
    StressFigures out_;
    std::set<std::pair<size_t, size_t>> accused_;    // disagreements and their rays: several may find one wrong
    size_t rays_ = 0, standing_ = 0;
    double done_ = 0;
    std::vector<std::vector<double>> builds_;        // seconds, by peer
    std::map<std::string, Reference> references_;    // by precision, for the present set
    std::vector<StressHit> got_;
    std::vector<uint8_t> any_;
    EventCounters counters_;
};

std::string text(const StressHit& hit, Question question) {
    if (question == Question::any) return hit.hits() ? "a hit" : "no hit";
    if (!hit.hits()) return "no hit";
    return fmt::format("triangle {} of place {} at t = {}, (u, v) = ({}, {})", hit.primitive, hit.instance, hit.t, hit.u, hit.v);
}

}  // namespace

std::string StressDisagreement::sentence() const {
    return fmt::format("{} in {}, {} ray {}: {}, where {} is right; {} found wrong; origin {} {} {}, direction {} {} {}, t from {} to {}", peer, precision, rays, ray, text(got, question),
                       text(wanted, question), wrong, asked.origin.x, asked.origin.y, asked.origin.z, asked.dir.x, asked.dir.y, asked.dir.z, asked.tmin, asked.tmax);
}

StressFigures run_stress(const StressScene& scene, std::span<const RaySet> rays, std::span<const std::unique_ptr<StressPeer>> peers, const StressOptions& options,
                         std::span<const StressPace> paces) {
    return StressRun(scene, rays, peers, options, paces).run();
}

std::vector<RaySet> stress_rays(const StressScene& scene, std::vector<StressRay> primary, uint64_t seed) {
    const AcceleratorEntry& bvh = *find_accelerator("bvh");
    std::vector<std::unique_ptr<Accelerator>> meshes;
    std::vector<const Accelerator*> below;
    for (const StressMesh& mesh : scene.meshes) meshes.push_back(bvh.over_triangles(mesh.view(), {})), below.push_back(meshes.back().get());
    if (scene.places.empty()) return make_ray_sets(scene, *meshes.front(), std::move(primary), seed);
    const auto top = bvh.over_set(std::make_shared<StressInstances>(std::move(below), scene), {});
    return make_ray_sets(scene, *top, std::move(primary), seed);
}

std::vector<std::unique_ptr<StressPeer>> make_peers(std::span<const AcceleratorEntry> entries, std::span<const Precision> precisions, int threads, std::span<const Intersect> tests) {
    std::vector<std::unique_ptr<StressPeer>> peers;
    for (const AcceleratorEntry& entry : entries) {
        for (const Precision precision : precisions) {
            for (const Intersect how : tests) peers.push_back(make_own_peer(entry, {precision, Isa::best, threads, how}));
        }
    }
    return peers;
}

StressFigures stress_entries(const StressScene& scene, std::span<const AcceleratorEntry> entries, size_t side, const StressOptions& options) {
    static constexpr Precision kBoth[] = {Precision::float_, Precision::double_};
    const auto peers = make_peers(entries, kBoth);
    return run_stress(scene, stress_rays(scene, camera_rays(scene, side), 1), peers, options);
}

}  // namespace alidade
