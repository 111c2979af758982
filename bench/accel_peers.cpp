// SPDX-License-Identifier: Apache-2.0
/// Our accelerators beside Embree: the generated scenes, three kinds of rays, single rays, one thread.
///
/// In each round every tracer does the same work in turn, in CPU time of the thread; what is printed are medians over the rounds of the ratios within a
/// round, so that a busy machine slows all of them. Hits are compared: a speed says nothing about wrong answers.
#include "bench/words.h"
#include "stress/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade::bench {
namespace {

struct Options : Words {
    size_t rays = 256;
    Precision precision = Precision::float_;
    bool alone = false, together = false;
};

/// seconds[peer][round]
using Times = std::vector<std::vector<double>>;

/// What the peers have counted up to now.
std::vector<WorkCounters> counted(const std::vector<std::unique_ptr<StressPeer>>& peers) {
    std::vector<WorkCounters> counters;
    for (const auto& peer : peers) counters.push_back(peer->work().value_or(WorkCounters()));
    return counters;
}

/// Of each of `rays` rays since it had counted `before`.
std::string work_text(const StressPeer& peer, const WorkCounters& before, double rays) {
    const auto now = peer.work();
    if (!now) return "";
    const auto each = [rays](uint64_t from, uint64_t to) { return double(to - from) / rays; };
    return fmt::format("{:.1f} boxes, {:.1f} triangles filtered, {:.2f} decided", each(before.boxes, now->boxes), each(before.filtered, now->filtered), each(before.primitives, now->primitives));
}

/// How much faster than `reference` the peer was.
double speed_ratio(const Times& times, size_t peer, size_t reference) {
    std::vector<double> ratios;
    for (size_t round = 0; round < times[peer].size(); ++round) ratios.push_back(times[reference][round] / times[peer][round]);
    return median(std::move(ratios));
}

/// Logarithms of ratios, for the geometric mean over the scenes: [column][peer].
struct Means {
    std::vector<std::vector<std::vector<double>>> logs;

    void add(size_t column, size_t peer, double ratio) {
        if (logs.size() <= column) logs.resize(column + 1);
        if (logs[column].size() <= peer) logs[column].resize(peer + 1);
        logs[column][peer].push_back(std::log(ratio));
    }
};

/// Those of the pixels of an image, by squares of 4 x 4.
std::vector<StressRay> by_squares(const std::vector<StressRay>& rays, size_t side) {
    std::vector<StressRay> ordered;
    for (size_t y = 0; y < side; y += 4)
        for (size_t x = 0; x < side; x += 4)
            for (size_t i = 0; i < 16; ++i)
                if (x + i % 4 < side && y + i / 4 < side) ordered.push_back(rays[(y + i / 4) * side + x + i % 4]);
    return ordered;
}

class Run {
  public:
    Run(const Options& options, std::vector<std::unique_ptr<StressPeer>> peers, size_t reference)
        : options_(options), peers_(std::move(peers)), reference_(reference) {}

    void scene(const StressKind& kind, size_t triangles) {
        const StressScene scene = kind.make(triangles, 1);
        fmt::print("{}: {} triangles{}\n", kind.name, scene.triangles(), scene.places.empty() ? "" : fmt::format(", {} times", scene.places.size()));
        const double millions = 1e-6 * double(scene.triangles());
        row("build", "Mtri/s", 0, millions, interleaved(std::span<const std::unique_ptr<StressPeer>>(peers_), std::max(1, options_.rounds / 2), [&](StressPeer& peer, size_t) { peer.build(scene); }), [&](const StressPeer& peer, size_t) {
            return fmt::format("{:.1f} bytes a triangle", double(peer.structure().bytes) / double(scene.triangles()));
        });
        const std::vector<RaySet> sets = stress_rays(scene, options_.together ? by_squares(camera_rays(scene, options_.rays), options_.rays) : camera_rays(scene, options_.rays), 1);
        for (const RaySet& set : sets) {
            if (set.name == "shadow") any("shadow", 3, set.rays);
            else if (set.name != "random") closest(set.name.c_str(), set.name == "primary" ? 1 : 2, set.rays);
        }
    }

    void print_means() const {
        constexpr const char* names[] = {"build", "primary", "diffuse", "shadow"};
        for (size_t column = 0; column < means_.logs.size(); ++column) {
            for (size_t peer = 0; peer < peers_.size(); ++peer) {
                const auto& logs = means_.logs[column][peer];
                double sum = 0;
                for (const double l : logs) sum += l;
                fmt::print("geometric mean  {:8} {:14} {:.3f}  worst {:.3f}\n", names[column], peers_[peer]->name, std::exp(sum / double(logs.size())),
                           std::exp(*std::min_element(logs.begin(), logs.end())));
            }
        }
    }

