// Lights with a surface (area_light.h) in lanes. Included as render/lanes/kernels/vectors.h is.

/// Radiance on a surface for a direction with this density of `sample`: RectangleEmitter::gain.
template <class L, class Light>
CAROM_KERNEL Vec3<typename L::Value> radiance_of(const Light& light, typename L::Value pdf) {
    const Vec3<typename L::Value> radiance = all_of<L>(light.radiance);
    if (light.has_falloff) {
        return radiance;
    }
    return radiance * (L::all(kPi) * pdf);
}

/// Cosine towards a light's centre for an importance estimate; 0 if the whole light lies below the
/// horizon. `sine`: the light's radius over the distance.
template <class L>
CAROM_KERNEL typename L::Value surface_cosine(typename L::Value cosine, typename L::Value sine) {
    return L::select(L::is_at_most(cosine + sine, L::all(0)), L::all(0),
                     L::larger(cosine, L::all(kLeastHorizonCosine)));
}

/// Not valid behind the light.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_rectangle(const RectangleConstants& light,
                                               const Vec3<typename L::Value>& point,
                                               const Vec2<typename L::Value>& u) {
    const auto a = L::all(2) * u.x - L::all(1);
    const auto b = L::all(2) * u.y - L::all(1);
    const Vec3<typename L::Value> to_light =
        all_of<L>(light.centre) + all_of<L>(light.edge_u) * a + all_of<L>(light.edge_v) * b - point;
    const auto height = L::opposite_sign(dot(to_light, all_of<L>(light.normal)));
    const auto valid = L::is_less(L::all(0), height);
    const auto distance2 = dot(to_light, to_light);
    const auto distance = L::root(distance2);
    const auto pdf =
        distance2 * distance / (L::select(valid, height, L::all(1)) * L::all(light.area));
    return {to_light * (L::all(1) / distance), distance, pdf, radiance_of<L>(light, pdf), valid};
}

template <class L>
CAROM_KERNEL typename L::Value importance_of_rectangle(const RectangleConstants& light,
                                                       const Vec3<typename L::Value>& point,
                                                       const Vec3<typename L::Value>& normal) {
    const Vec3<typename L::Value> to_light = all_of<L>(light.centre) - point;
    const auto distance2 = L::larger(dot(to_light, to_light), L::all(1e-12f));
    const auto distance = L::root(distance2);
    const auto height = L::opposite_sign(dot(to_light, all_of<L>(light.normal)));
    const auto cosine =
        surface_cosine<L>(dot(to_light, normal) / distance, L::all(light.half_diagonal) / distance);
    const auto shines = L::is_less(L::all(0), height);
    const float brightness = luminance(light.radiance);
    if (!light.has_falloff) {
        return L::select(shines, L::all(brightness * kPi) * cosine, L::all(0));
    }
    // Within the light's own size the solid angle no longer grows.
    const auto value = L::all(brightness * light.area) * cosine * (height / distance) /
                       L::larger(distance2, L::all(0.25f * light.area));
    return L::select(shines, value, L::all(0));
}

/// Not valid within the sphere.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_sphere_light(const SphereConstants& light,
                                                  const Vec3<typename L::Value>& point,
                                                  const Vec2<typename L::Value>& u) {
    const Vec3<typename L::Value> to_light = all_of<L>(light.centre) - point;
    const auto radius = L::all(light.radius);
    const auto distance2 = dot(to_light, to_light);
    const auto distance = L::root(distance2);
    const auto one_minus_cos = one_minus_cos_of_sphere<L>(radius, distance);
    const Vec3<typename L::Value> in_cone = sample_cone<L>(u, one_minus_cos);
    const auto sine2 = in_cone.x * in_cone.x + in_cone.y * in_cone.y;
    // Distance along the direction from the sphere's near side to the point closest to its centre.
    const auto inside = L::root(L::larger(L::all(0), radius * radius - distance2 * sine2));
    const BasisOf<L> basis = basis_around<L>(to_light * (L::all(1) / distance));
    const auto pdf = L::all(1) / (L::all(kTurn) * one_minus_cos);
    return {unit<L>(basis.to_world(in_cone)), L::larger(L::all(0), distance * in_cone.z - inside),
            pdf, radiance_of<L>(light, pdf), L::is_less(radius * radius, distance2)};
}

template <class L>
CAROM_KERNEL typename L::Value importance_of_sphere(const SphereConstants& light,
                                                    const Vec3<typename L::Value>& point,
                                                    const Vec3<typename L::Value>& normal) {
    const Vec3<typename L::Value> to_light = all_of<L>(light.centre) - point;
    const auto distance = L::larger(L::root(dot(to_light, to_light)), L::all(1e-6f));
    const auto radius = L::all(light.radius);
    const auto solid_angle = light.has_falloff
                                 ? L::all(kTurn) * one_minus_cos_of_sphere<L>(radius, distance)
                                 : L::all(kPi);
    const auto value = L::all(luminance(light.radiance)) * solid_angle *
                       surface_cosine<L>(dot(to_light, normal) / distance, radius / distance);
    return L::select(L::is_less(radius, distance), value, L::all(0));
}

template <class L>
CAROM_KERNEL LightSampleOf<L> sample_area_light(const AreaLightConstants& light,
                                                const Vec3<typename L::Value>& point,
                                                const Vec2<typename L::Value>& u) {
    switch (light.kind) {
        case AreaLightConstants::Kind::rectangle:
            return sample_rectangle<L>(light.rectangle, point, u);
        case AreaLightConstants::Kind::sphere:
            break;
    }
    return sample_sphere_light<L>(light.sphere, point, u);
}

template <class L>
CAROM_KERNEL typename L::Value importance_of_area_light(const AreaLightConstants& light,
                                                        const Vec3<typename L::Value>& point,
                                                        const Vec3<typename L::Value>& normal) {
    switch (light.kind) {
        case AreaLightConstants::Kind::rectangle:
            return importance_of_rectangle<L>(light.rectangle, point, normal);
        case AreaLightConstants::Kind::sphere:
            break;
    }
    return importance_of_sphere<L>(light.sphere, point, normal);
}
