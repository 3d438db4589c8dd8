// Simple outlines of shapes, for bounding volumes other than boxes along the axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lab/structures/boxes.h"

namespace carom::render {

/// An interval along a direction.
struct Extent {
    float low = kInfinity;
    float high = -kInfinity;

    void extend(const Extent& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
};

/// A solid that contains a shape.
struct Outline {
    enum class Form {
        box,      // with the half edges `half`, which are perpendicular
        tube,     // a cylinder about half[2], with the half axes half[0] and half[1]
        ball,     // an ellipsoid with the half axes `half`
        triangle  // with the corners `centre`, centre + half[0] and centre + half[1]
    };
    Form form = Form::box;
    V3f centre;
    std::array<V3f, 3> half{};
};

/// The outlines of all bounded primitives, in their order. Balls, boxes, flat shapes, cylinders and
/// triangles at rest have their own; moving shapes have the box over the whole shutter.
class Outlines {
  public:
    explicit Outlines(const Primitives& primitives);

    [[nodiscard]] std::size_t size() const { return outlines_.size(); }
    [[nodiscard]] const Outline& operator[](std::uint32_t shape) const { return outlines_[shape]; }
    [[nodiscard]] const Imath::Box3f& box(std::uint32_t shape) const { return boxes_[shape]; }

    /// The interval that the shape covers along the unit `normal`, with a margin for rounding.
    [[nodiscard]] Extent extent(std::uint32_t shape, const V3f& normal) const;
    /// An upper bound on the distance from `point` to any point of the shape.
    [[nodiscard]] float reach(std::uint32_t shape, const V3f& point) const;

  private:
    std::vector<Outline> outlines_;
    std::vector<Imath::Box3f> boxes_;
};

/// A margin for the rounding of volumes and of tests against them, for a solid that begins at most
/// `far` from the origin of the coordinates.
[[nodiscard]] inline float volume_margin(float far) {
    return 1e-5f * std::max(far, 1e-3f);
}

}  // namespace carom::render
