// SPDX-License-Identifier: Apache-2.0
#include "tools/stress/series.h"

#include "core/image.h"
#include "stress/prediction.h"
#include "stress/tree_file.h"
#include "tools/load.h"
#include "tools/stress/from_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

namespace alidade {

namespace {

constexpr size_t kPilot = 8000;   // triangles of the scene by which the first one is predicted

class SeriesRun {
  public:
    SeriesRun(const StressRequest& request, const std::atomic<bool>& stop, const std::function<void(double)>& progress, const std::function<void(const StressSource&, const StressSize&)>& told)
        : request_(request), stop_(stop), progress_(progress), told_(told) {
        out_.bytes = request.bytes.value_or(available_memory() ? 0.8 * double(available_memory()) : kInf);
        for (const AcceleratorEntry* entry : request.accelerators)
            for (auto& peer : make_peers({entry, 1}, request.precisions, request.threads, request.tests)) peers_.push_back(std::move(peer));
        if (request.embree)
            for (auto& peer : make_embree_peers()) peers_.push_back(std::move(peer));
    }

    StressResults run() {
        if (!request_.rays.empty() && !read_rays()) return std::move(out_);
        for (const StressSource& source : request_.sources)
            for (const size_t size : source.sizes) work_ += work_of(source.kind ? size : kPilot);
        for (const StressSource& source : request_.sources) {
            paces_.assign(peers_.size(), StressPace()), make_pace_ = {};
            out_.series.push_back({source, {}, {}});
            for (const size_t size : source.sizes) {
                if (!one(source, size)) return std::move(out_);
                told_(source, out_.series.back().sizes.back());
                done_ += work_of(source.kind ? size : kPilot);
            }
            if (source.sizes.size() > 1) fit(out_.series.back());
        }
        return std::move(out_);
    }

  private:
    struct MakePace {
        double triangles = 0, seconds = 0, bytes = 0;
    };

    double left() const { return request_.seconds.value_or(kInf) - (wall_seconds() - start_); }
    double work_of(size_t triangles) const { return stress_work(triangles, peers_.size(), ray_count(), request_.rounds); }
    size_t ray_count() const { return given_.empty() ? 4 * request_.side * request_.side : 2 * given_.size(); }

    bool read_rays() {
        auto rays = read_file(request_.rays).and_then([](const std::vector<std::byte>& bytes) { return decode_rays(bytes); });
        if (rays) given_ = std::move(*rays);
        else out_.said.error({out_.said.add_file(request_.rays), 0, 0, {}}, rays.error());
        return !given_.empty();
    }

    /// False if it cannot go on: what was said has the error.
    bool one(const StressSource& source, size_t size) {
        StressSize out;
        out.asked = size;
        if (source.kind) out.left_out = stop_ ? "interrupted" : why_not_made(source, size);
        if (out.left_out.empty()) {
            auto subject = subject_of(source, size, out);
            if (!subject) return false;
            if (!measure(source, *subject, out)) return false;
        }
        out_.interrupted = out_.interrupted || stop_;
        out_.series.back().sizes.push_back(std::move(out));
        return true;
    }

    std::optional<StressSubject> subject_of(const StressSource& source, size_t size, StressSize& out) {
        const double start = wall_seconds();
        std::optional<StressSubject> subject;
        if (source.kind) {
            subject = StressSubject{source.kind->make(size, source.seed), {}};
            subject->primary = camera_rays(subject->scene, request_.side);
        } else {
            Loaded loaded = load(request_.scene);
            out_.said.append(loaded.said);
            if (loaded.scene) subject = stress_subject(std::move(*loaded.scene), source.name, request_.side, out_.said);
        }
        out.make_seconds = wall_seconds() - start;
        if (subject) make_pace_ = {double(subject->scene.triangles()), out.make_seconds, double(subject->scene.bytes())};
        return subject;
    }

