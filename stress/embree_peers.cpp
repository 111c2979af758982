// SPDX-License-Identifier: Apache-2.0
#include "stress/peer.h"

#include <embree3/rtcore.h>

#include <dlfcn.h>

#include <array>
#include <atomic>

namespace alidade {
namespace {

/// Embree's functions, from the library: nobody who does not ask for it loads it.
struct Embree {
    decltype(&::rtcNewDevice) rtcNewDevice = nullptr;
    decltype(&::rtcReleaseDevice) rtcReleaseDevice = nullptr;
    decltype(&::rtcSetDeviceMemoryMonitorFunction) rtcSetDeviceMemoryMonitorFunction = nullptr;
    decltype(&::rtcNewScene) rtcNewScene = nullptr;
    decltype(&::rtcReleaseScene) rtcReleaseScene = nullptr;
    decltype(&::rtcSetSceneFlags) rtcSetSceneFlags = nullptr;
    decltype(&::rtcSetSceneBuildQuality) rtcSetSceneBuildQuality = nullptr;
    decltype(&::rtcCommitScene) rtcCommitScene = nullptr;
    decltype(&::rtcNewGeometry) rtcNewGeometry = nullptr;
    decltype(&::rtcReleaseGeometry) rtcReleaseGeometry = nullptr;
    decltype(&::rtcCommitGeometry) rtcCommitGeometry = nullptr;
    decltype(&::rtcAttachGeometry) rtcAttachGeometry = nullptr;
    decltype(&::rtcSetSharedGeometryBuffer) rtcSetSharedGeometryBuffer = nullptr;
    decltype(&::rtcSetGeometryInstancedScene) rtcSetGeometryInstancedScene = nullptr;
    decltype(&::rtcSetGeometryTransform) rtcSetGeometryTransform = nullptr;
    decltype(&::rtcIntersect1) rtcIntersect1 = nullptr;
    decltype(&::rtcOccluded1) rtcOccluded1 = nullptr;

    template <class F> static bool find(void* library, const char* name, F& function) {
        function = reinterpret_cast<F>(dlsym(library, name));
        return function != nullptr;
    }
    /// False if the system has no Embree 3.
    bool open() {
        void* library = dlopen("libembree3.so.3", RTLD_NOW | RTLD_LOCAL);
        return library && find(library, "rtcNewDevice", rtcNewDevice) && find(library, "rtcReleaseDevice", rtcReleaseDevice) &&
               find(library, "rtcSetDeviceMemoryMonitorFunction", rtcSetDeviceMemoryMonitorFunction) && find(library, "rtcNewScene", rtcNewScene) &&
               find(library, "rtcReleaseScene", rtcReleaseScene) && find(library, "rtcSetSceneFlags", rtcSetSceneFlags) &&
               find(library, "rtcSetSceneBuildQuality", rtcSetSceneBuildQuality) &&
               find(library, "rtcCommitScene", rtcCommitScene) && find(library, "rtcNewGeometry", rtcNewGeometry) &&
               find(library, "rtcReleaseGeometry", rtcReleaseGeometry) && find(library, "rtcCommitGeometry", rtcCommitGeometry) &&
               find(library, "rtcAttachGeometry", rtcAttachGeometry) && find(library, "rtcSetSharedGeometryBuffer", rtcSetSharedGeometryBuffer) &&
               find(library, "rtcSetGeometryInstancedScene", rtcSetGeometryInstancedScene) && find(library, "rtcSetGeometryTransform", rtcSetGeometryTransform) &&
               find(library, "rtcIntersect1", rtcIntersect1) && find(library, "rtcOccluded1", rtcOccluded1);
    }
};

class EmbreePeer : public StressPeer {
  public:
    EmbreePeer(const Embree& embree, const char* peer_name, RTCSceneFlags flags, RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM)
        : e_(embree), device_(e_.rtcNewDevice("threads=1")), flags_(flags), quality_(quality) {
        name = peer_name, accountable = false;
        e_.rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    }
    ~EmbreePeer() override {
        drop();
        e_.rtcReleaseDevice(device_);
    }
    EmbreePeer(const EmbreePeer&) = delete;
    EmbreePeer& operator=(const EmbreePeer&) = delete;

