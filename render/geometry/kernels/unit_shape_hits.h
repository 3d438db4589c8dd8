// Rays against the unit shapes (render/acceleration/shape_list.h), in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// What distinguishes unit shapes of the same kind.
template <class L>
struct UnitFormOf {
    Vec3Of<L> parameters;  // what an affine map cannot produce (shape_list.h)
    ValueOf<L> one_sided;  // rectangles and disks: not 0 if rays from below pass
};

/// The first hit beyond t_min >= 0 of a ray in the axes of the unit shape.
template <ShapeKind kKind, class L>
CAROM_KERNEL DistanceOf<L> hit_unit_shape(const RayOf<L>& ray, ValueOf<L> t_min,
                                          const UnitFormOf<L>& form) {
    if constexpr (kKind == ShapeKind::sphere) {
        return hit_unit_sphere<L>(ray, t_min);
    } else if constexpr (kKind == ShapeKind::box) {
        return hit_unit_box<L>(ray, t_min);
    } else if constexpr (kKind == ShapeKind::rectangle) {
        return hit_unit_rectangle<L>(ray, t_min, form.one_sided);
    } else if constexpr (kKind == ShapeKind::triangle) {
        return hit_unit_triangle<L>(ray, t_min);
    } else if constexpr (kKind == ShapeKind::disk) {
        return hit_unit_disk<L>(ray, t_min, form.one_sided);
    } else if constexpr (kKind == ShapeKind::frustum) {
        return hit_unit_frustum<L>(ray, t_min, form.parameters.x, form.parameters.y);
    } else if constexpr (kKind == ShapeKind::capsule) {
        return hit_unit_capsule<L>(ray, t_min, form.parameters.x);
    } else if constexpr (kKind == ShapeKind::rounded_box) {
        return hit_unit_rounded_box<L>(ray, t_min, form.parameters);
    } else {
        static_assert(kKind == ShapeKind::plane, "a kind without a test");
        return hit_unit_plane<L>(ray, t_min);
    }
}
