// Emissive objects in lanes: their importance, and the sampling of curved shapes. Included as
// render/lanes/kernels/vectors.h is. Points, normals and directions are in the axes of the object's
// body.

/// 0 only where the whole object lies below the horizon. The orientation of its faces is left out.
template <class L>
CAROM_KERNEL ValueOf<L> importance_of_object(const ObjectImportance& object, const Vec3Of<L>& point,
                                             const Vec3Of<L>& normal) {
    const Vec3Of<L> to_light = all_of<L>(object.centre) - point;
    const auto distance2 = L::larger(dot(to_light, to_light), L::all(1e-12f));
    const auto distance = L::root(distance2);
    const auto cosine = dot(to_light, normal) / distance;
    const auto radius = L::all(object.bounding_radius);
    const auto is_hidden =
        L::both(L::is_less(radius, distance), L::is_at_most(cosine + radius / distance, L::all(0)));
    const auto seen =
        L::select(is_hidden, L::all(0), L::larger(cosine, L::all(kLeastHorizonCosine)));
    return L::all(object.strength) * seen / L::larger(distance2, radius * radius);
}

template <class L>
CAROM_KERNEL ValueOf<L> importance_of_surface(const EmissiveSurfaceConstants& surface,
                                              const Vec3Of<L>& point, const Vec3Of<L>& normal) {
    return surface.tree.exists() ? see_tree<L>(surface.tree, point, normal).total
                                 : importance_of_object<L>(surface.importance, point, normal);
}

template <class L>
CAROM_KERNEL ValueOf<L> importance_of_shape(const EmissiveShapeConstants& shape,
                                            const Vec3Of<L>& point, const Vec3Of<L>& normal) {
    return shape.kind == EmissiveShapeConstants::Kind::sphere
               ? SphereLightOf<L>{shape.sphere}.importance(point, normal)
               : importance_of_object<L>(shape.importance, point, normal);
}

/// A point of a unit shape's surface.
template <class L>
struct UnitSampleOf {
    Vec3Of<L> position;
    Vec3Of<L> normal;    // unit, outward
    ValueOf<L> density;  // per area of the unit shape, if the point faces the receiver
};

/// A part of the surface in each lane, and the number that chose it, used again.
template <class L>
struct PartOf {
    MaskOf<L> is_part[EmissiveShapeConstants::kMostParts];
    ValueOf<L> density, rest;
};

template <class L>
CAROM_KERNEL PartOf<L> choose_part(const EmissiveShapeConstants& shape, int count, ValueOf<L> u) {
    PartOf<L> part;
    auto is_open = L::is_at_most(L::all(0), u);  // always true
    part.density = L::all(1);
    part.rest = L::all(0);
    float low = 0;
    for (int i = 0; i < count; ++i) {
        const float high = shape.part_end[i];
        part.is_part[i] = L::both(is_open, L::is_less(u, L::all(high)));
        is_open = L::both(is_open, L::opposite(part.is_part[i]));
        if (high > low) {
            const auto rest =
                limited<L>((u - L::all(low)) / L::all(high - low), 0, kOneMinusEpsilon);
            part.rest = L::select(part.is_part[i], rest, part.rest);
            part.density = L::select(part.is_part[i], L::all(shape.part_density[i]), part.density);
        }
        low = high;
    }
    return part;
}

/// The parts of a frustum: side, top, bottom.
template <class L>
CAROM_KERNEL UnitSampleOf<L> sample_unit_frustum(const EmissiveShapeConstants& shape,
                                                 const Vec2Of<L>& u) {
    using V = ValueOf<L>;
    const float middle = shape.parameters.x;
    const float slope = shape.parameters.y;
    const PartOf<L> part = choose_part<L>(shape, 3, u.x);
    const SinCosOf<L> angle = sin_cos_turn<L>(u.y);
    // The radius of the side is linear in z, so its square is uniform.
    const V radius = L::root(L::larger(L::all(0), L::all((middle - slope) * (middle - slope)) +
                                                      L::all(4 * middle * slope) * part.rest));
    const V z =
        (L::all(slope - 2 * middle) + L::all(4 * middle) * part.rest) / (radius + L::all(middle));
    const V cap = L::root(part.rest) *
                  L::select(part.is_part[1], L::all(middle + slope), L::all(middle - slope));
    const auto is_side = part.is_part[0];
    const V r = L::select(is_side, radius, cap);
    const V end = L::select(part.is_part[1], L::all(1), L::all(-1));
    const V across = L::all(1) / L::root(L::all(1 + slope * slope));
    const V level = L::select(is_side, across, L::all(0));
    return {{r * angle.cosine, r * angle.sine, L::select(is_side, z, end)},
            {level * angle.cosine, level * angle.sine,
             L::select(is_side, L::all(-slope) * across, end)},
            part.density};
}

