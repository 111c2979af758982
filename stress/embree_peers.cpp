// SPDX-License-Identifier: Apache-2.0
#include "bench/peer.h"

#include <embree3/rtcore.h>

#include <atomic>

namespace alidade::bench {
namespace {

class EmbreePeer : public Peer {
  public:
    EmbreePeer(const char* peer_name, RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")), flags_(flags) {
        name = peer_name;
        rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    }
    ~EmbreePeer() override {
        drop();
        rtcReleaseDevice(device_);
    }
    EmbreePeer(const EmbreePeer&) = delete;
    EmbreePeer& operator=(const EmbreePeer&) = delete;

    void build(const StressScene& scene) override {
        drop();
        positions_ = scene.positions;
        positions_.emplace_back(0.0f);   // Embree reads vertices by sixteen bytes
        mesh_ = rtcNewScene(device_);
        rtcSetSceneFlags(mesh_, flags_);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions_.data(), 0, sizeof(Vec3f), scene.positions.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, scene.triangles.data(), 0, sizeof(Index3), scene.triangles.size());
        attach(mesh_, geometry);
        rtcCommitScene(mesh_);
        if (!scene.instances.empty()) build_instances(scene);
    }
    void closest(std::span<const StressRay> rays, std::span<float> t) override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit query;
            query.ray = converted(rays[i]), query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(asked(), &context, &query);
            t[i] = query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : query.ray.tfar;
        }
    }
    void any(std::span<const StressRay> rays, std::span<uint8_t> hit) override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (size_t i = 0; i < rays.size(); ++i) {
            RTCRay query = converted(rays[i]);
            rtcOccluded1(asked(), &context, &query);
            hit[i] = query.tfar < 0;
        }
    }
    size_t bytes() const override { return size_t(bytes_.load()); }

  private:
    static bool count_bytes(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<ssize_t>*>(total) += bytes;
        return true;
    }
    static RTCRay converted(const StressRay& ray) {
        RTCRay out;
        out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z, out.tnear = ray.tmin;
        out.dir_x = ray.dir.x, out.dir_y = ray.dir.y, out.dir_z = ray.dir.z, out.tfar = ray.tmax;
        out.time = 0, out.mask = ~0u, out.id = 0, out.flags = 0;
        return out;
    }
    static void attach(RTCScene scene, RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    void build_instances(const StressScene& scene) {
        top_ = rtcNewScene(device_);
        rtcSetSceneFlags(top_, flags_);
        for (const Transform& place : scene.instances) {
            const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(geometry, mesh_);
            float columns[12];
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 3; ++r) columns[3 * c + r] = float(c < 3 ? place.linear[c][r] : place.translation[r]);
            rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
            attach(top_, geometry);
        }
        rtcCommitScene(top_);
    }
    RTCScene asked() const { return top_ ? top_ : mesh_; }
    void drop() {
        for (RTCScene* scene : {&top_, &mesh_}) {
            if (*scene) rtcReleaseScene(*scene);
            *scene = nullptr;
        }
    }

    std::atomic<ssize_t> bytes_ = 0;
    RTCDevice device_;
    RTCSceneFlags flags_;
    RTCScene mesh_ = nullptr, top_ = nullptr;
    std::vector<Vec3f> positions_;
};

}  // namespace

std::vector<std::unique_ptr<Peer>> make_embree_peers() {
    std::vector<std::unique_ptr<Peer>> peers;
    peers.push_back(std::make_unique<EmbreePeer>("embree", RTC_SCENE_FLAG_NONE));
    peers.push_back(std::make_unique<EmbreePeer>("embree robust", RTC_SCENE_FLAG_ROBUST));
    return peers;
}

}  // namespace alidade::bench
