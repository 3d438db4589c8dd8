// Lights with a surface in lanes. Included as render/lanes/kernels/vectors.h is. Each kind is a
// struct of formulas, and a line in `by_kind`; the functions below that describe the formulas.

/// Sphere, sampled uniformly over the cone that it subtends at the point; nothing is sampled from
/// within.
template <class L>
struct SphereLightOf {
    using V = ValueOf<L>;
    const AreaLightConstants& light;

    [[nodiscard]] CAROM_KERNEL LightSampleOf<L> sample(const Vec3<V>& point,
                                                       const Vec2<V>& u) const {
        const Vec3<V> to_light = all_of<L>(light.centre) - point;
        const V radius = L::all(light.radius);
        const V distance2 = dot(to_light, to_light);
        const V distance = L::root(distance2);
        const V one_minus_cos = one_minus_cos_of_sphere<L>(radius, distance);
        const Vec3<V> in_cone = sample_cone<L>(u, one_minus_cos);
        const V sine2 = in_cone.x * in_cone.x + in_cone.y * in_cone.y;
        // Distance along the direction from the sphere's near side to the point closest to its
        // centre.
        const V inside = L::root(L::larger(L::all(0), radius * radius - distance2 * sine2));
        const BasisOf<L> basis = basis_around<L>(to_light * (L::all(1) / distance));
        const V pdf = L::all(1) / (L::all(kTurn) * one_minus_cos);
        return {unit<L>(basis.to_world(in_cone)),
                L::larger(L::all(0), distance * in_cone.z - inside), pdf,
                all_of<L>(light.radiance) * gain_of_area_light<L>(light, pdf),
                L::is_less(radius * radius, distance2)};
    }

    [[nodiscard]] CAROM_KERNEL V pdf(const Vec3<V>& point, const Vec3<V>& /*direction*/,
                                     V /*distance*/) const {
        const Vec3<V> to_light = all_of<L>(light.centre) - point;
        const V radius = L::all(light.radius);
        const V distance2 = dot(to_light, to_light);
        const V solid_angle =
            L::all(kTurn) * one_minus_cos_of_sphere<L>(radius, L::root(distance2));
        return L::select(L::is_less(radius * radius, distance2), L::all(1) / solid_angle,
                         L::all(0));
    }

    [[nodiscard]] CAROM_KERNEL V importance(const Vec3<V>& point, const Vec3<V>& normal) const {
        const Vec3<V> to_light = all_of<L>(light.centre) - point;
        const V distance = L::larger(L::root(dot(to_light, to_light)), L::all(1e-6f));
        const V radius = L::all(light.radius);
        const V solid_angle = light.has_falloff
                                  ? L::all(kTurn) * one_minus_cos_of_sphere<L>(radius, distance)
                                  : L::all(kPi);
        const V value = L::all(luminance(light.radiance)) * solid_angle *
                        surface_cosine<L>(dot(to_light, normal) / distance, radius / distance);
        return L::select(L::is_less(radius, distance), value, L::all(0));
    }

    // The point lies on a disk through the light's centre that is large enough that every ray from
    // the receiver that hits the light crosses it. Such a ray passes the centre within the radius,
    // at an angle to the disk's normal whose sine is at most (receiver_radius + radius) / distance,
    // so it crosses within radius / cosine.
    [[nodiscard]] CAROM_KERNEL LightPointOf<L> sample_point(const Vec3<V>& receiver,
                                                            V receiver_radius,
                                                            const Vec2<V>& u) const {
        const Vec3<V> centre = all_of<L>(light.centre);
        const Vec3<V> to_receiver = receiver - centre;
        const V distance = L::root(dot(to_receiver, to_receiver));
        const V sine = (receiver_radius + L::all(light.radius)) / distance;
        const BasisOf<L> basis = basis_around<L>(
            {to_receiver.x / distance, to_receiver.y / distance, to_receiver.z / distance});
        const V disk = L::all(light.radius) / L::root(L::all(1) - sine * sine);
        const Vec2<V> place = sample_disk<L>(u);
        return {centre + basis.x * (place.x * disk) + basis.y * (place.y * disk), basis.z,
                L::all(1) / (L::all(kPi) * disk * disk)};
    }
    [[nodiscard]] CAROM_KERNEL MaskOf<L> can_sample_point(V distance, V receiver_radius) const {
        // The bound keeps the disk from growing without limit.
        constexpr float kWidestSine = 0.9f;
        return L::is_less(receiver_radius + L::all(light.radius), L::all(kWidestSine) * distance);
    }
    [[nodiscard]] CAROM_KERNEL V distance_along(const Vec3<V>& origin, const Vec3<V>& direction,
                                                V /*to_point*/) const {
        const Vec3<V> to_light = all_of<L>(light.centre) - origin;
        const V along = dot(to_light, direction);
        const Vec3<V> beside = to_light - direction * along;
        const V inside2 = L::all(light.radius * light.radius) - dot(beside, beside);
        const auto hits = L::both(L::is_less(L::all(0), inside2), L::is_less(L::all(0), along));
        const V inside = L::root(L::larger(inside2, L::all(0)));
        return L::select(hits, L::larger(L::all(0), along - inside), L::all(-1));
    }
};

