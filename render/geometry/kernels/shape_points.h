// Points on the shapes of a scene in lanes: spheres, boxes along the axes, and unit shapes under
// affine maps, at rest or moving with a body. Included as render/lanes/kernels/vectors.h is.

/// Sets the object's axes, in those of the body.
template <class L>
CAROM_KERNEL void set_axes(const AffineOf<L>& metres_from_body, SurfacePointOf<L>& point) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    point.x_axis = metres_from_body.inverse_normal({one, zero, zero});
    point.y_axis = metres_from_body.inverse_normal({zero, one, zero});
    point.z_axis = metres_from_body.inverse_normal({zero, zero, one});
}

/// The point of a sphere around `centre` that a ray hits at distance t, without the place on its
/// texture.
template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_sphere(const RayOf<L>& ray, ValueOf<L> t,
                                               const Vec3Of<L>& centre, ValueOf<L> radius) {
    const Vec3Of<L> normal = unit<L>((ray.origin - centre) + ray.direction * t);
    SurfacePointOf<L> point;
    point.position = centre + normal * radius;
    point.geometric_normal = normal;
    point.shading_normal = normal;
    clear_texture_place<L>(point);
    return point;
}

/// Sets the place on a sphere's texture. `arm`: from the centre to the point, in the body's axes.
template <class L>
CAROM_KERNEL void set_place_on_sphere(const AffineOf<L>& metres_from_body, const Vec3Of<L>& arm,
                                      ValueOf<L> radius, TextureNeeds needs,
                                      SurfacePointOf<L>& point) {
    if (needs.position) {
        point.object_position = metres_from_body.vector(arm);
    }
    if (needs.axes) {
        set_axes<L>(metres_from_body, point);
    }
    if (needs.uv) {
        point.uv = longitude_latitude<L>(point.object_position);
        const LongitudeGradientsOf<L> gradients(point.object_position * (L::all(1) / radius),
                                                radius);
        point.u_gradient = metres_from_body.inverse_normal(gradients.u);
        point.v_gradient = metres_from_body.inverse_normal(gradients.v);
        point.uv_metres = {L::all(kTurn) * radius, L::all(0.5f * kTurn) * radius};
    }
}

/// The point of a box at rest along the world's axes.
template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_upright_box(const RayOf<L>& ray, ValueOf<L> t,
                                                    const Vec3Of<L>& centre,
                                                    const Vec3Of<L>& half_size,
                                                    TextureNeeds needs) {
    const FacePointOf<L> face = point_on_box<L>({ray.origin - centre, ray.direction}, t, half_size);
    SurfacePointOf<L> point;
    point.position = centre + face.position;
    point.geometric_normal = face.normal;
    point.shading_normal = face.normal;
    clear_texture_place<L>(point);
    point.object_position = face.position;
    if (needs.uv) {
        const Vec2Of<L> place = along_face<L>(face, face.position);
        const Vec2Of<L> sides = along_face<L>(face, half_size);
        point.uv = across_square<L>(place.x / sides.x, place.y / sides.y);
        point.uv_metres = {L::all(2) * sides.x, L::all(2) * sides.y};
        point.u_gradient = first_axis<L>(face, L::all(1) / point.uv_metres.x);
        point.v_gradient = second_axis<L>(face, L::all(1) / point.uv_metres.y);
    }
    return point;
}

/// A unit shape and its maps. For objects without a track, the body's axes are the world's.
template <class L>
struct MappedShapeOf {
    AffineOf<L> unit_from_body, body_from_unit;
    AffineOf<L> metres_from_body;  // only for textures
    Vec3Of<L> half_size;           // lengths of the unit shape's axes, m; only for uv
    Vec3Of<L> parameters;          // see UnitHitOf
};

/// The point of a unit shape that a ray hits; ray and point in the axes of the body.
template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_shape(ShapeKind kind, const MappedShapeOf<L>& shape,
                                              const RayOf<L>& ray, ValueOf<L> t,
                                              TextureNeeds needs) {
    const UnitPointOf<L> on_unit = on_unit_shape<L>(
        kind, {shape.unit_from_body.ray(ray), t, shape.parameters, shape.half_size, needs.uv});
    SurfacePointOf<L> point;
    point.position = shape.body_from_unit.point(on_unit.position);
    point.geometric_normal = unit<L>(shape.unit_from_body.inverse_normal(on_unit.normal));
    point.shading_normal = point.geometric_normal;
    clear_texture_place<L>(point);
    if (needs.position) {
        point.object_position = shape.metres_from_body.point(point.position);
    }
    if (needs.axes) {
        set_axes<L>(shape.metres_from_body, point);
    }
    if (needs.uv) {
        point.uv = on_unit.uv;
        point.uv_metres = on_unit.uv_metres;
        point.u_gradient = shape.unit_from_body.inverse_normal(on_unit.u_gradient);
        point.v_gradient = shape.unit_from_body.inverse_normal(on_unit.v_gradient);
    }
    return point;
}

template <class L>
CAROM_KERNEL void turn_gradients(const RotationOf<L>& turn, TextureNeeds needs,
                                 SurfacePointOf<L>& point) {
    if (needs.axes) {
        point.x_axis = turn.apply(point.x_axis);
        point.y_axis = turn.apply(point.y_axis);
        point.z_axis = turn.apply(point.z_axis);
    }
    if (needs.uv) {
        point.u_gradient = turn.apply(point.u_gradient);
        point.v_gradient = turn.apply(point.v_gradient);
    }
}

/// A point given in the axes of a body, in the world's.
template <class L>
CAROM_KERNEL SurfacePointOf<L> moved(const PoseOf<L>& body, TextureNeeds needs,
                                     SurfacePointOf<L> point) {
    point.position = body.position + body.rotation.apply(point.position);
    point.geometric_normal = body.rotation.apply(point.geometric_normal);
    point.shading_normal = body.rotation.apply(point.shading_normal);
    turn_gradients<L>(body.rotation, needs, point);
    return point;
}
