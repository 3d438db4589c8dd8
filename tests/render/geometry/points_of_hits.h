// Included as render/lanes/kernels/vectors.h is.

/// Reads the numbers of hits on moving shapes with `read`, and passes those of their points to
/// `write`.
template <class L, class Read, class Write>
CAROM_KERNEL void points_of_hits(render::ShapeKind kind, const Read& read, const Write& write) {
    const auto three = [&](int i) CAROM_KERNEL_ATTRIBUTE {
        return Vec3<typename L::Value>{read(i), read(i + 1), read(i + 2)};
    };
    const auto map = [&](int i) CAROM_KERNEL_ATTRIBUTE {
        return AffineOf<L>{{three(i), three(i + 3), three(i + 6)}, three(i + 9)};
    };
    const PoseOf<L> body{three(0), {read(3), three(4)}};
    const RayOf<L> ray{three(7), three(10)};
    const MappedShapeOf<L> shape{map(14), map(26), map(38), three(50), three(53)};
    const SurfacePointOf<L> point =
        moved<L>(body, {true, true},
                 point_on_shape<L>(kind, shape, body.in_body(ray), read(13), {true, true}));
    const Vec3<typename L::Value> vectors[6] = {point.position,       point.geometric_normal,
                                                point.shading_normal, point.object_position,
                                                point.u_gradient,     point.v_gradient};
    for (int i = 0; i < 6; ++i) {
        write(3 * i, vectors[i].x);
        write(3 * i + 1, vectors[i].y);
        write(3 * i + 2, vectors[i].z);
    }
    write(18, point.uv.x);
    write(19, point.uv.y);
    write(20, point.uv_metres.x);
    write(21, point.uv_metres.y);
}
