// Affine maps in float, converted from the scene's doubles.
#pragma once

#include "core/vectors.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// p_b = p_a * linear + translation, in Imath's row-vector convention: the rows of `linear` are the
/// images of a's axes.
struct Affine {
    Imath::M33f linear{};
    V3f translation{0, 0, 0};

    [[nodiscard]] V3f point(const V3f& p) const { return p * linear + translation; }
    [[nodiscard]] V3f vector(const V3f& v) const { return v * linear; }

    /// Maps a normal. `inverse`, the inverse of this map, maps b to a. The result is not
    /// normalised.
    [[nodiscard]] static V3f normal(const V3f& n, const Affine& inverse) {
        const Imath::M33f& m = inverse.linear;
        return V3f(n.x * m[0][0] + n.y * m[0][1] + n.z * m[0][2],
                   n.x * m[1][0] + n.y * m[1][1] + n.z * m[1][2],
                   n.x * m[2][0] + n.y * m[2][1] + n.z * m[2][2]);
    }

    /// The affine part of a 4x4 matrix, rounded once.
    [[nodiscard]] static Affine narrowed(const Mat44& m) {
        Affine result;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                result.linear[i][j] = static_cast<float>(m[i][j]);
            }
            result.translation[i] = static_cast<float>(m[3][i]);
        }
        return result;
    }
};

[[nodiscard]] inline V3f narrowed(const Vec3& v) {
    return V3f(v);
}

/// The scale factors of the three object axes: the lengths of the rows.
[[nodiscard]] inline Vec3 axis_scales(const Mat44& m) {
    const auto length = [&](int i) { return Vec3(m[i][0], m[i][1], m[i][2]).length(); };
    return Vec3(length(0), length(1), length(2));
}

}  // namespace carom::render