    /// Predicted from the size before, or from a small scene of the kind.
    std::string why_not_made(const StressSource& source, size_t size) {
        if (make_pace_.triangles == 0) {
            const double start = wall_seconds();
            const StressScene small = source.kind->make(std::min(size, kPilot), source.seed);
            make_pace_ = {double(small.triangles()), wall_seconds() - start, double(small.bytes())};
        }
        const double ratio = double(size) / std::max(1.0, make_pace_.triangles), seconds = 1.3 * ratio * make_pace_.seconds, bytes = 1.5 * ratio * make_pace_.bytes;
        if (bytes > out_.bytes) return fmt::format("the scene needs about {}: more than {}", bytes_text(bytes), bytes_text(out_.bytes));
        if (seconds > left()) return fmt::format("to make the scene takes about {}: {} are left", seconds_text(seconds), seconds_text(std::max(0.0, left())));
        return {};
    }

    bool measure(const StressSource& source, StressSubject& subject, StressSize& out) {
        const StressScene& scene = subject.scene;
        if (scene.triangles() > kPilot) run_pilot(scene);
        const StressPace rays = pace_for_rays();
        const StressOptions limits = options();
        StressBudget budget(limits);
        out.left_out = given_.empty() ? budget.admit(rays, double(scene.primitives()), 1, request_.side * request_.side, scene.bytes()) : "";
        if (!out.left_out.empty()) {
            out.left_out = "to find the rays, a BVH is needed, which " + out.left_out;
            return true;
        }
        const std::vector<RaySet> sets = given_.empty() ? stress_rays(scene, std::move(subject.primary), source.seed) : given_sets();
        if (!request_.dump_rays.empty() && !dump(sets)) return false;
        out.figures = run_stress(scene, sets, peers_, options(), paces_);
        if (!request_.trees.empty() && !out.figures.interrupted && !write_trees_of(scene)) return false;
        for (size_t i = 0; i < peers_.size(); ++i)
            if (const StressPace pace = pace_of(out.figures.peers[i], scene.primitives()); pace.primitives > 0) paces_[i] = pace;
        return true;
    }

    StressOptions options() {
        StressOptions options;
        options.rounds = request_.rounds, options.seconds = left(), options.stop = &stop_;
        if (const double cpu = thread_seconds() - cpu_start_; cpu > 0.01) options.clock_factor = std::clamp((wall_seconds() - start_) / cpu, 1.0, 20.0);
        options.bytes = out_.bytes < 1e18 ? size_t(out_.bytes) : ~size_t(0);
        options.progress = [this](double work) { progress_(std::min(1.0, (done_ + work) / std::max(1.0, work_))); };
        return options;
    }

    /// What is not known from a smaller size, from a part of the scene.
    void run_pilot(const StressScene& scene) {
        if (std::all_of(paces_.begin(), paces_.end(), [](const StressPace& pace) { return pace.primitives > 0; })) return;
        const StressScene part = part_of(scene, kPilot);
        StressOptions quick = options();
        quick.rounds = 1, quick.oracle_tests = 0, quick.progress = nullptr;
        const StressFigures figures = run_stress(part, stress_rays(part, camera_rays(part, 16), 1), peers_, quick);
        for (size_t i = 0; i < peers_.size(); ++i)
            if (paces_[i].primitives == 0) paces_[i] = pace_of(figures.peers[i], part.primitives());
    }

    /// Of the BVH in float, by which rays are found, or of whoever is nearest to it.
    StressPace pace_for_rays() const {
        for (size_t i = 0; i < peers_.size(); ++i)
            if (peers_[i]->name == "bvh") return paces_[i];
        return paces_.empty() ? StressPace() : paces_.front();
    }

    std::vector<RaySet> given_sets() const { return {{"given", Question::closest, given_}, {"given, any hit", Question::any, given_}}; }