  private:
    void closest(const char* name, size_t column, const std::vector<StressRay>& rays) {
        std::vector<std::vector<StressHit>> got(peers_.size(), std::vector<StressHit>(rays.size()));
        const auto before = counted(peers_);
        const Times times = interleaved(std::span<const std::unique_ptr<StressPeer>>(peers_), options_.rounds, [&](StressPeer& peer, size_t i) { peer.closest(rays, got[i]); });
        row(name, "Mray/s", column, 1e-6 * double(rays.size()), times, [&](const StressPeer& peer, size_t i) { return work_text(peer, before[i], double(rays.size()) * options_.rounds); });
        const size_t hits = size_t(std::count_if(got[0].begin(), got[0].end(), [](const StressHit& hit) { return hit.hits(); }));
        fmt::print("  {:8} {:.0f} % hit; unlike {}:", name, 100.0 * double(hits) / double(rays.size()), peers_[0]->name);
        for (size_t i = 1; i < peers_.size(); ++i) {
            size_t unlike = 0, off = 0;
            for (size_t k = 0; k < rays.size(); ++k) {
                unlike += got[i][k].hits() != got[0][k].hits();
                off += got[i][k].hits() && got[0][k].hits() && std::abs(got[i][k].t - got[0][k].t) > 1e-5 * got[0][k].t;
            }
            fmt::print("  {} {} hit or miss, {} t", peers_[i]->name, unlike, off);
        }
        fmt::print("\n");
    }

    void any(const char* name, size_t column, const std::vector<StressRay>& rays) {
        std::vector<std::vector<uint8_t>> hit(peers_.size(), std::vector<uint8_t>(rays.size()));
        const auto before = counted(peers_);
        const Times times = interleaved(std::span<const std::unique_ptr<StressPeer>>(peers_), options_.rounds, [&](StressPeer& peer, size_t i) { peer.any(rays, hit[i]); });
        row(name, "Mray/s", column, 1e-6 * double(rays.size()), times, [&](const StressPeer& peer, size_t i) { return work_text(peer, before[i], double(rays.size()) * options_.rounds); });
        fmt::print("  {:8} {:.0f} % hit; unlike {}:", name, 100.0 * double(std::count(hit[0].begin(), hit[0].end(), 1)) / double(rays.size()), peers_[0]->name);
        for (size_t i = 1; i < peers_.size(); ++i) {
            size_t unlike = 0;
            for (size_t k = 0; k < rays.size(); ++k) unlike += hit[i][k] != hit[0][k];
            fmt::print("  {} {}", peers_[i]->name, unlike);
        }
        fmt::print("\n");
    }

    template <class Note> void row(const char* what, const char* unit, size_t column, double items, const Times& times, Note&& note) {
        for (size_t i = 0; i < peers_.size(); ++i) {
            const double ratio = speed_ratio(times, i, reference_);
            means_.add(column, i, ratio);
            fmt::print("  {:8} {:14} {:8.3f} {}  {:.3f} of {}  {}\n", what, peers_[i]->name, items / median(times[i]), unit, ratio, peers_[reference_]->name, note(*peers_[i], i));
        }
        std::fflush(stdout);
    }

    Options options_;
    std::vector<std::unique_ptr<StressPeer>> peers_;
    size_t reference_;
    Means means_;
};

void run(const Options& options) {
    std::vector<std::unique_ptr<StressPeer>> peers;
    AccelOptions own;
    own.precision = options.precision;
    for (const AcceleratorEntry* entry : options.entries()) {
        peers.push_back(make_own_peer(*entry, own));
        if (!options.together) continue;
        peers.push_back(make_own_peer(*entry, own, true));
        peers.back()->name += " together";
    }
    const size_t ours = peers.size();
    if (!options.alone)
        for (auto& peer : make_embree_peers()) peers.push_back(std::move(peer));
    const size_t reference = peers.size() > ours ? ours : 0;
    Run run(options, std::move(peers), reference);
    options.for_each_kind([&](const StressKind& kind, size_t triangles) { run.scene(kind, triangles); });
    run.print_means();
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade;
    bench::Options options;
    bool is_double = false;
    CLI::App app("Our accelerators beside Embree.");
    bench::add_words(app, options);
    app.add_option("--rays", options.rays, "N x N camera rays")->check(CLI::Range(1, 1 << 14))->capture_default_str();
    app.add_flag("--double", is_double);
    app.add_flag("--alone", options.alone, "without Embree");
    app.add_flag("--together", options.together, "ours also by Accelerator::intersect_many; pixels come in squares of 4 x 4");
    return bench::parsed(app, argc, argv, [&] {
        if (is_double) options.precision = Precision::double_;
        bench::run(options);
    });
}
