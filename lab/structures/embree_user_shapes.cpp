#include "lab/structures/embree_user_shapes.h"

#include <cmath>

namespace carom::render {
namespace {

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

}  // namespace

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

}  // namespace carom::render