/// The parts of the points within distance 1 of a box: corners (together a sphere), edges along x,
/// y and z (cylinders), faces across x, y and z.
template <class L>
CAROM_KERNEL UnitSampleOf<L> sample_unit_rounded(const EmissiveShapeConstants& shape,
                                                 const Vec2Of<L>& u) {
    using V = ValueOf<L>;
    const PartOf<L> part = choose_part<L>(shape, 7, u.x);
    const SinCosOf<L> angle = sin_cos_turn<L>(u.y);
    const V zero = L::all(0);
    const V along = L::all(2) * part.rest - L::all(1);
    const V across = L::all(2) * u.y - L::all(1);
    const V level = L::root(L::larger(zero, L::all(1) - along * along));
    // A face: which of the two, and the place along its first side.
    const V side = L::select(L::is_less(part.rest, L::all(0.5f)), L::all(1), L::all(-1));
    const V place =
        L::all(2) * (along - L::select(L::is_less(zero, side), L::all(-0.5f), L::all(0.5f)));
    const auto is_corner = part.is_part[0];
    Vec3<V> normal{L::select(is_corner, level * angle.cosine, zero),
                   L::select(is_corner, level * angle.sine, zero),
                   L::select(is_corner, along, zero)};
    Vec3<V> core{zero, zero, zero};
    const Vec3<V> limits = all_of<L>(shape.parameters);
    const auto towards = [](V direction, V limit)
                             CAROM_KERNEL_ATTRIBUTE { return L::flip_sign(limit, direction); };
    const Vec3<V> corner{towards(normal.x, limits.x), towards(normal.y, limits.y),
                         towards(normal.z, limits.z)};
    core = select<L>(is_corner, corner, core);
    // `a` is the edge's or the face's axis; b and c follow it.
    using Number = V Vec3<V>::*;
    const auto put = [&](int axis, Number a, Number b, Number c) CAROM_KERNEL_ATTRIBUTE {
        const auto is_edge = part.is_part[1 + axis];
        normal.*b = L::select(is_edge, angle.cosine, normal.*b);
        normal.*c = L::select(is_edge, angle.sine, normal.*c);
        core.*a = L::select(is_edge, along * limits.*a, core.*a);
        core.*b = L::select(is_edge, towards(angle.cosine, limits.*b), core.*b);
        core.*c = L::select(is_edge, towards(angle.sine, limits.*c), core.*c);
        const auto is_face = part.is_part[4 + axis];
        normal.*a = L::select(is_face, side, normal.*a);
        core.*a = L::select(is_face, towards(side, limits.*a), core.*a);
        core.*b = L::select(is_face, place * limits.*b, core.*b);
        core.*c = L::select(is_face, across * limits.*c, core.*c);
    };
    put(0, &Vec3<V>::x, &Vec3<V>::y, &Vec3<V>::z);
    put(1, &Vec3<V>::y, &Vec3<V>::z, &Vec3<V>::x);
    put(2, &Vec3<V>::z, &Vec3<V>::x, &Vec3<V>::y);
    return {normal + core, normal, part.density};
}

/// A direction towards a point of the surface: uniform by area in each part.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_shape_by_area(const EmissiveShapeConstants& shape,
                                                   const Vec3Of<L>& point, const Vec2Of<L>& u) {
    using V = ValueOf<L>;
    using Kind = EmissiveShapeConstants::Kind;
    const AffineOf<L> unit_from_body = affine_of<L>(shape.unit_from_body);
    UnitSampleOf<L> found;
    if (shape.kind == Kind::disk) {
        const Vec2<V> place = sample_disk<L>(u);
        found = {{place.x, place.y, L::all(0)},
                 {L::all(0), L::all(0), L::all(1)},
                 L::all(shape.part_density[0])};
    } else if (shape.kind == Kind::frustum) {
        found = sample_unit_frustum<L>(shape, u);
    } else {
        found = sample_unit_rounded<L>(shape, u);
    }
    if (shape.is_symmetric) {
        const V height = dot(unit_from_body.point(point) - found.position, found.normal);
        const V sign = L::select(L::is_less(L::all(0), height), L::all(1), L::all(-1));
        found.position = found.position * sign;
        found.normal = found.normal * sign;
    }
    const Vec3<V> to_light = affine_of<L>(shape.body_from_unit).point(found.position) - point;
    // The unit shape's area grows by the length of this normal times `volume_scale`.
    const Vec3<V> normal = unit_from_body.inverse_normal(found.normal);
    const V height = L::opposite_sign(dot(to_light, normal));
    const V distance2 = dot(to_light, to_light);
    const auto valid =
        L::both(L::is_less(L::all(0), height), L::is_less(L::all(1e-18f), distance2));
    const V distance = L::root(L::select(valid, distance2, L::all(1)));
    const V pdf = found.density * distance2 * distance /
                  (L::select(valid, height, L::all(1)) * L::all(shape.volume_scale));
    return {to_light * (L::all(1) / distance), distance, pdf, all_of<L>(shape.radiance), valid};
}

