// Owning wrappers of Embree's handles. Internal to this folder.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

#include <embree3/rtcore.h>
#include <sys/types.h>

#include "render/geometry/ray.h"
#include "render/geometry/triangle_mesh.h"

namespace carom::render {

/// Owns the device and keeps the first error that it reported.
class EmbreeDevice {
  public:
    EmbreeDevice();
    ~EmbreeDevice();
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    [[nodiscard]] RTCDevice get() const { return device_; }

    /// Bytes used by all scenes of this device.
    [[nodiscard]] std::size_t bytes() const {
        return static_cast<std::size_t>(std::max<ssize_t>(bytes_, 0));
    }

    /// Throws Error if Embree has reported an error since the last call. `action`: "building ...".
    void check(const std::string& action) const;

  private:
    static void note_error(void* self, RTCError code, const char* text);
    static bool note_memory(void* self, ssize_t bytes, bool post);

    RTCDevice device_ = nullptr;
    mutable std::mutex mutex_;
    mutable std::string error_;
    std::atomic<ssize_t> bytes_{0};
};

struct EmbreeRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using SceneHandle = std::unique_ptr<RTCSceneTy, EmbreeRelease>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, EmbreeRelease>;

/// A committed geometry of triangles. The mesh's index list is used in place.
[[nodiscard]] GeometryHandle make_triangle_geometry(const EmbreeDevice& device,
                                                    const TriangleMesh& mesh);

/// Builds the scene's hierarchy on the calling thread only.
void commit_on_this_thread(const EmbreeDevice& device, RTCScene scene);

/// `ray` must be safe (safe_ray.h).
[[nodiscard]] RTCRay to_embree(const Ray& ray);

}  // namespace carom::render