    bool dump(const std::vector<RaySet>& sets) {
        for (const RaySet& set : sets) {
            const std::string path = rays_path(request_.dump_rays, set.question == Question::any && !given_.empty() ? "any" : set.name);
            if (const auto done = write_file(path, encode_rays(set.rays, request_.dump_numbers)); !done) return out_.said.error({}, done.error()), false;
        }
        return true;
    }

    /// Structures are built again for it, one at a time. No tree depends on the test of triangles.
    bool write_trees_of(const StressScene& scene) {
        for (const AcceleratorEntry* entry : request_.accelerators) {
            for (const Precision precision : request_.precisions) {
                const auto written = write_trees(rays_path(request_.trees, fmt::format("{}.{}", entry->name, precision == Precision::float_ ? "float" : "double")), *entry, {precision, Isa::best, request_.threads}, scene);
                if (!written) return out_.said.error({}, written.error()), false;
                if (*written) continue;
                out_.said.note({}, fmt::format("--tree: {} is no tree: no file is written", entry->name));
                break;
            }
        }
        return true;
    }

    static void fit(StressSeries& series) {
        std::map<std::array<std::string, 3>, std::pair<std::vector<double>, std::vector<double>>> points;
        std::vector<std::array<std::string, 3>> order;
        for (const StressSize& size : series.sizes) {
            for (const StressPeerFigures& peer : size.figures.peers) {
                const auto add = [&](const std::string& cost, double value) {
                    const std::array key{peer.name, peer.precision, cost};
                    auto& [n, costs] = points[key];
                    if (n.empty()) order.push_back(key);
                    n.push_back(double(size.figures.triangles)), costs.push_back(value);
                };
                if (!peer.left_out.empty()) continue;
                add("build seconds", peer.build_seconds.median), add("bytes", double(peer.structure.bytes));
                for (const StressRayFigures& rays : peer.rays) {
                    if (!rays.left_out.empty()) continue;
                    if (rays.boxes && rays.triangles) add(rays.rays + " tests", *rays.boxes + *rays.triangles);
                    add(rays.rays + " seconds", rays.seconds.median / double(rays.count));
                }
            }
        }
        for (const auto& key : order)
            if (const auto law = fit_power_law(points[key].first, points[key].second)) series.growth.push_back({key[0], key[1], key[2], *law});
    }

    const StressRequest& request_;
    const std::atomic<bool>& stop_;
    const std::function<void(double)>& progress_;
    const std::function<void(const StressSource&, const StressSize&)>& told_;
    StressResults out_;
    std::vector<std::unique_ptr<StressPeer>> peers_;
    std::vector<StressPace> paces_;   // by peer, of the present source
    MakePace make_pace_;
    std::vector<StressRay> given_;
    double start_ = wall_seconds(), cpu_start_ = thread_seconds(), work_ = 0, done_ = 0;
};

}  // namespace

size_t StressResults::disagreements() const {
    size_t count = 0;
    for (const StressSeries& each : series)
        for (const StressSize& size : each.sizes) count += size.figures.disagreements.size();
    return count;
}

bool StressResults::measured() const {
    const auto has_rays = [](const StressPeerFigures& peer) { return std::any_of(peer.rays.begin(), peer.rays.end(), [](const StressRayFigures& rays) { return rays.left_out.empty(); }); };
    return std::any_of(series.begin(), series.end(), [&](const StressSeries& each) {
        return std::any_of(each.sizes.begin(), each.sizes.end(), [&](const StressSize& size) { return std::any_of(size.figures.peers.begin(), size.figures.peers.end(), has_rays); });
    });
}

std::string rays_path(const std::string& path, const std::string& set) {
    const std::filesystem::path given(path);
    return std::filesystem::path(given).replace_extension("." + set + given.extension().string()).string();
}

StressResults measure_series(const StressRequest& request, const std::atomic<bool>& stop, const std::function<void(double)>& progress,
                             const std::function<void(const StressSource&, const StressSize&)>& told) {
    return SeriesRun(request, stop, progress, told).run();
}

}  // namespace alidade