    void build(const StressScene& scene) override {
        drop();
        for (const StressMesh& mesh : scene.meshes) build_mesh(mesh);
        if (!scene.places.empty()) build_places(scene);
    }
    void drop() override {
        if (top_) e_.rtcReleaseScene(top_);
        top_ = nullptr;
        for (const RTCScene mesh : meshes_) e_.rtcReleaseScene(mesh);
        meshes_.clear(), positions_.clear();
    }
    void closest(std::span<const StressRay> rays, std::span<StressHit> hits) override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        const RTCScene asked = top_ ? top_ : meshes_.front();
        for (size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit query;
            query.ray = converted(rays[i]), query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            e_.rtcIntersect1(asked, &context, &query);
            const bool hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            hits[i] = hit ? StressHit{double(query.ray.tfar), top_ ? query.hit.instID[0] : 0, query.hit.primID, query.hit.u, query.hit.v} : StressHit();
        }
    }
    void any(std::span<const StressRay> rays, std::span<uint8_t> hit) override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        const RTCScene asked = top_ ? top_ : meshes_.front();
        for (size_t i = 0; i < rays.size(); ++i) {
            RTCRay query = converted(rays[i]);
            e_.rtcOccluded1(asked, &context, &query);
            hit[i] = query.tfar < 0;
        }
    }
    StressStructure structure() const override {
        StressStructure out;
        out.bytes = size_t(bytes_.load());
        return out;
    }

  private:
    static bool count_bytes(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<ssize_t>*>(total) += bytes;
        return true;
    }
    static RTCRay converted(const StressRay& ray) {
        RTCRay out;
        out.org_x = float(ray.origin.x), out.org_y = float(ray.origin.y), out.org_z = float(ray.origin.z), out.tnear = float(ray.tmin);
        out.dir_x = float(ray.dir.x), out.dir_y = float(ray.dir.y), out.dir_z = float(ray.dir.z), out.tfar = float(ray.tmax);
        out.time = 0, out.mask = ~0u, out.id = 0, out.flags = 0;
        return out;
    }
    RTCScene new_scene() const {
        const RTCScene scene = e_.rtcNewScene(device_);
        e_.rtcSetSceneFlags(scene, flags_);
        e_.rtcSetSceneBuildQuality(scene, quality_);
        return scene;
    }
    void attach(RTCScene scene, RTCGeometry geometry) const {
        e_.rtcCommitGeometry(geometry);
        e_.rtcAttachGeometry(scene, geometry);
        e_.rtcReleaseGeometry(geometry);
    }
    void build_mesh(const StressMesh& mesh) {
        positions_.push_back(mesh.positions);
        positions_.back().emplace_back(0.0f);   // Embree reads vertices by sixteen bytes
        meshes_.push_back(new_scene());
        const RTCGeometry geometry = e_.rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        e_.rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions_.back().data(), 0, sizeof(Vec3f), mesh.positions.size());
        e_.rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0, sizeof(Index3), mesh.triangles.size());
        attach(meshes_.back(), geometry);
        e_.rtcCommitScene(meshes_.back());
    }
    void build_places(const StressScene& scene) {
        top_ = new_scene();
        for (const StressPlace& place : scene.places) {
            const RTCGeometry geometry = e_.rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            e_.rtcSetGeometryInstancedScene(geometry, meshes_[place.mesh]);
            std::array<float, 12> columns{};
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 3; ++r) columns[size_t(3 * c + r)] = float(c < 3 ? place.to_world.linear[c][r] : place.to_world.translation[r]);
            e_.rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
            attach(top_, geometry);
        }
        e_.rtcCommitScene(top_);
    }

    const Embree& e_;
    std::atomic<ssize_t> bytes_ = 0;
    RTCDevice device_;
    RTCSceneFlags flags_;
    RTCBuildQuality quality_;   ///< high: with spatial splits
    std::vector<RTCScene> meshes_;
    RTCScene top_ = nullptr;
    std::vector<std::vector<Vec3f>> positions_;
};

}  // namespace

std::vector<std::unique_ptr<StressPeer>> make_embree_peers() {
    static Embree embree;
    static const bool opened = embree.open();
    std::vector<std::unique_ptr<StressPeer>> peers;
    if (!opened) return peers;
    peers.push_back(std::make_unique<EmbreePeer>(embree, "embree", RTC_SCENE_FLAG_NONE));
    peers.push_back(std::make_unique<EmbreePeer>(embree, "embree robust", RTC_SCENE_FLAG_ROBUST));
    peers.push_back(std::make_unique<EmbreePeer>(embree, "embree high", RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_HIGH));
    return peers;
}

}  // namespace alidade
