#include "pipeline/check/shape_box.h"

#include <algorithm>
#include <initializer_list>
#include <variant>

namespace carom::pipeline {

namespace {

using Box = Imath::Box3d;

/// Centre at the origin.
Box box_of_size(const Vec3& size) {
    return {-0.5 * size, 0.5 * size};
}

/// About the z axis.
Box box_of_round(double radius, double height) {
    return box_of_size({2 * radius, 2 * radius, height});
}

template <class Points>
Box box_of_points(const Points& points) {
    Box box;
    for (const Vec3& point : points) {
        box.extendBy(point);
    }
    return box;
}

struct BoxMaker {
    using Result = std::optional<Box>;

    Result operator()(const render::SphereShape& s) const {
        return box_of_round(s.radius, 2 * s.radius);
    }
    Result operator()(const render::BoxShape& s) const { return box_of_size(s.size); }
    Result operator()(const render::PlaneShape& /*infinite*/) const { return std::nullopt; }
    Result operator()(const render::RectangleShape& s) const {
        return box_of_size({s.size.x, s.size.y, 0});
    }
    Result operator()(const render::MeshShape& s) const {
        return s.vertices.empty() ? std::nullopt : Result(box_of_points(s.vertices));
    }
    Result operator()(const render::TriangleShape& s) const { return box_of_points(s.corners); }
    Result operator()(const render::ParallelogramShape& s) const {
        return box_of_points(std::initializer_list<Vec3>{
            s.corner, s.corner + s.edge_u, s.corner + s.edge_v, s.corner + s.edge_u + s.edge_v});
    }
    Result operator()(const render::DiskShape& s) const { return box_of_round(s.radius, 0); }
    Result operator()(const render::CylinderShape& s) const {
        return box_of_round(s.radius, s.height);
    }
    Result operator()(const render::ConeShape& s) const {
        return box_of_round(std::max(s.radius, s.top_radius), s.height);
    }
    Result operator()(const render::CapsuleShape& s) const {
        return box_of_round(s.radius, s.length + 2 * s.radius);
    }
    Result operator()(const render::RoundedBoxShape& s) const { return box_of_size(s.size); }
};

}  // namespace

std::optional<Imath::Box3d> box_of(const render::Shape& shape) {
    return std::visit(BoxMaker{}, shape);
}

}  // namespace carom::pipeline
