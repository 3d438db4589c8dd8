// The single list of the shapes that rays can hit. All code that enumerates shapes is a fold over
// it.
//
// To add a shape: give it a ShapeKind, a struct below and a place in UnitShapes, and in
// render/geometry/kernels/ its test (unit_shape_hits.h) and its surface (unit_points.h). A missing
// part does not compile.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/vectors.h"
#include "render/acceleration/analytic_blocks.h"
#include "render/geometry/shape_kind.h"

namespace carom::render {

/// Each unit shape has
/// - kKind and Block, the storage of eight of them for the kernels;
/// - kIsBounded: whether a bounding box exists;
/// - half_size(parameters): of a bounding box centred at the origin;
/// - bounding_radius(scale, parameters): the largest distance of its surface from its centre if the
///   map scales its axes by `scale` and keeps them perpendicular.
/// `parameters` holds the parameters of the shape that an affine map cannot produce; most shapes
/// have none.
template <ShapeKind kKindOfShape, class BlockOfShape = MappedBlock>
struct UnitShape {
    static constexpr ShapeKind kKind = kKindOfShape;
    static constexpr bool kIsBounded = true;
    using Block = BlockOfShape;
    static V3f half_size(const V3f& /*parameters*/) { return V3f(1); }
};

/// Base of the shapes in the plane z = 0.
template <ShapeKind kKindOfShape>
struct FlatShape : UnitShape<kKindOfShape> {
    static V3f half_size(const V3f& /*parameters*/) { return V3f(1, 1, 0); }
    static double bounding_radius(const Vec3& scale, const V3f& /*parameters*/) {
        return Vec2(scale.x, scale.y).length();
    }
};

/// |p| <= 1.
struct UnitSphere : UnitShape<ShapeKind::sphere> {
    static double bounding_radius(const Vec3& scale, const V3f& /*parameters*/) {
        return std::max({scale.x, scale.y, scale.z});
    }
};

/// |x|, |y|, |z| <= 1.
struct UnitBox : UnitShape<ShapeKind::box> {
    static double bounding_radius(const Vec3& scale, const V3f& /*parameters*/) {
        return scale.length();
    }
};

/// |x|, |y| <= 1.
struct UnitRectangle : FlatShape<ShapeKind::rectangle> {};

/// x, y >= 0 and x + y <= 1.
struct UnitTriangle : FlatShape<ShapeKind::triangle> {};

/// x^2 + y^2 <= 1.
struct UnitDisk : FlatShape<ShapeKind::disk> {
    static double bounding_radius(const Vec3& scale, const V3f& /*parameters*/) {
        return std::max(scale.x, scale.y);
    }
};

/// x^2 + y^2 <= (middle + slope z)^2 and |z| <= 1, with the parameters (middle, slope, 0): (1, 0,
/// 0) is a cylinder, (1/2, -1/2, 0) a cone.
struct UnitFrustum : UnitShape<ShapeKind::frustum, ParameterBlock> {
    static double bounding_radius(const Vec3& scale, const V3f& /*parameters*/) {
        return Vec2(std::max(scale.x, scale.y), scale.z).length();
    }
};

/// All points within distance 1 of the segment from (0, 0, -h) to (0, 0, h), with the parameters
/// (h, 0, 0).
struct UnitCapsule : UnitShape<ShapeKind::capsule, ParameterBlock> {
    static V3f half_size(const V3f& parameters) { return V3f(1, 1, 1 + parameters.x); }
    static double bounding_radius(const Vec3& scale, const V3f& parameters) {
        return static_cast<double>(parameters.x) * scale.z + std::max({scale.x, scale.y, scale.z});
    }
};

/// All points within distance 1 of the box |p| <= core; the parameters are `core`.
struct UnitRoundedBox : UnitShape<ShapeKind::rounded_box, ParameterBlock> {
    static V3f half_size(const V3f& parameters) { return parameters + V3f(1); }
    static double bounding_radius(const Vec3& scale, const V3f& parameters) {
        return (scale * Vec3(parameters)).length() + std::max({scale.x, scale.y, scale.z});
    }
};

/// The infinite plane z = 0.
struct UnitPlane : UnitShape<ShapeKind::plane> {
    static constexpr bool kIsBounded = false;
    static double bounding_radius(const Vec3& /*scale*/, const V3f& /*parameters*/) { return 1; }
};

template <class... Shapes>
struct ShapeList {
    static constexpr std::size_t kSize = sizeof...(Shapes);

