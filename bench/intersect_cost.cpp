// SPDX-License-Identifier: Apache-2.0
/// What the tests of triangles cost: the BVH with each of them beside each other, on the made scenes and the four kinds of rays. bench/intersect.py makes its page.
#include "accel/intersect.h"
#include "bench/words.h"
#include "stress/measure.h"
#include "stress/run.h"

#include <fmt/format.h>

#include <cmath>

namespace alidade::bench {
namespace {

struct Options : Words {
    std::string counted;   ///< this test alone, once, in intersect_cost_counted(), for callgrind
    size_t rays = 96;
    std::vector<Precision> precisions{Precision::float_};
};

/// A test of triangles in a precision. The first of all are what the others are compared with: those of fast.
struct Contender {
    std::string name;
    AccelOptions options;
};
std::vector<Contender> contenders(const Options& options) {
    std::vector<Contender> list;
    for (const Precision precision : options.precisions)
        for (const IntersectEntry& row : intersects())
            list.push_back({std::string(row.name) + (options.precisions.size() == 1 ? "" : precision == Precision::float_ ? " float" : " double"), {precision, Isa::best, 1, row.value}});
    return list;
}

/// 97.5 % of Student's distribution with `n` - 1 degrees of freedom, for the interval of a mean: the table at 20, else its limit's expansion (to 1 % from 5 on).
double student(size_t n) {
    const double z = 1.959964, f = double(n - 1);
    return z + (z * z * z + z) / (4 * f) + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * f * f);
}

/// A geometric mean of ratios less 1, and the ends of its 95 % interval.
struct Loss {
    double mean, low, high;
};
Loss loss_of(const std::vector<double>& logs) {
    double sum = 0, squares = 0;
    for (const double l : logs) sum += l;
    const double n = double(logs.size()), mean = sum / n;
    for (const double l : logs) squares += (l - mean) * (l - mean);
    const double half = logs.size() > 1 ? student(logs.size()) * std::sqrt(squares / (n - 1) / n) : kInf;
    return {std::expm1(mean), std::expm1(mean - half), std::expm1(mean + half)};
}

class Run {
  public:
    explicit Run(const Options& options) : options_(options), contenders_(contenders(options)), logs_(contenders_.size(), std::vector<double>(size_t(options.rounds))) {
        for (const Contender& one : contenders_) peers_.push_back(make_own_peer(*options.entries().front(), one.options));
    }

    void scene(const StressKind& kind, size_t triangles) {
        const StressScene scene = kind.make(triangles, 1);
        for (auto& peer : peers_) peer->build(scene);
        for (const RaySet& set : stress_rays(scene, camera_rays(scene, options_.rays), 1)) {
            std::vector<StressHit> hits(set.rays.size());
            std::vector<uint8_t> hit(set.rays.size());
            const auto ask = [&](StressPeer& peer, size_t) { set.question == Question::any ? peer.any(set.rays, hit) : peer.closest(set.rays, hits); };
            interleaved(std::span<const std::unique_ptr<StressPeer>>(peers_), 1, ask);   // to warm up
            const auto seconds = interleaved(std::span<const std::unique_ptr<StressPeer>>(peers_), options_.rounds, ask);
            add(fmt::format("{} | {}", kind.name, set.name), seconds);
        }
        for (auto& peer : peers_) peer->drop();
    }

    void print_means() const {
        for (size_t i = 0; i < peers_.size(); ++i) {
            if (i == fast()) continue;
            std::vector<double> means = logs_[i];
            for (double& l : means) l /= double(sets_);
            const Loss loss = loss_of(means);
            fmt::print("mean | {} | {:.2f} | {:.2f} | {:.2f}\n", contenders_[i].name, 100 * loss.mean, 100 * loss.low, 100 * loss.high);
        }
    }

  private:
    static size_t fast() { return size_t(Intersect::fast); }   ///< of the first precision

    void add(const std::string& what, const std::vector<std::vector<double>>& seconds) {
        ++sets_;
        std::string text = "row | " + what;
        for (size_t i = 0; i < peers_.size(); ++i) {
            std::vector<double> logs;
            for (size_t round = 0; round < seconds[i].size(); ++round) logs.push_back(std::log(seconds[i][round] / seconds[fast()][round])), logs_[i][round] += logs.back();
            if (i != fast()) text += fmt::format(" | {:.1f}", 100 * std::expm1(median(logs)));
        }
        fmt::print("{}\n", text);
        std::fflush(stdout);
    }

    Options options_;
    std::vector<Contender> contenders_;
    std::vector<std::unique_ptr<StressPeer>> peers_;
    std::vector<std::vector<double>> logs_;   ///< [contender][round]: sums over the sets of rays
    size_t sets_ = 0;
};

/// All that is asked of callgrind: --toggle-collect=intersect_cost_counted.
extern "C" [[gnu::noinline]] void intersect_cost_counted(StressPeer& peer, const RaySet& set) {
    std::vector<StressHit> hits(set.rays.size());
    std::vector<uint8_t> hit(set.rays.size());
    set.question == Question::any ? peer.any(set.rays, hit) : peer.closest(set.rays, hits);
}

void count(const Options& options, const Contender& one) {
    options.for_each_kind([&](const StressKind& kind, size_t triangles) {
        const StressScene scene = kind.make(triangles, 1);
        const auto peer = make_own_peer(*options.entries().front(), one.options);
        peer->build(scene);
        for (const RaySet& set : stress_rays(scene, camera_rays(scene, options.rays), 1)) intersect_cost_counted(*peer, set);
    });
}

void run(const Options& options) {
    for (const Contender& one : contenders(options))
        if (name(one.options.intersect) == options.counted) return count(options, one);
    Run run(options);
    options.for_each_kind([&](const StressKind& kind, size_t triangles) { run.scene(kind, triangles); });
    run.print_means();
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade;
    bench::Options options;
    options.scale = 0.1, options.rounds = 21;
    std::string precision = "float";
    CLI::App app("What the tests of triangles cost.");
    bench::add_words(app, options);
    app.get_option("--accel")->expected(1);
    app.add_option("--rays", options.rays, "N x N camera rays")->check(CLI::Range(1, 1 << 14))->capture_default_str();
    app.add_option("--precision", precision)->check(CLI::IsMember({"float", "double", "both"}))->capture_default_str();
    app.add_option("--count", options.counted, "this test alone, for callgrind")->check(CLI::IsMember(bench::names(intersects())));
    return bench::parsed(app, argc, argv, [&] {
        if (precision != "float") options.precisions.push_back(Precision::double_);
        if (precision == "double") options.precisions.erase(options.precisions.begin());
        bench::run(options);
    });
}