/// 1 / sr in the axes of the unit sphere, for a point outside.
template <class L>
CAROM_KERNEL ValueOf<L> unit_cone(const Vec3Of<L>& point) {
    return one_minus_cos_of_sphere<L>(L::all(1), L::root(dot(point, point)));
}

/// Uniform within the cone that the unit sphere subtends, mapped to the body's axes: solid angles
/// grow by the determinant over the cube of the length to which the map stretches the direction.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_ellipsoid(const EmissiveShapeConstants& shape,
                                               const Vec3Of<L>& point, const Vec2Of<L>& u) {
    using V = ValueOf<L>;
    AreaLightConstants sphere;
    sphere.radius = 1;
    const LightSampleOf<L> found =
        SphereLightOf<L>{sphere}.sample(affine_of<L>(shape.unit_from_body).point(point), u);
    const Vec3<V> direction = affine_of<L>(shape.body_from_unit).vector(found.direction);
    const V stretch = L::root(dot(direction, direction));
    return {direction * (L::all(1) / stretch), found.distance * stretch,
            found.pdf * stretch * stretch * stretch / L::all(shape.volume_scale),
            all_of<L>(shape.radiance), found.valid};
}

/// Not valid within the shape, on its surface, and where the sampled point faces away.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_shape(const EmissiveShapeConstants& shape,
                                           const Vec3Of<L>& point, const Vec2Of<L>& u) {
    using Kind = EmissiveShapeConstants::Kind;
    LightSampleOf<L> found;
    if (shape.kind == Kind::sphere) {
        found = SphereLightOf<L>{shape.sphere}.sample(point, u);
    } else if (shape.kind == Kind::ellipsoid) {
        found = sample_ellipsoid<L>(shape, point, u);
    } else {
        found = sample_shape_by_area<L>(shape, point, u);
    }
    found.valid = L::both(found.valid, L::is_less(L::all(0), found.distance));
    return found;
}

/// Density of `sample_shape` (1/sr) for a ray from `point` that hits the shape at `distance` from
/// the front, where the unit `normal` points outward.
template <class L>
CAROM_KERNEL ValueOf<L> pdf_of_shape(const EmissiveShapeConstants& shape, const Vec3Of<L>& point,
                                     const Vec3Of<L>& direction, ValueOf<L> distance,
                                     const Vec3Of<L>& normal) {
    using V = ValueOf<L>;
    using Kind = EmissiveShapeConstants::Kind;
    const V one = L::all(1);
    if (shape.kind == Kind::sphere || shape.kind == Kind::ellipsoid) {
        const bool is_round = shape.kind == Kind::sphere;
        const Vec3<V> centre = all_of<L>(shape.sphere.centre);
        const Vec3<V> from_centre = is_round ? (point - centre) * L::all(1 / shape.sphere.radius)
                                             : affine_of<L>(shape.unit_from_body).point(point);
        const auto is_outside = L::is_less(one, dot(from_centre, from_centre));
        const V pdf = one / (L::all(kTurn) * unit_cone<L>(from_centre));
        V scale = one;
        if (!is_round) {
            const Vec3<V> along = affine_of<L>(shape.unit_from_body).vector(direction);
            const V shrink = L::root(dot(along, along));
            scale = one / (shrink * shrink * shrink * L::all(shape.volume_scale));
        }
        return L::select(is_outside, pdf * scale, L::all(0));
    }
    const V cosine = L::opposite_sign(dot(direction, normal));
    const auto faces = L::is_less(L::all(0), cosine);
    const Vec3<V> on_unit = affine_of<L>(shape.body_from_unit).inverse_normal(normal);
    const V size = L::root(dot(on_unit, on_unit));
    V density = L::all(shape.part_density[0]);
    if (shape.kind == Kind::frustum) {
        // A side is never as steep as this.
        constexpr float kCapCosine = 0.7f;
        density = L::select(L::is_less(size * L::all(kCapCosine), on_unit.z),
                            L::all(shape.part_density[1]), density);
        density = L::select(L::is_less(on_unit.z, size * L::all(-kCapCosine)),
                            L::all(shape.part_density[2]), density);
    }
    const V pdf = density * size * distance * distance /
                  (L::select(faces, cosine, one) * L::all(shape.volume_scale));
    return L::select(faces, pdf, L::all(0));
}

/// A face in each lane, and the number that chose it, used again.
template <class L>
struct FaceChoiceOf {
    IntOf<L> face;
    ValueOf<L> probability;  // by a tree; of a choice by area it is the face's area over `area`
    ValueOf<L> rest;
};

