// SPDX-License-Identifier: Apache-2.0
#include "bench/peer.h"
#include "stress/instances.h"

#include <fmt/format.h>

namespace alidade::bench {
namespace {

class OwnPeer : public Peer {
  public:
    OwnPeer(const AcceleratorEntry& entry, const AccelOptions& options) : entry_(entry), options_(options) { name = entry.name; }

    void build(const StressScene& scene) override {
        top_.reset(), mesh_.reset();
        mesh_ = entry_.over_triangles(scene.view(), options_);
        if (!scene.instances.empty()) top_ = entry_.over_set(std::make_shared<StressInstances>(*mesh_, scene.instances), options_);
        asked_ = top_ ? top_.get() : mesh_.get();
    }
    void closest(std::span<const StressRay> rays, std::span<float> t) override {
        work_ = {}, count_ = rays.size();
        for (size_t i = 0; i < rays.size(); ++i) {
            Hit hit;
            asked_->intersect(rays[i].ray(), hit, work_);
            t[i] = float(hit.t);
        }
    }
    void any(std::span<const StressRay> rays, std::span<uint8_t> hit) override {
        work_ = {}, count_ = rays.size();
        for (size_t i = 0; i < rays.size(); ++i) hit[i] = asked_->occluded(rays[i].ray(), work_);
    }
    size_t bytes() const override { return mesh_->stats().bytes + (top_ ? top_->stats().bytes : 0); }
    std::string work() const override {
        const double n = double(count_);
        return fmt::format("{:.1f} boxes, {:.1f} triangles filtered, {:.2f} decided", double(work_.boxes) / n, double(work_.filtered) / n, double(work_.primitives) / n);
    }

  private:
    const AcceleratorEntry& entry_;
    AccelOptions options_;
    std::unique_ptr<Accelerator> mesh_, top_;
    const Accelerator* asked_ = nullptr;
    WorkCounters work_;
    size_t count_ = 0;
};

}  // namespace

std::unique_ptr<Peer> make_own_peer(const AcceleratorEntry& entry, const AccelOptions& options) { return std::make_unique<OwnPeer>(entry, options); }

}  // namespace alidade::bench
