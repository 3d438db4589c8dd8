#include "render/acceleration/embree_user_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/acceleration/moving_shape.h"
#include "sim/timeline/assert.h"

namespace carom::render {
namespace {

using Box = Imath::Box3f;
using Kind = UserShape::Kind;

/// Room for the rounding of Embree's own box tests.
Box widened(const Box& box) {
    Box result = box;
    for (int axis = 0; axis < 3; ++axis) {
        const float size = std::max({std::abs(box.min[axis]), std::abs(box.max[axis]), 1e-3f});
        result.min[axis] -= 1e-5f * size;
        result.max[axis] += 1e-5f * size;
    }
    return result;
}

V3f derivative(const PathPiece& path, float time) {
    const float d = time - path.start;
    return path.c[1] + d * (2.f * path.c[2] + 3.f * d * path.c[3]);
}

/// Bounds of a ball along its path, from the control points of the path's Bézier form: the curve
/// lies in their hull. A path in force throughout gets boxes that move with it.
MovingBounds sphere_bounds(const SphereStretch& sphere) {
    const float from = std::max(sphere.start, 0.f);
    const float to = std::max(from, std::min(sphere.end, 1.f));
    const float third = (to - from) / 3;
    const V3f p0 = sphere.path.position(from);
    const V3f p3 = sphere.path.position(to);
    const std::array<V3f, 4> control = {p0, p0 + third * derivative(sphere.path, from),
                                        p3 - third * derivative(sphere.path, to), p3};
    const V3f radius(sphere.radius);
    const bool always = from <= 0 && to >= 1;
    if (!always) {
        Box box;
        for (const V3f& p : control) {
            box.extendBy(p - radius);
            box.extendBy(p + radius);
        }
        return {widened(box), widened(box)};
    }
    Box deviation;
    for (int k = 0; k < 4; ++k) {
        deviation.extendBy(control[k] - (p0 + (static_cast<float>(k) / 3) * (p3 - p0)));
    }
    return {widened({p0 + deviation.min - radius, p0 + deviation.max + radius}),
            widened({p3 + deviation.min - radius, p3 + deviation.max + radius})};
}

MovingBounds still(const Box& box) {
    return {widened(box), widened(box)};
}

/// Of the unit cube: what the margins of intersect.h add to a shape, and more.
constexpr double kUnitWidening = 1.00005;

/// World bounds of the unit cube (flat: of its slice z = 0) under the map's inverse.
MovingBounds mapped_bounds(const MappedShape& shape, bool flat) {
    Mat44 unit_from_world;
    for (int row = 0; row < 3; ++row) {
        for (int axis = 0; axis < 3; ++axis) {
            unit_from_world[row][axis] =
                static_cast<double>(shape.unit_from_world.linear[row][axis]);
        }
        unit_from_world[3][row] = static_cast<double>(shape.unit_from_world.translation[row]);
    }
    const Mat44 world_from_unit = unit_from_world.inverse();
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1,
                     flat ? 0 : ((corner & 4) ? 1 : -1));
        box.extendBy(V3f((kUnitWidening * p) * world_from_unit));
    }
    return still(box);
}

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
    const Box& box = args->timeStep == 0 ? bounds.open : bounds.close;
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
    add(all.shapes, Kind::still_sphere, all.blocks.still_spheres, still_spheres, sphere_bounds);
    add(all.shapes, Kind::moving_sphere, all.blocks.moving_spheres, moving_spheres, sphere_bounds);
    add(all.shapes, Kind::box, all.blocks.boxes, shapes.boxes, [](const AlignedBox& box) {
        return still({box.low, box.high});
    });
    const auto solid = [](const MappedShape& shape) { return mapped_bounds(shape, false); };
    const auto flat = [](const MappedShape& shape) { return mapped_bounds(shape, true); };
    add(all.shapes, Kind::mapped_ball, all.blocks.mapped_balls, shapes.mapped_balls, solid);
    add(all.shapes, Kind::mapped_box, all.blocks.mapped_boxes, shapes.mapped_boxes, solid);
    add(all.shapes, Kind::rectangle, all.blocks.rectangles, shapes.rectangles, flat);
    add(all.shapes, Kind::triangle, all.blocks.triangles, shapes.triangles, flat);
    add(all.shapes, Kind::disk, all.blocks.disks, shapes.disks, flat);
    add(all.shapes, Kind::frustum, all.blocks.frustums, shapes.frustums, solid);
    for (std::uint32_t i = 0; i < shapes.moving.size(); ++i) {
        const MovingShape& shape = shapes.moving[i];
        if (shape.kind != MovingShape::Kind::plane) {
            all.shapes.push_back({Kind::moving, i, shape.object, still(shape.bounds)});
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
