#include "sim/solid_shape.h"

#include "core/rigid.h"
#include "sim/shape/mass_properties.h"

namespace carom::sim {
namespace {

SolidShape along_own_axes(ConvexShape shape, const Vec3& inertia) {
    return {std::make_shared<const ConvexShape>(std::move(shape)), Quat(), inertia};
}

struct ShapeOf {
    std::optional<SolidShape> operator()(const Sphere&) const { return std::nullopt; }
    std::optional<SolidShape> operator()(const TriangleMesh&) const { return std::nullopt; }
    std::optional<SolidShape> operator()(const Box& box) const {
        return along_own_axes(ConvexShape::box(box.size * 0.5), box_inertia(box.size));
    }
    std::optional<SolidShape> operator()(const Capsule& capsule) const {
        return along_own_axes(ConvexShape::capsule(capsule.radius, 0.5 * capsule.length),
                              capsule_inertia(capsule.radius, capsule.length));
    }
    std::optional<SolidShape> operator()(const Cylinder& cylinder) const {
        return along_own_axes(ConvexShape::cylinder(cylinder.radius, 0.5 * cylinder.height),
                              cylinder_inertia(cylinder.radius, cylinder.height));
    }
    std::optional<SolidShape> operator()(const ConvexHull& points) const {
        std::optional<Polyhedron> hull = convex_hull(points.points);
        if (!hull) {
            return std::nullopt;
        }
        const MassProperties properties = mass_properties(*hull);
        for (Vec3& vertex : hull->vertices) {
            vertex = to_body(properties.principal, vertex - properties.centre);
        }
        for (PolyhedronFace& face : hull->faces) {
            face.normal = to_body(properties.principal, face.normal);
        }
        return SolidShape{std::make_shared<const ConvexShape>(ConvexShape::hull(std::move(*hull))),
                          properties.principal, properties.inertia};
    }
};

}  // namespace

std::optional<SolidShape> solid_shape(const BodyShape& shape) {
    return std::visit(ShapeOf(), shape);
}

Aabb bounds_of(const PlacedShape& solid) {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction(0, 0, 0);
        direction[axis] = 1;
        box.high[axis] = solid.support(direction)[axis];
        box.low[axis] = solid.support(-direction)[axis];
    }
    return box;
}

}  // namespace carom::sim
