// A right-handed frame around a direction, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Unit vectors with x cross y = z.
template <class L>
struct BasisOf {
    Vec3Of<L> x, y, z;

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> to_world(const Vec3Of<L>& v) const {
        return x * v.x + y * v.y + z * v.z;
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> from_world(const Vec3Of<L>& v) const {
        return {dot(v, x), dot(v, y), dot(v, z)};
    }
};

/// A frame around the unit vector `z`: Duff et al. 2017, "Building an orthonormal basis,
/// revisited", listing 3; without branches and accurate for every direction.
template <class L>
CAROM_KERNEL BasisOf<L> basis_around(const Vec3Of<L>& z) {
    const auto sign = L::flip_sign(L::all(1), z.z);
    const auto a = L::all(-1) / (sign + z.z);
    const auto b = z.x * z.y * a;
    return {{L::all(1) + sign * z.x * z.x * a, sign * b, L::opposite_sign(sign) * z.x},
            {b, sign + z.y * z.y * a, L::opposite_sign(z.y)},
            z};
}
