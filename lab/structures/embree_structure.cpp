#include "lab/structures/embree_structure.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/core.h>
#include <sys/types.h>
#include <tbb/task_arena.h>

#include "core/assert.h"
#include "core/error.h"
#include "lab/structures/primitives.h"
#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/mesh_entry.h"
#include "render/acceleration/safe_ray.h"
#include "render/geometry/triangle_mesh.h"

namespace carom::render {

/// Owns the device and keeps the first error that it reported.
class EmbreeDevice {
  public:
    EmbreeDevice() : device_(rtcNewDevice(settings())) {
        if (device_ == nullptr) {
            const RTCError reason = rtcGetDeviceError(nullptr);
            if (reason == RTC_ERROR_OUT_OF_MEMORY) {
                throw std::bad_alloc();
            }
            throw Error(
                fmt::format("Embree cannot be started, error {}", static_cast<int>(reason)));
        }
        rtcSetDeviceErrorFunction(device_, note_error, this);
        rtcSetDeviceMemoryMonitorFunction(device_, note_memory, this);
    }
    ~EmbreeDevice() { rtcReleaseDevice(device_); }
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    [[nodiscard]] RTCDevice get() const { return device_; }

    /// Bytes used by all scenes of this device.
    [[nodiscard]] std::size_t bytes() const {
        return static_cast<std::size_t>(std::max<ssize_t>(bytes_, 0));
    }

    /// Throws Error if Embree has reported an error since the last call. `action`: "building ...".
    void check(const std::string& action) const {
        std::string error;
        {
            const std::lock_guard lock(mutex_);
            error.swap(error_);
        }
        if (!error.empty()) {
            throw Error("Embree failed while " + action + ": " + error);
        }
    }

  private:
    /// The instructions of our own kernels.
    static const char* settings() {
        const std::string_view tier = best_kernels().tier;
        return tier == "AVX2" ? "isa=avx2" : (tier == "SSE4" ? "isa=sse4.2" : "isa=sse2");
    }
    static void note_error(void* self, RTCError code, const char* text) {
        auto* device = static_cast<EmbreeDevice*>(self);
        const std::lock_guard lock(device->mutex_);
        if (device->error_.empty()) {
            device->error_ =
                fmt::format("{} (error {})", text == nullptr ? "no reason given" : text,
                            static_cast<int>(code));
        }
    }
    static bool note_memory(void* self, ssize_t bytes, bool /*post*/) {
        static_cast<EmbreeDevice*>(self)->bytes_ += bytes;
        return true;  // continue
    }

    RTCDevice device_ = nullptr;
    mutable std::mutex mutex_;
    mutable std::string error_;
    std::atomic<ssize_t> bytes_{0};
};

namespace {

struct EmbreeRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using SceneHandle = std::unique_ptr<RTCSceneTy, EmbreeRelease>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, EmbreeRelease>;

/// A committed geometry of triangles. The mesh's index list is used in place.
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

/// The data of one query, behind Embree's context, which must be the first member.
struct QueryContext {
    RTCIntersectContext embree;
    const Ray* ray = nullptr;          // safe
    Candidate nearest{-1, kNoObject};  // the last hit of a user shape

    explicit QueryContext(const Ray& safe) : ray(&safe) { rtcInitIntersectContext(&embree); }
};

void bounds_callback(const RTCBoundsFunctionArguments* args) {
    const auto& all = *static_cast<const Primitives*>(args->geometryUserPtr);
    const MovingBounds& bounds = all.bounded()[args->primID].bounds;
    const Imath::Box3f& box = args->timeStep == 0 ? bounds.open : bounds.close;
    *args->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

void intersect_callback(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) {
        return;
    }
    const auto& all = *static_cast<const Primitives*>(args->geometryUserPtr);
    auto* context = reinterpret_cast<QueryContext*>(args->context);
    auto* query = reinterpret_cast<RTCRayHit*>(args->rayhit);
    const Primitive& shape = all.bounded()[args->primID];
    Ray ray = *context->ray;
    ray.t_max = query->ray.tfar;
    // At the same distance as another user shape the lower object wins.
    if (context->nearest.t == ray.t_max && shape.object < context->nearest.object) {
        ray.t_max = std::nextafter(ray.t_max, kInfinity);
    }
    Hit hit;
    if (!all.closest(shape, ray, hit)) {
        return;
    }
    context->nearest = {hit.t, shape.object};
    query->ray.tfar = hit.t;
    query->hit.geomID = args->geomID;
    query->hit.primID = args->primID;
    query->hit.instID[0] = args->context->instID[0];
    query->hit.u = hit.u;
    query->hit.v = hit.v;
    // The normal is not needed, so its field carries the triangle of a moving mesh.
    query->hit.Ng_x = __builtin_bit_cast(float, hit.primitive);
}

void occluded_callback(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) {
        return;
    }
    const auto& all = *static_cast<const Primitives*>(args->geometryUserPtr);
    const auto* context = reinterpret_cast<const QueryContext*>(args->context);
    Hit hit;
    if (all.closest(all.bounded()[args->primID], *context->ray, hit)) {
        reinterpret_cast<RTCRay*>(args->ray)->tfar = -kInfinity;
    }
}

/// One committed geometry over all bounded shapes of `shapes`, which outlives it and is not moved.
GeometryHandle make_user_geometry(const EmbreeDevice& device, const Primitives& shapes) {
    GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(),
                                     static_cast<unsigned>(shapes.bounded().size()));
    rtcSetGeometryTimeStepCount(geometry.get(), 2);
    // Embree takes a pointer to mutable data; the callbacks only read it.
    rtcSetGeometryUserData(geometry.get(), const_cast<Primitives*>(&shapes));
    rtcSetGeometryBoundsFunction(geometry.get(), bounds_callback, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), intersect_callback);
    rtcSetGeometryOccludedFunction(geometry.get(), occluded_callback);
    rtcCommitGeometry(geometry.get());
    device.check("taking over shapes");
    return geometry;
}

