// Sampling of all kinds of lights, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Where light is gathered.
template <class L>
struct PlaceOf {
    Vec3Of<L> position;
    ValueOf<L> time;
};

/// The body of an emissive object at each path's time.
template <class L>
CAROM_KERNEL BodyOf<L> body_of(const WaveLight& light, ValueOf<L> time) {
    return body_at<L>(light.motion, light.is_round, time);
}

template <class L>
CAROM_KERNEL ValueOf<L> importance_of(const WaveScene& scene, const WaveLight& light,
                                      const PlaceOf<L>& place, const Vec3Of<L>& normal) {
    switch (light.kind) {
        case WaveLight::Kind::area:
            return importance_of_area_light<L>(light.area, place.position, normal);
        case WaveLight::Kind::environment:
        case WaveLight::Kind::dark_environment:
            return L::all(scene.environment_importance);
        case WaveLight::Kind::delta:
            return importance_of_delta_light<L>(light.delta, place.position, normal);
        case WaveLight::Kind::curved_object: {
            const BodyOf<L> body = body_of<L>(light, place.time);
            return importance_of_shape<L>(light.shape, body.point(place.position),
                                          body.vector(normal));
        }
        case WaveLight::Kind::flat_object: {
            const BodyOf<L> body = body_of<L>(light, place.time);
            return importance_of_object<L>(light.surface.importance, body.point(place.position),
                                           body.vector(normal));
        }
    }
    return L::all(0);
}

template <class L>
CAROM_KERNEL LightSampleOf<L> sample_sky(const EnvironmentPicture& sky, const Vec2Of<L>& u) {
    const EnvironmentSampleOf<L> found = sample_environment_map<L>(sky, u);
    return {found.direction, L::all(kInfinity), found.pdf, environment_radiance<L>(sky, found.uv),
            found.valid};
}

/// Not inlined: the shapes' code is long.
template <class L>
CAROM_KERNEL_OUTLINED LightSampleOf<L> sample_object(const WaveLight& light,
                                                     const PlaceOf<L>& place, const Vec2Of<L>& u) {
    const BodyOf<L> body = body_of<L>(light, place.time);
    const Vec3Of<L> point = body.point(place.position);
    LightSampleOf<L> found = light.kind == WaveLight::Kind::flat_object
                                 ? sample_surface<L>(light.surface, point, u)
                                 : sample_shape<L>(light.shape, point, u);
    found.direction = body.to_world(found.direction);
    return found;
}

template <class L>
CAROM_KERNEL LightSampleOf<L> sample_light(const WaveScene& scene, const WaveLight& light,
                                           const PlaceOf<L>& place, const Vec2Of<L>& u) {
    switch (light.kind) {
        case WaveLight::Kind::area:
            return sample_area_light<L>(light.area, place.position, u);
        case WaveLight::Kind::environment:
            return sample_sky<L>(scene.sky, u);
        case WaveLight::Kind::delta:
            return sample_delta_light<L>(light.delta, place.position);
        case WaveLight::Kind::curved_object:
        case WaveLight::Kind::flat_object:
            return sample_object<L>(light, place, u);
        case WaveLight::Kind::dark_environment:
            break;
    }
    const auto zero = L::all(0);
    const auto one = L::all(1);
    return {{zero, zero, zero}, one, one, {zero, zero, zero}, L::first_lanes(0)};
}

/// The choice of one light in every lane, in proportion to importance: reservoir sampling in one
/// pass, in which each light replaces the choice with the probability of its weight over the sum of
/// all weights up to it (PBR, section A.2).
template <class L>
struct LightChoiceOf {
    IntOf<L> light;
    ValueOf<L> probability;
    ValueOf<L> total;  // 0: none
    ValueOf<L> u;
};

template <class L>
CAROM_KERNEL LightChoiceOf<L> choose_light(const WaveScene& scene, const PlaceOf<L>& place,
                                           const Vec3Of<L>& normal, ValueOf<L> u) {
    const auto zero = L::all(0);
    LightChoiceOf<L> choice{L::all_int(-1), zero, zero, u};
    auto chosen = zero;
    for (int light = 0; light < scene.lights.count(); ++light) {
        const auto weight = importance_of<L>(scene, scene.lights[light], place, normal);
        const auto counts = L::is_less(zero, weight);
        choice.total = L::select(counts, choice.total + weight, choice.total);
        const auto probability = weight / choice.total;
        const auto takes = L::both(counts, L::is_less(choice.u, probability));
        choice.light = L::select_int(takes, L::all_int(light), choice.light);
        chosen = L::select(takes, weight, chosen);
        choice.u = L::select(L::both(counts, L::is_less(probability, L::all(1))),
                             remap_sample<L>(choice.u, probability), choice.u);
    }
    choice.probability = chosen / choice.total;
    choice.total = L::select(L::is_less(zero, chosen), choice.total, zero);
    return choice;
}
