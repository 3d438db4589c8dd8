// Lights with a surface in lanes. Included as render/lanes/kernels/vectors.h is. Each kind is a
// struct of formulas, and a line in `by_kind`; the functions below that describe the formulas.

/// The factor by which the light on a surface is brighter than the light looks, for a direction
/// with the density `pdf`. It differs from 1 only for a light without falloff, which gives every
/// point the irradiance pi x radiance x the mean cosine towards the light.
template <class L>
CAROM_KERNEL ValueOf<L> gain_of_area_light(const AreaLightConstants& light, ValueOf<L> pdf) {
    return light.has_falloff ? L::all(1) : L::all(kPi) * pdf;
}

/// Cosine towards a light's centre for an importance estimate; 0 if the whole light lies below the
/// horizon. `sine`: the light's radius over the distance.
template <class L>
CAROM_KERNEL ValueOf<L> surface_cosine(ValueOf<L> cosine, ValueOf<L> sine) {
    return L::select(L::is_at_most(cosine + sine, L::all(0)), L::all(0),
                     L::larger(cosine, L::all(kLeastHorizonCosine)));
}

/// A point on a light, sampled by area, for connections that are reflected on the way.
template <class L>
struct LightPointOf {
    Vec3Of<L> position;
    Vec3Of<L> normal;  // unit, of the area that the point was chosen on, on the side
                       // of the receiver
    ValueOf<L> pdf;    // 1/m^2, > 0
};

/// The radiance of the wall of a shade at a height from the opening.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_of_wall(const ShadeConstants& shade, ValueOf<L> height) {
    const auto place = limited<L>(height * L::all((ShadeConstants::kNodes - 1) / shade.depth), 0,
                                  ShadeConstants::kNodes - 1);
    Vec3Of<L> radiance{L::all(0), L::all(0), L::all(0)};
    for (int i = 0; i < ShadeConstants::kNodes; ++i) {
        const auto weight =
            L::larger(L::all(0), L::all(1) - L::size(place - L::all(static_cast<float>(i))));
        radiance = radiance + all_of<L>(shade.wall[i]) * weight;
    }
    return radiance;
}

/// What a ray sees that passes the opening of a shade at `position` and came along the unit
/// `direction`, which points out of it: the height z at which the ray, followed backwards, leaves
/// the body is the positive root of a z^2 + b z + c with c <= 0.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_in_shade(const AreaLightConstants& light, const Vec3Of<L>& position,
                                         const Vec3Of<L>& direction) {
    using V = ValueOf<L>;
    const ShadeConstants& shade = light.shade;
    const Vec3<V> normal = all_of<L>(light.normal);
    const V cosine = L::larger(dot(direction, normal), L::all(1e-4f));
    const Vec3<V> slope = normal - direction * (L::all(1) / cosine);  // sideways for each z
    const Vec3<V> from = position - all_of<L>(light.centre);
    const Vec3<V> on_ceiling = from + slope * L::all(shade.depth);
    const Vec3<V> squares = all_of<L>(shade.squares);
    const V a = dot(slope, slope) - squares.z;
    const V b = L::all(2) * dot(from, slope) - squares.y;
    const V c = L::smaller(L::all(0), dot(from, from) - squares.x);
    const V root = L::root(L::larger(L::all(0), b * b - L::all(4) * a * c));
    const V height = L::all(-2) * c / L::larger(b + root, L::all(1e-12f));
    // The squared distance from the axis on the ceiling, of its disk and of its edge.
    const V beside = dot(on_ceiling, on_ceiling);
    const float edge2 =
        shade.squares.x + shade.depth * (shade.squares.y + shade.depth * shade.squares.z);
    const Vec3<V> above = select<L>(L::is_at_most(beside, L::all(shade.disk2)),
                                    all_of<L>(shade.disk), all_of<L>(shade.ceiling));
    return select<L>(L::is_at_most(beside, L::all(edge2)), above,
                     radiance_of_wall<L>(shade, height));
}

/// Radiance of a one-sided flat light from a point of it along the unit `direction`, on the side
/// that shines.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_of_flat_light(const AreaLightConstants& light,
                                              const Vec3Of<L>& position,
                                              const Vec3Of<L>& direction) {
    if (light.shade.depth > 0) {
        return radiance_in_shade<L>(light, position, direction);
    }
    const Vec3Of<L> radiance = all_of<L>(light.radiance);
    if (!(light.beam > 0)) {
        return radiance;
    }
    const auto cosine = L::larger(dot(direction, all_of<L>(light.normal)), L::all(0));
    return radiance * (L::all(0.5f * light.beam + 1) * power_of<L>(cosine, L::all(light.beam)));
}

