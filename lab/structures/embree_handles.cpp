#include "lab/structures/embree_handles.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>
#include <tbb/task_arena.h>

#include "core/assert.h"
#include "core/error.h"
#include "render/acceleration/analytic_kernels.h"
#include "render/geometry/ray.h"

namespace carom::render {
namespace {

/// The instructions of our own kernels.
const char* device_settings() {
    const std::string_view tier = best_kernels().tier;
    return tier == "AVX2" ? "isa=avx2" : (tier == "SSE4" ? "isa=sse4.2" : "isa=sse2");
}

}  // namespace

EmbreeDevice::EmbreeDevice() : device_(rtcNewDevice(device_settings())) {
    if (device_ == nullptr) {
        const RTCError reason = rtcGetDeviceError(nullptr);
        if (reason == RTC_ERROR_OUT_OF_MEMORY) {
            throw std::bad_alloc();
        }
        throw Error(fmt::format("Embree cannot be started, error {}", static_cast<int>(reason)));
    }
    rtcSetDeviceErrorFunction(device_, note_error, this);
    rtcSetDeviceMemoryMonitorFunction(device_, note_memory, this);
}

EmbreeDevice::~EmbreeDevice() {
    rtcReleaseDevice(device_);
}

void EmbreeDevice::note_error(void* self, RTCError code, const char* text) {
    auto* device = static_cast<EmbreeDevice*>(self);
    const std::lock_guard lock(device->mutex_);
    if (device->error_.empty()) {
        device->error_ = fmt::format("{} (error {})", text == nullptr ? "no reason given" : text,
                                     static_cast<int>(code));
    }
}

bool EmbreeDevice::note_memory(void* self, ssize_t bytes, bool /*post*/) {
    static_cast<EmbreeDevice*>(self)->bytes_ += bytes;
    return true;  // continue
}

void EmbreeDevice::check(const std::string& action) const {
    std::string error;
    {
        const std::lock_guard lock(mutex_);
        error.swap(error_);
    }
    if (!error.empty()) {
        throw Error("Embree failed while " + action + ": " + error);
    }
}

GeometryHandle make_triangle_geometry(const EmbreeDevice& device, const TriangleMesh& mesh) {
    GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    void* vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                             RTC_FORMAT_FLOAT3, sizeof(V3f), mesh.vertices.size());
    device.check("reserving memory for a mesh");
    CAROM_ASSERT(vertices != nullptr);
    std::copy(mesh.vertices.begin(), mesh.vertices.end(), static_cast<V3f*>(vertices));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                               mesh.triangles.size());
    rtcCommitGeometry(geometry.get());
    device.check("taking over a mesh");
    return geometry;
}

void commit_on_this_thread(const EmbreeDevice& device, RTCScene scene) {
    // Embree does not promise that its hierarchy is independent of the number of threads, and the
    // hierarchy decides between triangles at the same distance; a build on one thread is safe.
    // (Embree's own setting, threads=1, would throttle oneTBB in the whole process, and
    // rtcJoinCommitScene works in the device's arena instead of this one.)
    tbb::task_arena alone(1);
    alone.execute([&] { rtcCommitScene(scene); });
    device.check("building the hierarchy over triangles");
}

RTCRay to_embree(const Ray& ray) {
    RTCRay result;
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.tnear = ray.t_min;
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.time = ray.time;
    result.tfar = ray.t_max;
    result.mask = 0xffffffffu;
    result.id = 0;
    result.flags = 0;
    return result;
}

}  // namespace carom::render
