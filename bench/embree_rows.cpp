// SPDX-License-Identifier: Apache-2.0
/// Embree 3 on the same meshes and rays, with default and with robust settings.
#include "bench/workload.h"

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>

namespace alidade::bench {
namespace {

/// A committed scene of one mesh. One thread; Embree copies nothing, so the workload must live as long.
class EmbreeScene {
  public:
    EmbreeScene(const Workload& workload, RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const test::Mesh& mesh = workload.mesh;
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.positions.size());
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Index3), mesh.triangles.size());
        std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3f*>(vertices));
        std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<Index3*>(indices));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    bool intersect(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray = converted(ray), query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    bool occluded(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay query = converted(ray);
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0;
    }

  private:
    static RTCRay converted(const Ray& ray) {
        RTCRay out{};
        out.org_x = float(ray.origin.x), out.org_y = float(ray.origin.y), out.org_z = float(ray.origin.z);
        out.dir_x = float(ray.dir.x), out.dir_y = float(ray.dir.y), out.dir_z = float(ray.dir.z);
        out.tnear = float(ray.tmin), out.tfar = float(ray.tmax), out.mask = kMaskAll;
        return out;
    }

    RTCDevice device_;
    RTCScene scene_;
};

using Question = bool (EmbreeScene::*)(const Ray&) const;

void ray_rate(benchmark::State& state, const Workload& workload, RTCSceneFlags flags, Question question) {
    const EmbreeScene scene(workload, flags);
    size_t next = 0, hits = 0;
    for (auto _ : state) {
        hits += (scene.*question)(workload.rays[next]);
        next = (next + 1) % workload.rays.size();
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["hit_rate"] = double(hits) / double(state.iterations());
}

}  // namespace

void register_embree_rows(const std::shared_ptr<const Workload>& workload) {
    constexpr std::pair<const char*, RTCSceneFlags> modes[] = {{"embree", RTC_SCENE_FLAG_NONE}, {"embree_robust", RTC_SCENE_FLAG_ROBUST}};
    for (const auto& mode : modes) {
        const RTCSceneFlags flags = mode.second;
        const std::string row = fmt::format("{}/{}/float", workload->mesh.name, mode.first);
        benchmark::RegisterBenchmark(("build/" + row).c_str(), [workload, flags](benchmark::State& state) {
            for (auto _ : state) EmbreeScene scene(*workload, flags);
            state.counters["triangles_per_s"] =
                benchmark::Counter(double(workload->mesh.triangles.size()), benchmark::Counter::kIsIterationInvariantRate);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("first_hit/" + row).c_str(),
                                     [workload, flags](benchmark::State& state) { ray_rate(state, *workload, flags, &EmbreeScene::intersect); });
        benchmark::RegisterBenchmark(("any_hit/" + row).c_str(),
                                     [workload, flags](benchmark::State& state) { ray_rate(state, *workload, flags, &EmbreeScene::occluded); });
    }
}

}  // namespace alidade::bench
