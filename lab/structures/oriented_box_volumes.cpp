#include "lab/structures/oriented_box_volumes.h"

#include <Imath/ImathMatrixAlgo.h>

namespace carom::render {
namespace {

using Axes = std::array<V3f, 3>;
using Volume = OrientedBoxVolumes::Volume;

constexpr Axes kWorldAxes{V3f(1, 0, 0), V3f(0, 1, 0), V3f(0, 0, 1)};

Volume box_along(const Axes& axes, const Outlines& outlines,
                 std::span<const std::uint32_t> shapes) {
    Volume volume{axes, {}};
    for (const std::uint32_t shape : shapes) {
        for (std::size_t k = 0; k < 3; ++k) {
            volume.extents[k].extend(outlines.extent(shape, axes[k]));
        }
    }
    return volume;
}

float half_area_of(const Volume& volume) {
    const auto size = [&](std::size_t k) { return volume.extents[k].high - volume.extents[k].low; };
    return size(0) * size(1) + size(1) * size(2) + size(2) * size(0);
}

Volume smallest_of(std::span<const Axes> choices, const Outlines& outlines,
                   std::span<const std::uint32_t> shapes) {
    Volume best = box_along(choices.front(), outlines, shapes);
    for (const Axes& axes : choices.subspan(1)) {
        const Volume other = box_along(axes, outlines, shapes);
        best = half_area_of(other) < half_area_of(best) ? other : best;
    }
    return best;
}

/// Perpendicular directions: `first`, and `second` as far as it is across `first`.
Axes axes_along(const V3f& first, const V3f& second) {
    const V3f x = first.normalized();
    V3f y = second - x * second.dot(x);
    if (!(y.length2() > 1e-6f * second.length2())) {
        y = std::abs(x.z) < 0.9f ? x.cross(V3f(0, 0, 1)) : x.cross(V3f(1, 0, 0));
    }
    y.normalize();
    return {x, y, x.cross(y)};
}

/// Those of the shape itself; the longest side of a triangle.
Axes axes_of(const Outline& outline) {
    const auto& half = outline.half;
    if (outline.form != Outline::Form::triangle) {
        return axes_along(half[0], half[1]);
    }
    const V3f third = half[1] - half[0];
    if (third.length2() > std::max(half[0].length2(), half[1].length2())) {
        return axes_along(third, half[0]);
    }
    return half[0].length2() > half[1].length2() ? axes_along(half[0], half[1])
                                                 : axes_along(half[1], half[0]);
}

/// The eigenvectors of the covariance of the outlines' corners.
Axes principal_axes(const Outlines& outlines, std::span<const std::uint32_t> shapes) {
    Vec3 mean(0, 0, 0);
    for (const std::uint32_t shape : shapes) {
        mean += Vec3(outlines.box(shape).center());
    }
    mean /= static_cast<double>(shapes.size());
    Imath::M33d covariance(0.0);
    const auto add = [&](const Vec3& v) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                covariance[i][k] += v[i] * v[k];
            }
        }
    };
    for (const std::uint32_t shape : shapes) {
        const Outline& outline = outlines[shape];
        add(Vec3(outlines.box(shape).center()) - mean);
        for (const V3f& half : outline.half) {
            add(Vec3(half));
        }
    }
    Imath::V3d values;
    Imath::M33d vectors;
    Imath::jacobiEigenSolver(covariance, values, vectors);
    const auto column = [&](int k) {
        return V3f(Vec3(vectors[0][k], vectors[1][k], vectors[2][k]));
    };
    return axes_along(column(0), column(1));
}

}  // namespace

Volume OrientedBoxVolumes::around(const Outlines& outlines, std::uint32_t shape) {
    const std::array<Axes, 2> choices{kWorldAxes, axes_of(outlines[shape])};
    return smallest_of(choices, outlines, std::span(&shape, 1));
}

Volume OrientedBoxVolumes::around(const Outlines& outlines, std::span<const std::uint32_t> shapes,
                                  const Volume& left, const Volume& right) {
    const std::array<Axes, 4> choices{kWorldAxes, principal_axes(outlines, shapes), left.axes,
                                      right.axes};
    return smallest_of(choices, outlines, shapes);
}

}  // namespace carom::render
