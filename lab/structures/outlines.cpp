#include "lab/structures/outlines.h"

#include <cmath>
#include <type_traits>

namespace carom::render {
namespace {

using Form = Outline::Form;

Outline outline_of(const Imath::Box3f& box) {
    const V3f half = 0.5f * box.size();
    return {Form::box, box.center(), {V3f(half.x, 0, 0), V3f(0, half.y, 0), V3f(0, 0, half.z)}};
}

template <class Shape>
constexpr Form form_of() {
    if constexpr (std::is_same_v<Shape, UnitSphere>) {
        return Form::ball;
    } else if constexpr (std::is_same_v<Shape, UnitFrustum> || std::is_same_v<Shape, UnitDisk>) {
        return Form::tube;
    } else {
        return Form::box;
    }
}

/// Of a unit shape under an affine map that keeps its axes perpendicular.
template <class Shape>
Outline outline_of(const BlockList<Shape>& list, std::uint32_t index) {
    const auto& block = list.blocks[index / kBlockLanes];
    const int lane = static_cast<int>(index % kBlockLanes);
    const Mat44 map = world_from_unit(block.unit_from_world(lane));
    const V3f half_size = Shape::half_size(block.parameters_of(lane));
    Outline result{form_of<Shape>(), V3f(map.translation()), {}};
    for (int axis = 0; axis < 3; ++axis) {
        const double half = kUnitWidening * static_cast<double>(half_size[axis]);
        result.half[static_cast<std::size_t>(axis)] =
            V3f(half * Vec3(map[axis][0], map[axis][1], map[axis][2]));
    }
    return result;
}

Outline outline_of(const Primitives& primitives, const Primitive& shape) {
    const Imath::Box3f box = swept_box(primitives, shape);
    Outline result = outline_of(box);
    if (shape.shape == kLaneShape<StaticSphere>) {
        result.form = Form::ball;  // in the cube around it
    } else if (shape.shape == Primitive::kMeshTriangle) {
        const auto [a, b, c] = primitives.corners(shape);
        result = {Form::triangle, a, {b - a, c - a, V3f(0)}};
    } else {
        primitives.blocks().each([&]<class Shape>(const BlockList<Shape>& list) {
            if constexpr (CompleteUnitShape<Shape>) {
                if (shape.shape == kLaneShape<Shape>) {
                    result = outline_of(list, shape.index);
                }
            }
        });
    }
    return result;
}

/// The interval of the outline alone.
Extent extent_of(const Outline& outline, const V3f& normal) {
    const float middle = outline.centre.dot(normal);
    const V3f across(outline.half[0].dot(normal), outline.half[1].dot(normal),
                     outline.half[2].dot(normal));
    float half = 0;
    switch (outline.form) {
        case Form::triangle:
            return {middle + std::min({0.f, across.x, across.y}),
                    middle + std::max({0.f, across.x, across.y})};
        case Form::box:
            half = std::abs(across.x) + std::abs(across.y) + std::abs(across.z);
            break;
        case Form::tube:
            half = V2f(across.x, across.y).length() + std::abs(across.z);
            break;
        case Form::ball:
            half = across.length();
            break;
    }
    return {middle - half, middle + half};
}

/// The farthest corner of a box or rim of a tube: with the vector d from the point to the centre,
/// the half axes h_k and the radius r,
///   |d|^2 + sum (2 |d . h_k| + |h_k|^2)  or  |d|^2 + 2 d_r r + r^2 + 2 |d . h_2| + |h_2|^2,
/// where d_r is the part of d across the axis.
float reach_of(const Outline& outline, const V3f& point) {
    const V3f d = outline.centre - point;
    const auto& half = outline.half;
    const V3f size(half[0].length(), half[1].length(), half[2].length());
    const auto along = [&](std::size_t k) {
        return 2 * std::abs(d.dot(half[k])) + half[k].length2();
    };
    switch (outline.form) {
        case Form::triangle:
            return std::max({d.length(), (d + half[0]).length(), (d + half[1]).length()});
        case Form::ball:
            return d.length() + std::max({size.x, size.y, size.z});
        case Form::box:
            break;
        case Form::tube: {
            const float radius = std::max(size.x, size.y);
            const float axial = size.z > 0 ? d.dot(half[2]) / size.z : 0;
            const float across = std::sqrt(std::max(0.f, d.length2() - axial * axial));
            return std::sqrt(d.length2() + 2 * across * radius + radius * radius + along(2));
        }
    }
    return std::sqrt(d.length2() + along(0) + along(1) + along(2));
}

float sum_of_sizes(const V3f& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace

Outlines::Outlines(const Primitives& primitives) : boxes_(swept_boxes(primitives)) {
    outlines_.reserve(boxes_.size());
    for (const Primitive& shape : primitives.bounded()) {
        outlines_.push_back(outline_of(primitives, shape));
    }
}

Extent Outlines::extent(std::uint32_t shape, const V3f& normal) const {
    const Imath::Box3f& box = boxes_[shape];
    const Extent of_box = extent_of(outline_of(box), normal);
    const Extent of_outline = extent_of(outlines_[shape], normal);
    const float margin = volume_margin(sum_of_sizes(box.center()) + box.size().length());
    return {std::max(of_box.low, of_outline.low) - margin,
            std::min(of_box.high, of_outline.high) + margin};
}

float Outlines::reach(std::uint32_t shape, const V3f& point) const {
    const Imath::Box3f& box = boxes_[shape];
    const float margin = volume_margin(sum_of_sizes(box.center()) + box.size().length());
    return std::min(reach_of(outline_of(box), point), reach_of(outlines_[shape], point)) + margin;
}

}  // namespace carom::render
