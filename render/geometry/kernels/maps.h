// Affine maps, poses of bodies, and rays in their axes, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// Part of a ray. The direction has any length except zero, and distances are in units of it.
template <class L>
struct RayOf {
    Vec3Of<L> origin, direction;

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> at(ValueOf<L> t) const { return origin + direction * t; }
};

/// See Affine.
template <class L>
struct AffineOf {
    Vec3Of<L> rows[3];
    Vec3Of<L> translation;

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> vector(const Vec3Of<L>& v) const {
        return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z;
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> point(const Vec3Of<L>& p) const {
        return vector(p) + translation;
    }
    [[nodiscard]] CAROM_KERNEL RayOf<L> ray(const RayOf<L>& from) const {
        return {point(from.origin), vector(from.direction)};
    }
    /// What the inverse of this map does to a normal. The result has any length.
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> inverse_normal(const Vec3Of<L>& n) const {
        return {dot(n, rows[0]), dot(n, rows[1]), dot(n, rows[2])};
    }
};

template <class L>
CAROM_KERNEL AffineOf<L> affine_of(const Affine& map) {
    const auto row = [&](int i) CAROM_KERNEL_ATTRIBUTE {
        return Vec3Of<L>{L::all(map.linear[i][0]), L::all(map.linear[i][1]),
                         L::all(map.linear[i][2])};
    };
    return {{row(0), row(1), row(2)}, all_of<L>(map.translation)};
}

/// A rotation by the unit quaternion with the real part `real`.
template <class L>
struct RotationOf {
    ValueOf<L> real;
    Vec3Of<L> vector;

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> apply(const Vec3Of<L>& v) const {
        const Vec3Of<L> t = cross(vector, v) * L::all(2);
        return v + t * real + cross(vector, t);
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> undo(const Vec3Of<L>& v) const {
        const Vec3Of<L> t = cross(v, vector) * L::all(2);
        return v + t * real + cross(t, vector);
    }
};

/// First b, then a.
template <class L>
CAROM_KERNEL RotationOf<L> operator*(const RotationOf<L>& a, const RotationOf<L>& b) {
    return {a.real * b.real - dot(a.vector, b.vector),
            b.vector * a.real + a.vector * b.real + cross(a.vector, b.vector)};
}

/// Where a body is: world from body axes.
template <class L>
struct PoseOf {
    Vec3Of<L> position;
    RotationOf<L> rotation;

    /// A ray of the world in the axes of the body.
    [[nodiscard]] CAROM_KERNEL RayOf<L> in_body(const RayOf<L>& ray) const {
        return {rotation.undo(ray.origin - position), rotation.undo(ray.direction)};
    }
};

/// A point on a cubic piece of a path, at the time d after its start; see PathPiece.
template <class L>
CAROM_KERNEL Vec3Of<L> point_on_path(const Vec3Of<L>& c0, const Vec3Of<L>& c1, const Vec3Of<L>& c2,
                                     const Vec3Of<L>& c3, ValueOf<L> d) {
    return c0 + (c1 + (c2 + c3 * d) * d) * d;
}