/// `ray` must be safe (safe_ray.h).
RTCRay to_embree(const Ray& ray) {
    const V3f& o = ray.origin;
    const V3f& d = ray.direction;
    return {o.x, o.y, o.z, ray.t_min, d.x, d.y, d.z, ray.time, ray.t_max, 0xffffffffu, 0, 0};
}

}  // namespace

std::shared_ptr<const EmbreeDevice> make_embree_device() {
    return std::make_shared<const EmbreeDevice>();
}

struct EmbreeStructure::Data {
    explicit Data(Primitives all) : shapes(std::move(all)) {}

    // Members are destroyed from the last to the first: the scene before what it refers to.
    std::shared_ptr<const EmbreeDevice> device;
    std::vector<std::uint32_t> mesh_objects;  // by Embree's geometry ID
    Primitives shapes;
    SceneHandle scene;

    [[nodiscard]] Hit to_hit(const RTCRayHit& query) const {
        Hit hit{query.ray.tfar, kNoObject, query.hit.primID, query.hit.u, query.hit.v};
        if (query.hit.geomID < mesh_objects.size()) {
            hit.object = mesh_objects[query.hit.geomID];
        } else {
            hit.object = shapes.bounded()[query.hit.primID].object;
            hit.primitive = __builtin_bit_cast(std::uint32_t, query.hit.Ng_x);
        }
        return hit;
    }
};

EmbreeStructure::EmbreeStructure(std::shared_ptr<const EmbreeDevice> device, const ShapeSet& shapes,
                                 std::span<const MeshEntry> meshes)
    : data_(std::make_unique<Data>(Primitives(shapes))) {
    data_->device = std::move(device);
    data_->scene.reset(rtcNewScene(data_->device->get()));
    data_->device->check("making a scene");
    unsigned id = 0;
    for (const MeshEntry& entry : meshes) {
        const GeometryHandle geometry = make_triangle_geometry(*data_->device, *entry.mesh);
        rtcAttachGeometryByID(data_->scene.get(), geometry.get(), id++);
        data_->mesh_objects.push_back(entry.object);
    }
    if (!data_->shapes.bounded().empty()) {
        const GeometryHandle geometry = make_user_geometry(*data_->device, data_->shapes);
        rtcAttachGeometryByID(data_->scene.get(), geometry.get(), id);
    }
    // Embree does not promise that its hierarchy is independent of the number of threads, and the
    // hierarchy decides between triangles at the same distance; a build on one thread is safe.
    // (Embree's own setting, threads=1, would throttle oneTBB in the whole process, and
    // rtcJoinCommitScene works in the device's arena instead of this one.)
    tbb::task_arena alone(1);
    alone.execute([&] { rtcCommitScene(data_->scene.get()); });
    data_->device->check("building the hierarchy over triangles");
}

EmbreeStructure::~EmbreeStructure() = default;

std::size_t EmbreeStructure::bytes() const {
    return data_->device->bytes();
}

bool EmbreeStructure::closest_hit(const Ray& ray, Hit& hit) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    QueryContext context(safe);
    RTCRayHit query;
    query.ray = to_embree(safe);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data_->scene.get(), &context.embree, &query);
    const bool found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID && query.ray.tfar < safe.t_max &&
                       query.ray.tfar > safe.t_min;
    Hit best = found ? data_->to_hit(query) : Hit{safe.t_max, kNoObject, 0, 0, 0};
    data_->shapes.find_closest_plane(safe, best);  // no hierarchy can hold infinite planes
    if (best.object == kNoObject) {
        return false;
    }
    hit = best;
    return true;
}

bool EmbreeStructure::any_hit(const Ray& ray) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    if (data_->shapes.first_plane_hit(safe) < data_->shapes.planes().size()) {
        return true;
    }
    QueryContext context(safe);
    RTCRay query = to_embree(safe);
    rtcOccluded1(data_->scene.get(), &context.embree, &query);
    return query.tfar < 0;
}

}  // namespace carom::render