/// One-sided rectangle or disk, sampled uniformly by area. (Uniform sampling of its solid angle
/// costs more than it gains for lamps a metre above a table.)
template <class L>
struct FlatLightOf {
    using V = ValueOf<L>;
    const AreaLightConstants& light;

    [[nodiscard]] CAROM_KERNEL Vec3<V> point_at(const Vec2<V>& u) const {
        if (light.kind == ShapeKind::disk) {
            const Vec2<V> place = sample_disk<L>(u);
            return all_of<L>(light.centre) + all_of<L>(light.edge_u) * place.x +
                   all_of<L>(light.edge_v) * place.y;
        }
        const V a = L::all(2) * u.x - L::all(1);
        const V b = L::all(2) * u.y - L::all(1);
        return all_of<L>(light.centre) + all_of<L>(light.edge_u) * a + all_of<L>(light.edge_v) * b;
    }

    [[nodiscard]] CAROM_KERNEL LightSampleOf<L> sample(const Vec3<V>& point,
                                                       const Vec2<V>& u) const {
        const Vec3<V> on_light = point_at(u);
        const Vec3<V> to_light = on_light - point;
        const V height = L::opposite_sign(dot(to_light, all_of<L>(light.normal)));
        const auto valid = L::is_less(L::all(0), height);
        const V distance2 = dot(to_light, to_light);
        const V distance = L::root(distance2);
        const V pdf =
            distance2 * distance / (L::select(valid, height, L::all(1)) * L::all(light.area));
        const Vec3<V> direction = to_light * (L::all(1) / distance);
        return {direction, distance, pdf,
                radiance_of_flat_light<L>(light, on_light, opposite<L>(direction)) *
                    gain_of_area_light<L>(light, pdf),
                valid};
    }

    [[nodiscard]] CAROM_KERNEL V pdf(const Vec3<V>& /*point*/, const Vec3<V>& direction,
                                     V distance) const {
        const V cosine = L::opposite_sign(dot(direction, all_of<L>(light.normal)));
        const auto faces = L::is_less(L::all(0), cosine);
        const V pdf =
            distance * distance / (L::select(faces, cosine, L::all(1)) * L::all(light.area));
        return L::select(faces, pdf, L::all(0));
    }

    [[nodiscard]] CAROM_KERNEL V importance(const Vec3<V>& point, const Vec3<V>& normal) const {
        const Vec3<V> to_light = all_of<L>(light.centre) - point;
        const V distance2 = L::larger(dot(to_light, to_light), L::all(1e-12f));
        const V distance = L::root(distance2);
        const V height = L::opposite_sign(dot(to_light, all_of<L>(light.normal)));
        const V cosine =
            surface_cosine<L>(dot(to_light, normal) / distance, L::all(light.radius) / distance);
        const auto shines = L::is_less(L::all(0), height);
        const float brightness = luminance(light.radiance);
        if (!light.has_falloff) {
            return L::select(shines, L::all(brightness * kPi) * cosine, L::all(0));
        }
        // Within the light's own size the solid angle no longer grows.
        const V value = L::all(brightness * light.area) * cosine * (height / distance) /
                        L::larger(distance2, L::all(0.25f * light.area));
        return L::select(shines, value, L::all(0));
    }

    [[nodiscard]] CAROM_KERNEL LightPointOf<L> sample_point(const Vec3<V>& /*receiver*/,
                                                            V /*receiver_radius*/,
                                                            const Vec2<V>& u) const {
        return {point_at(u), all_of<L>(light.normal), L::all(1 / light.area)};
    }
    [[nodiscard]] CAROM_KERNEL MaskOf<L> can_sample_point(V distance, V /*receiver_radius*/) const {
        return L::is_less(L::all(0), distance);
    }
    [[nodiscard]] CAROM_KERNEL V distance_along(const Vec3<V>& /*origin*/,
                                                const Vec3<V>& /*direction*/, V to_point) const {
        return to_point;
    }
};

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
    return radiance_of_flat_light<L>(light, position, direction) *
           L::select(shines, L::all(1), L::all(0));
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
