// One-sided flat lights in lanes, and what all lights with a surface share. Included as
// render/lanes/kernels/vectors.h is.

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

/// Radiance of a one-sided flat light along the unit `direction`, on the side that shines.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_of_flat_light(const AreaLightConstants& light,
                                              const Vec3Of<L>& direction) {
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
                radiance_of_flat_light<L>(light, opposite<L>(direction)) *
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