/// What `visit` returns for the formulas of the light's kind.
template <class L, class Visit>
CAROM_KERNEL auto by_kind(const AreaLightConstants& light, const Visit& visit) {
    if (light.kind == ShapeKind::sphere) {
        return visit(SphereLightOf<L>{light});
    }
    if (light.shade.depth > 0) {
        return visit(ShadeLightOf<L>{light});
    }
    return visit(FlatLightOf<L>{light});
}

/// Not valid behind a one-sided light or within a closed one.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_area_light(const AreaLightConstants& light,
                                                const Vec3Of<L>& point, const Vec2Of<L>& u) {
    return by_kind<L>(light, [&](const auto& formulas)
                                 CAROM_KERNEL_ATTRIBUTE { return formulas.sample(point, u); });
}

/// Density of the samples (1/sr) for a direction that hits the light at `distance`.
template <class L>
CAROM_KERNEL ValueOf<L> pdf_of_area_light(const AreaLightConstants& light, const Vec3Of<L>& point,
                                          const Vec3Of<L>& direction, ValueOf<L> distance) {
    return by_kind<L>(light, [&](const auto& formulas) CAROM_KERNEL_ATTRIBUTE {
        return formulas.pdf(point, direction, distance);
    });
}

/// Estimate of the unoccluded light at a surface. It is 0 only where nothing arrives.
template <class L>
CAROM_KERNEL ValueOf<L> importance_of_area_light(const AreaLightConstants& light,
                                                 const Vec3Of<L>& point, const Vec3Of<L>& normal) {
    return by_kind<L>(light, [&](const auto& formulas) CAROM_KERNEL_ATTRIBUTE {
        return formulas.importance(point, normal);
    });
}

/// Radiance from a point of the light towards `direction`, which points away from it.
template <class L>
CAROM_KERNEL Vec3Of<L> emitted_by_area_light(const AreaLightConstants& light,
                                             const Vec3Of<L>& position,
                                             const Vec3Of<L>& direction) {
    if (!light.is_one_sided) {
        return all_of<L>(light.radiance);
    }
    const auto shines = L::is_less(L::all(0), dot(direction, all_of<L>(light.normal)));
    const Vec3Of<L> radiance = light.shade.depth > 0
                                   ? radiance_in_shade<L>(light, position, direction)
                                   : radiance_of_flat_light<L>(light, direction);
    return radiance * L::select(shines, L::all(1), L::all(0));
}

/// A point of the light for rays from within `receiver_radius` of `receiver`, for which
/// `can_sample_point_of_area_light` holds.
template <class L>
CAROM_KERNEL LightPointOf<L> sample_point_of_area_light(const AreaLightConstants& light,
                                                        const Vec3Of<L>& receiver,
                                                        ValueOf<L> receiver_radius,
                                                        const Vec2Of<L>& u) {
    return by_kind<L>(light, [&](const auto& formulas) CAROM_KERNEL_ATTRIBUTE {
        return formulas.sample_point(receiver, receiver_radius, u);
    });
}

/// Whether a receiver with its centre at `distance` from the light's leaves room for the area from
/// which points are sampled.
template <class L>
CAROM_KERNEL MaskOf<L> can_sample_point_of_area_light(const AreaLightConstants& light,
                                                      ValueOf<L> distance,
                                                      ValueOf<L> receiver_radius) {
    return by_kind<L>(light, [&](const auto& formulas) CAROM_KERNEL_ATTRIBUTE {
        return formulas.can_sample_point(distance, receiver_radius);
    });
}

/// Distance to the light along a ray towards a sampled point, which is `to_point` away; negative if
/// the ray misses the light.
template <class L>
CAROM_KERNEL ValueOf<L> distance_to_area_light(const AreaLightConstants& light,
                                               const Vec3Of<L>& origin, const Vec3Of<L>& direction,
                                               ValueOf<L> to_point) {
    return by_kind<L>(light, [&](const auto& formulas) CAROM_KERNEL_ATTRIBUTE {
        return formulas.distance_along(origin, direction, to_point);
    });
}
