// A right-handed frame around a direction.
#pragma once

#include <cmath>

#include "render/geometry/ray.h"

namespace carom::render {

/// Unit vectors with x cross y = z.
struct OrthonormalBasis {
    V3f x, y, z;

    /// A frame around the unit vector `z`: Duff et al. 2017, "Building an orthonormal basis,
    /// revisited", listing 3; without branches and accurate for every direction.
    [[nodiscard]] static OrthonormalBasis around(const V3f& z) {
        const float sign = std::copysign(1.f, z.z);
        const float a = -1 / (sign + z.z);
        const float b = z.x * z.y * a;
        return {V3f(1 + sign * z.x * z.x * a, sign * b, -sign * z.x),
                V3f(b, sign + z.y * z.y * a, -z.y), z};
    }

    [[nodiscard]] V3f to_world(const V3f& v) const { return v.x * x + v.y * y + v.z * z; }
    [[nodiscard]] V3f from_world(const V3f& v) const { return V3f(v.dot(x), v.dot(y), v.dot(z)); }
};

}  // namespace carom::render
