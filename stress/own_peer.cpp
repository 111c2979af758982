// SPDX-License-Identifier: Apache-2.0
#include "stress/instances.h"
#include "stress/peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace alidade {
namespace {

class OwnPeer : public StressPeer {
  public:
    OwnPeer(const AcceleratorEntry& entry, const AccelOptions& options, bool together) : entry_(entry), options_(options), together_(together) {
        threads = options.threads, name = entry.name, precision = options.precision == Precision::float_ ? "float" : "double";
        if (options.intersect != Intersect::exact) {
            name += fmt::format(":{}", alidade::name(options.intersect)), accountable = false;
            return;
        }
        exact = entry.over_triangles == find_accelerator("auto")->over_triangles || std::any_of(accelerators().begin(), accelerators().end(), [&](const AcceleratorEntry& known) { return known.over_triangles == entry.over_triangles; });
    }

    void build(const StressScene& scene) override {
        drop();
        for (const StressMesh& mesh : scene.meshes) meshes_.push_back(entry_.over_triangles(mesh.view(), options_));
        asked_ = meshes_.front().get();
        const auto more = [](const StressMesh& a, const StressMesh& b) { return a.triangles.size() < b.triangles.size(); };
        largest_ = size_t(std::max_element(scene.meshes.begin(), scene.meshes.end(), more) - scene.meshes.begin());
        if (scene.places.empty()) return;
        std::vector<const Accelerator*> below;
        for (const auto& mesh : meshes_) below.push_back(mesh.get());
        set_ = std::make_shared<StressInstances>(std::move(below), scene);
        top_ = entry_.over_set(set_, options_);
        asked_ = top_.get();
    }
    void drop() override {
        top_.reset(), set_.reset(), meshes_.clear();
        asked_ = nullptr, work_ = {};
    }
    void closest(std::span<const StressRay> rays, std::span<StressHit> hits) override {
        if (together_) return closest_together(rays, hits);
        for (size_t i = 0; i < rays.size(); ++i) {
            Hit hit;
            asked_->intersect(rays[i].ray(), hit, work_);
            hits[i] = {hit.t, hit.instance, hit.primitive, hit.u, hit.v};
        }
    }
    void any(std::span<const StressRay> rays, std::span<uint8_t> hit) override {
        for (size_t i = 0; i < rays.size(); ++i) hit[i] = asked_->occluded(rays[i].ray(), work_);
    }
    StressStructure structure() const override {
        StressStructure out;
        size_t nodes = 0, leaves = 0, references = 0, removed = 0, depth = 0;
        const auto add = [&](const BuildStats& s) {
            out.bytes += s.bytes, nodes += s.nodes, leaves += s.leaves, references += s.references, removed += s.removed.size();
            for (const BuildPhase& phase : s.phases) phase_of(phase.name, out.phases).seconds += phase.seconds;
        };
        for (const auto& mesh : meshes_) add(mesh->stats()), depth = std::max(depth, mesh->stats().depth);
        if (top_) add(top_->stats()), out.bytes += set_->bytes(), depth += top_->stats().depth;
        out.nodes = nodes, out.leaves = leaves, out.references = references, out.removed = removed, out.depth = depth;
        if (const double cost = meshes_[largest_]->stats().sah_cost; cost > 0) out.sah_cost = cost;
        return out;
    }
    std::optional<WorkCounters> work() const override { return work_; }

  private:
    void closest_together(std::span<const StressRay> rays, std::span<StressHit> hits) {
        constexpr size_t kMany = 1024;
        std::array<Ray, kMany> some;
        std::array<Hit, kMany> found;
        for (size_t i = 0; i < rays.size(); i += kMany) {
            const size_t count = std::min(kMany, rays.size() - i);
            for (size_t k = 0; k < count; ++k) some[k] = rays[i + k].ray();
            asked_->intersect_many(std::span(some).first(count), std::span(found).first(count), work_);
            for (size_t k = 0; k < count; ++k) hits[i + k] = {found[k].t, found[k].instance, found[k].primitive, found[k].u, found[k].v};
        }
    }
    static BuildPhase& phase_of(const char* name, std::vector<BuildPhase>& phases) {
        const auto found = std::find_if(phases.begin(), phases.end(), [&](const BuildPhase& phase) { return std::string_view(phase.name) == name; });
        return found != phases.end() ? *found : phases.emplace_back(BuildPhase{name, 0});
    }

    const AcceleratorEntry& entry_;
    AccelOptions options_;
    bool together_;
    std::vector<std::unique_ptr<Accelerator>> meshes_;
    std::shared_ptr<StressInstances> set_;
    std::unique_ptr<Accelerator> top_;
    const Accelerator* asked_ = nullptr;
    size_t largest_ = 0;
    WorkCounters work_;
};

}  // namespace

std::unique_ptr<StressPeer> make_own_peer(const AcceleratorEntry& entry, const AccelOptions& options, bool together) { return std::make_unique<OwnPeer>(entry, options, together); }

}  // namespace alidade