    /// The number of shapes in the list before `Shape`.
    template <class Shape>
    static constexpr std::uint32_t index_of() {
        static_assert((std::same_as<Shape, Shapes> || ...), "the shape is not in the list");
        std::uint32_t index = 0;
        static_cast<void>(((std::same_as<Shape, Shapes> || (++index, false)) || ...));
        return index;
    }
};

/// In the order of ShapeKind.
using UnitShapes = ShapeList<UnitSphere, UnitBox, UnitRectangle, UnitTriangle, UnitDisk,
                             UnitFrustum, UnitCapsule, UnitRoundedBox, UnitPlane>;

// Special cases of spheres and boxes that are faster to test than under an affine map.
struct StaticSphere {
    using Block = StaticSphereBlock;
    static constexpr bool kIsBounded = true;
};
struct MovingSphere {
    using Block = MovingSphereBlock;
    static constexpr bool kIsBounded = true;
};
/// A box along the axes of the world.
struct AlignedBox {
    using Block = AlignedBoxBlock;
    static constexpr bool kIsBounded = true;
};

template <class List>
struct WithSpecialCases;
template <class... Shapes>
struct WithSpecialCases<ShapeList<Shapes...>> {
    using List = ShapeList<StaticSphere, MovingSphere, AlignedBox, Shapes...>;
};

/// All shapes for which the kernels have a test.
using LaneShapes = WithSpecialCases<UnitShapes>::List;

/// The number of a kernel shape, where its type cannot be used.
template <class Shape>
inline constexpr std::uint32_t kLaneShape = LaneShapes::index_of<Shape>();
inline constexpr std::uint32_t kLaneShapeCount = LaneShapes::kSize;

template <class Shape>
concept CompleteUnitShape = requires(const V3f& parameters, const Vec3& scale,
                                     typename Shape::Block& block) {
    { Shape::kKind } -> std::convertible_to<ShapeKind>;
    { Shape::kIsBounded } -> std::convertible_to<bool>;
    { Shape::half_size(parameters) } -> std::same_as<V3f>;
    { Shape::bounding_radius(scale, parameters) } -> std::same_as<double>;
    block.set_parameters(0, parameters);
};

template <class... Shapes>
constexpr bool is_complete(ShapeList<Shapes...> list) {
    using List = decltype(list);
    static_assert((CompleteUnitShape<Shapes> && ...), "a shape lacks a member");
    static_assert(
        ((static_cast<std::uint32_t>(Shapes::kKind) == List::template index_of<Shapes>()) && ...),
        "the list is not in the order of ShapeKind");
    static_assert(List::kSize == static_cast<std::size_t>(ShapeKind::mesh),
                  "the list lacks a kind");
    return true;
}
static_assert(is_complete(UnitShapes()));

/// Calls `visitor(Shape())` with the unit shape of `kind`; does nothing for meshes.
template <class Visitor>
void visit_shape(ShapeKind kind, const Visitor& visitor) {
    const auto visit = [&]<class... Shapes>(ShapeList<Shapes...>) {
        static_cast<void>(((kind == Shapes::kKind && (visitor(Shapes()), true)) || ...));
    };
    visit(UnitShapes());
}
/// Returns the visitor's result; `of_mesh` for meshes.
template <class Result, class Visitor>
[[nodiscard]] Result visit_shape(ShapeKind kind, Result of_mesh, const Visitor& visitor) {
    visit_shape(kind, [&](auto shape) { of_mesh = visitor(shape); });
    return of_mesh;
}

}  // namespace carom::render