/// The face within whose part of the area u lies, by bisection.
template <class L>
CAROM_KERNEL FaceChoiceOf<L> choose_face_by_area(const EmissiveSurfaceConstants& surface,
                                                 ValueOf<L> u) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const auto index = first_above<L>(surface.area_cdf, L::all_int(0),
                                      L::all_int(surface.area_cdf.count() - 1), u);
    const auto previous = L::larger_int(index - L::all_int(1), L::all_int(0));
    const V before = L::select(L::is_less_int(L::all_int(0), index),
                               L::gather(surface.area_cdf.data(), previous), zero);
    const V fraction = L::gather(surface.area_cdf.data(), index) - before;
    const auto has_area = L::is_less(zero, fraction);
    const V rest = L::select(
        has_area,
        limited<L>((u - before) / L::select(has_area, fraction, L::all(1)), 0, kOneMinusEpsilon),
        L::all(0.5f));
    return {index, L::all(1), rest};
}

template <class L>
struct FaceOf {
    Vec3Of<L> a, b, c;

    /// Its length is twice the face's area.
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> normal() const { return cross(b - a, c - a); }
};

template <class L>
CAROM_KERNEL FaceOf<L> face_of(const EmissiveSurfaceConstants& surface, IntOf<L> face) {
    const auto number = L::product(face, 9);
    const auto corner = [&](int first) CAROM_KERNEL_ATTRIBUTE {
        return Vec3Of<L>{L::gather(surface.corners.data() + first, number),
                         L::gather(surface.corners.data() + first + 1, number),
                         L::gather(surface.corners.data() + first + 2, number)};
    };
    return {corner(0), corner(3), corner(6)};
}

/// A direction towards a point of flat faces, uniform by area in each, and if there are a few in
/// all. Not valid where the point faces away. `seen`: the tree, if there is one.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_surface(const EmissiveSurfaceConstants& surface,
                                             const SeenTreeOf<L>& seen, const Vec3Of<L>& point,
                                             const Vec2Of<L>& u) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const bool by_tree = surface.tree.exists();
    FaceChoiceOf<L> choice{};
    if (by_tree) {
        const TreeChoiceOf<L> found = choose_in_tree<L>(surface.tree, seen, u.x);
        const auto exists = L::is_less(zero, found.probability);
        choice = {L::select_int(exists, found.light, L::all_int(0)), found.probability, found.u};
    } else {
        choice = choose_face_by_area<L>(surface, u.x);
    }
    const FaceOf<L> face = face_of<L>(surface, choice.face);
    // Uniform over the triangle (Turk 1990, "Generating random points in triangles").
    const V root = L::root(choice.rest);
    const Vec3<V> to_light =
        face.a * (one - root) + face.b * (root * (one - u.y)) + face.c * (root * u.y) - point;
    const auto over = [](const Vec3<V>& v, V length) CAROM_KERNEL_ATTRIBUTE {
        return Vec3<V>{v.x / length, v.y / length, v.z / length};
    };
    const Vec3<V> normal = face.normal();
    const V size = L::root(dot(normal, normal));
    const V distance = L::root(dot(to_light, to_light));
    const auto is_apart = L::is_less(L::all(1e-9f), distance);
    const V divisor = L::select(is_apart, distance, one);
    const V height = dot(to_light, over(normal, L::select(L::is_less(zero, size), size, one)));
    const V cosine = L::opposite_sign(height) / divisor;
    auto valid = L::both(is_apart, L::is_less(zero, cosine));
    V area = L::all(surface.area);
    if (by_tree) {
        valid = L::both(valid, L::is_less(zero, choice.probability));
        area = L::all(0.5f) * size / L::select(valid, choice.probability, one);
    }
    return {over(to_light, divisor), divisor,
            divisor * divisor / (L::select(valid, cosine, one) * area), all_of<L>(surface.radiance),
            valid};
}

/// Density of `sample_surface` (1/sr) for a ray from `point` that hits a face at `distance` with
/// this cosine to the face's own normal.
template <class L>
CAROM_KERNEL ValueOf<L> pdf_of_surface(const EmissiveSurfaceConstants& surface,
                                       const Vec3Of<L>& point, const Vec3Of<L>& receiver,
                                       IntOf<L> face, ValueOf<L> distance, ValueOf<L> cosine) {
    const auto faces = L::is_less(L::all(0), cosine);
    auto area = L::all(surface.area);
    auto probability = L::all(1);
    if (surface.tree.exists()) {
        const Vec3Of<L> normal = face_of<L>(surface, face).normal();
        area = L::all(0.5f) * L::root(dot(normal, normal));
        probability =
            chance_in_tree<L>(surface.tree, see_tree<L>(surface.tree, point, receiver), face);
    }
    const auto pdf =
        distance * distance * probability / (L::select(faces, cosine, L::all(1)) * area);
    return L::select(faces, pdf, L::all(0));
}
