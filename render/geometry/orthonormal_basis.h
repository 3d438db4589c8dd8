// A right-handed frame around a direction.
#pragma once

#include "render/geometry/ray.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

/// Unit vectors with x cross y = z.
struct OrthonormalBasis {
    V3f x, y, z;

    /// A frame around the unit vector `z` (kernels/basis.h).
    [[nodiscard]] static OrthonormalBasis around(const V3f& z) {
        const auto basis = scalar::basis_around<scalar::One>(scalar::three(z));
        return {scalar::vector_of(basis.x), scalar::vector_of(basis.y), z};
    }

    [[nodiscard]] V3f to_world(const V3f& v) const { return v.x * x + v.y * y + v.z * z; }
    [[nodiscard]] V3f from_world(const V3f& v) const { return V3f(v.dot(x), v.dot(y), v.dot(z)); }
};

}  // namespace carom::render
