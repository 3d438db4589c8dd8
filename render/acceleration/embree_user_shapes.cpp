#include "render/acceleration/embree_user_shapes.h"

#include <algorithm>
#include <cmath>

#include "render/acceleration/moving_shape.h"
#include "sim/timeline/assert.h"

namespace carom::render {
namespace {

using Kind = UserShape::Kind;

/// Pairs each shape with its lane; the blocks hold the same shapes in the same (stable) order.
template <class Block, class Shape, class Bounds>
void add(std::vector<UserShape>& list, Kind kind, const std::vector<Block>& blocks,
         std::vector<Shape> shapes, const Bounds& bounds) {
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const Shape& a, const Shape& b) { return a.object < b.object; });
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        CAROM_ASSERT(blocks[i / kBlockLanes].object.values[i % kBlockLanes] ==
                     static_cast<std::int32_t>(shapes[i].object));
        list.push_back({kind, i, shapes[i].object, bounds(shapes[i])});
    }
    static_cast<void>(blocks);
}

/// Nearest hit before `ray.t_max`.
bool hit_shape(const UserShapes& all, const UserShape& shape, const Ray& ray, Hit& hit) {
    const std::uint32_t block = shape.index / kBlockLanes;
    const int lane = static_cast<int>(shape.index % kBlockLanes);
    const AnalyticBlocks& blocks = all.blocks;
    const AnalyticKernels& kernels = *all.kernels;
    float t = ray.t_max;
    bool found = false;
    switch (shape.kind) {
        case Kind::still_sphere:
            found = kernels.still_sphere(blocks.still_spheres[block], lane, ray, t);
            break;
        case Kind::moving_sphere:
            found = kernels.moving_sphere(blocks.moving_spheres[block], lane, ray, t);
            break;
        case Kind::box:
            found = kernels.box(blocks.boxes[block], lane, ray, t);
            break;
        case Kind::mapped_ball:
            found = kernels.mapped_ball(blocks.mapped_balls[block], lane, ray, t);
            break;
        case Kind::mapped_box:
            found = kernels.mapped_box(blocks.mapped_boxes[block], lane, ray, t);
            break;
        case Kind::rectangle:
            found = kernels.rectangle(blocks.rectangles[block], lane, ray, t);
            break;
        case Kind::triangle:
            found = kernels.triangle(blocks.triangles[block], lane, ray, t);
            break;
        case Kind::disk:
            found = kernels.disk(blocks.disks[block], lane, ray, t);
            break;
        case Kind::frustum:
            found = kernels.frustum(blocks.frustums[block], lane, ray, t);
            break;
        case Kind::moving:
            return intersect_moving(all.moving[shape.index], ray, hit);
    }
    if (found) {
        hit = {t, shape.object, 0, 0, 0};
    }
    return found;
}

void bounds_callback(const RTCBoundsFunctionArguments* args) {
    const auto& all = *static_cast<const UserShapes*>(args->geometryUserPtr);
    const MovingBounds& bounds = all.shapes[args->primID].bounds;
    const Imath::Box3f& box = args->timeStep == 0 ? bounds.open : bounds.close;
    *args->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

void intersect_callback(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) {
        return;
    }
    const auto& all = *static_cast<const UserShapes*>(args->geometryUserPtr);
    auto* context = reinterpret_cast<QueryContext*>(args->context);
    auto* query = reinterpret_cast<RTCRayHit*>(args->rayhit);
    const UserShape& shape = all.shapes[args->primID];
    Ray ray = *context->ray;
    ray.t_max = query->ray.tfar;
    // At the same distance as another user shape the lower object wins.
    if (context->nearest.t == ray.t_max && shape.object < context->nearest.object) {
        ray.t_max = std::nextafter(ray.t_max, kInfinity);
    }
    Hit hit;
    if (!hit_shape(all, shape, ray, hit)) {
        return;
    }
    context->nearest = {hit.t, shape.object};
    query->ray.tfar = hit.t;
    query->hit.geomID = args->geomID;
    query->hit.primID = args->primID;
    query->hit.instID[0] = args->context->instID[0];
    query->hit.u = hit.u;
    query->hit.v = hit.v;
    // A moving mesh's own triangle travels where a normal is not asked for.
    query->hit.Ng_x = __builtin_bit_cast(float, hit.primitive);
}

void occluded_callback(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) {
        return;
    }
    const auto& all = *static_cast<const UserShapes*>(args->geometryUserPtr);
    const auto* context = reinterpret_cast<const QueryContext*>(args->context);
    Hit hit;
    if (hit_shape(all, all.shapes[args->primID], *context->ray, hit)) {
        reinterpret_cast<RTCRay*>(args->ray)->tfar = -kInfinity;
    }
}

}  // namespace

UserShapes make_user_shapes(const ShapeSet& shapes) {
    UserShapes all;
    all.kernels = &best_kernels();
    all.blocks = make_blocks(shapes);
    all.moving = shapes.moving;
    std::vector<SphereStretch> still_spheres;
    std::vector<SphereStretch> moving_spheres;
    for (const SphereStretch& sphere : shapes.spheres) {
        (sphere.is_still() ? still_spheres : moving_spheres).push_back(sphere);
    }
    const auto round = [](const SphereStretch& sphere) { return bounds_of(sphere); };
    add(all.shapes, Kind::still_sphere, all.blocks.still_spheres, still_spheres, round);
    add(all.shapes, Kind::moving_sphere, all.blocks.moving_spheres, moving_spheres, round);
    add(all.shapes, Kind::box, all.blocks.boxes, shapes.boxes,
        [](const AlignedBox& box) { return bounds_of(box); });
    const auto solid = [](const MappedShape& shape) { return bounds_of(shape, false); };
    const auto flat = [](const MappedShape& shape) { return bounds_of(shape, true); };
    add(all.shapes, Kind::mapped_ball, all.blocks.mapped_balls, shapes.mapped_balls, solid);
    add(all.shapes, Kind::mapped_box, all.blocks.mapped_boxes, shapes.mapped_boxes, solid);
    add(all.shapes, Kind::rectangle, all.blocks.rectangles, shapes.rectangles, flat);
    add(all.shapes, Kind::triangle, all.blocks.triangles, shapes.triangles, flat);
    add(all.shapes, Kind::disk, all.blocks.disks, shapes.disks, flat);
    add(all.shapes, Kind::frustum, all.blocks.frustums, shapes.frustums, solid);
    for (std::uint32_t i = 0; i < shapes.moving.size(); ++i) {
        const MovingShape& shape = shapes.moving[i];
        if (shape.kind != MovingShape::Kind::plane) {
            all.shapes.push_back({Kind::moving, i, shape.object, bounds_of(shape)});
        }
    }
    return all;
}

GeometryHandle make_user_geometry(const EmbreeDevice& device, const UserShapes& shapes) {
    GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(shapes.shapes.size()));
    rtcSetGeometryTimeStepCount(geometry.get(), 2);
    // Embree takes a pointer to mutable data; the callbacks only read.
    rtcSetGeometryUserData(geometry.get(), const_cast<UserShapes*>(&shapes));
    rtcSetGeometryBoundsFunction(geometry.get(), bounds_callback, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), intersect_callback);
    rtcSetGeometryOccludedFunction(geometry.get(), occluded_callback);
    rtcCommitGeometry(geometry.get());
    device.check("taking over shapes");
    return geometry;
}

}  // namespace carom::render
