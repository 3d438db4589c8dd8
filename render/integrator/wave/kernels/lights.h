// Sampling of all kinds of lights, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Where light is gathered.
template <class L>
struct PlaceOf {
    Vec3Of<L> position, normal;
    ValueOf<L> time;
};

/// The body of an emissive object at each path's time.
template <class L>
CAROM_KERNEL BodyOf<L> body_of(const WaveLight& light, ValueOf<L> time) {
    return body_at<L>(light.motion, light.is_round, time);
}

template <class L>
CAROM_KERNEL ValueOf<L> importance_of(const WaveScene& scene, const WaveLight& light,
                                      const PlaceOf<L>& place) {
    switch (light.kind) {
        case WaveLight::Kind::area:
            return importance_of_area_light<L>(light.area, place.position, place.normal);
        case WaveLight::Kind::environment:
        case WaveLight::Kind::dark_environment:
            return L::all(scene.environment_importance);
        case WaveLight::Kind::delta:
            return importance_of_delta_light<L>(light.delta, place.position, place.normal);
        case WaveLight::Kind::curved_object: {
            const BodyOf<L> body = body_of<L>(light, place.time);
            return importance_of_shape<L>(light.shape, body.point(place.position),
                                          body.vector(place.normal));
        }
        case WaveLight::Kind::flat_object: {
            const BodyOf<L> body = body_of<L>(light, place.time);
            return importance_of_surface<L>(light.surface, body.point(place.position),
                                            body.vector(place.normal));
        }
        case WaveLight::Kind::many:
            return see_tree<L>(scene.light_tree, place.position, place.normal).total;
    }
    return L::all(0);
}

template <class L>
CAROM_KERNEL LightSampleOf<L> sample_sky(const WaveScene& scene, const Vec2Of<L>& u) {
    const EnvironmentSampleOf<L> found = sample_environment_map<L>(scene.sky, u);
    return {found.direction, L::all(scene.sky_distance), found.pdf,
            environment_radiance<L>(scene.sky, found.uv), found.valid};
}

/// The tree of a light, or of all that are in the scene's, seen from places; empty if there is
/// none.
template <class L>
CAROM_KERNEL SeenTreeOf<L> see_light(const WaveScene& scene, const WaveLight& light,
                                     const PlaceOf<L>& place) {
    if (light.kind == WaveLight::Kind::many) {
        return see_tree<L>(scene.light_tree, place.position, place.normal);
    }
    if (light.kind == WaveLight::Kind::flat_object) {
        const BodyOf<L> body = body_of<L>(light, place.time);
        return see_tree<L>(light.surface.tree, body.point(place.position),
                           body.vector(place.normal));
    }
    return see_tree<L>({}, place.position, place.normal);
}

/// Not inlined: the shapes' code is long.
template <class L>
CAROM_KERNEL_OUTLINED LightSampleOf<L> sample_object(const WaveLight& light,
                                                     const SeenTreeOf<L>& seen,
                                                     const PlaceOf<L>& place, const Vec2Of<L>& u) {
    const BodyOf<L> body = body_of<L>(light, place.time);
    const Vec3Of<L> point = body.point(place.position);
    LightSampleOf<L> found = light.kind == WaveLight::Kind::flat_object
                                 ? sample_surface<L>(light.surface, seen, point, u)
                                 : sample_shape<L>(light.shape, point, u);
    found.direction = body.to_world(found.direction);
    return found;
}

/// Of a light of its own. `seen`: by see_light.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_light(const WaveScene& scene, const WaveLight& light,
                                           const SeenTreeOf<L>& seen, const PlaceOf<L>& place,
                                           const Vec2Of<L>& u) {
    switch (light.kind) {
        case WaveLight::Kind::area:
            return sample_area_light<L>(light.area, place.position, u);
        case WaveLight::Kind::environment:
            return sample_sky<L>(scene, u);
        case WaveLight::Kind::delta:
            return sample_delta_light<L>(light.delta, place.position);
        case WaveLight::Kind::curved_object:
        case WaveLight::Kind::flat_object:
            return sample_object<L>(light, seen, place, u);
        case WaveLight::Kind::dark_environment:
        case WaveLight::Kind::many:
            break;
    }
    const auto zero = L::all(0);
    return {place.normal, zero, L::all(1), {zero, zero, zero}, L::first_lanes(0)};
}

/// Where rays from places hit a light. Of an object: the unit normal of its front there, and the
/// face that hits of meshes name.
template <class L>
struct LightHitOf {
    Vec3Of<L> position, direction;
    ValueOf<L> distance;
    Vec3Of<L> normal;
    IntOf<L> face;
};

/// Density (1/sr) of the samples of a light of its own, for a direction that hits it.
template <class L>
CAROM_KERNEL ValueOf<L> density_of(const WaveScene& scene, const WaveLight& light,
                                   const PlaceOf<L>& place, const LightHitOf<L>& hit) {
    switch (light.kind) {
        case WaveLight::Kind::area:
            return pdf_of_area_light<L>(light.area, place.position, hit.direction, hit.distance);
        case WaveLight::Kind::environment:
            return environment_pdf<L>(scene.sky, hit.direction,
                                      environment_uv<L>(scene.sky, hit.direction));
        case WaveLight::Kind::curved_object: {
            const BodyOf<L> body = body_of<L>(light, place.time);
            return pdf_of_shape<L>(light.shape, body.point(place.position),
                                   body.vector(hit.direction), hit.distance,
                                   body.vector(hit.normal));
        }
        case WaveLight::Kind::flat_object: {
            const BodyOf<L> body = body_of<L>(light, place.time);
            return pdf_of_surface<L>(light.surface, body.point(place.position),
                                     body.vector(place.normal), hit.face, hit.distance,
                                     L::opposite_sign(dot(hit.direction, hit.normal)));
        }
        case WaveLight::Kind::delta:  // is not hit
        case WaveLight::Kind::dark_environment:
        case WaveLight::Kind::many:
            break;
    }
    return L::all(0);
}

/// Radiance of a light with a surface, from its front, against a direction that hits it.
template <class L>
CAROM_KERNEL Vec3Of<L> emitted_by(const WaveLight& light, const LightHitOf<L>& hit) {
    if (light.kind == WaveLight::Kind::area) {
        return emitted_by_area_light<L>(light.area, hit.position, opposite<L>(hit.direction));
    }
    return all_of<L>(light.kind == WaveLight::Kind::flat_object ? light.surface.radiance
                                                                : light.shape.radiance);
}

/// Of a light in each of some lanes, by its number.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_numbered(const WaveScene& scene, IntOf<L> number,
                                              MaskOf<L> exists, const PlaceOf<L>& place,
                                              const Vec2Of<L>& u) {
    const auto zero = L::all(0);
    LightSampleOf<L> found{place.normal, zero, L::all(1), {zero, zero, zero}, L::first_lanes(0)};
    while (!L::none(exists)) {
        const std::int32_t index = L::smallest_of(exists, number);
        const WaveLight& light = scene.all_lights[index];
        const auto takes = L::both(exists, L::is_equal_int(number, L::all_int(index)));
        found = select_sample<L>(
            takes, sample_light<L>(scene, light, see_light<L>(scene, light, place), place, u),
            found);
        exists = L::without(exists, takes);
    }
    return found;
}

/// Of one of the lights in the tree. Its density has the probability of the choice in it. Not
/// inlined: rare.
template <class L>
CAROM_KERNEL_OUTLINED LightSampleOf<L> sample_many(const WaveScene& scene,
                                                   const SeenTreeOf<L>& seen,
                                                   const PlaceOf<L>& place, const Vec2Of<L>& u) {
    const TreeChoiceOf<L> choice = choose_in_tree<L>(scene.light_tree, seen, u.x);
    const auto exists = L::is_less(L::all(0), choice.probability);
    LightSampleOf<L> found =
        sample_numbered<L>(scene, choice.light, exists, place, {choice.u, u.y});
    found.pdf = found.pdf * L::select(exists, choice.probability, L::all(1));
    return found;
}

/// Of an entry of the scene's list.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_entry(const WaveScene& scene, const WaveLight& light,
                                           const SeenTreeOf<L>& seen, const PlaceOf<L>& place,
                                           const Vec2Of<L>& u) {
    return light.kind == WaveLight::Kind::many ? sample_many<L>(scene, seen, place, u)
                                               : sample_light<L>(scene, light, seen, place, u);
}

/// The choice of one entry of the scene's list in every lane, in proportion to importance:
/// reservoir sampling in one pass, in which each light replaces the choice with the probability of
/// its weight over the sum of all weights up to it (PBR, section A.2).
template <class L>
struct LightChoiceOf {
    IntOf<L> light;  // its number; -1: one in the tree
    ValueOf<L> probability;
    ValueOf<L> total;  // 0: none
    ValueOf<L> u;
};

template <class L>
CAROM_KERNEL LightChoiceOf<L> choose_light(const WaveScene& scene, const PlaceOf<L>& place,
                                           ValueOf<L> u) {
    const auto zero = L::all(0);
    LightChoiceOf<L> choice{L::all_int(-1), zero, zero, u};
    auto chosen = zero;
    for (const WaveLight& light : scene.lights) {
        const auto weight = importance_of<L>(scene, light, place);
        const auto counts = L::is_less(zero, weight);
        choice.total = L::select(counts, choice.total + weight, choice.total);
        const auto probability = weight / choice.total;
        const auto takes = L::both(counts, L::is_less(choice.u, probability));
        choice.light = L::select_int(takes, L::all_int(light.number), choice.light);
        chosen = L::select(takes, weight, chosen);
        choice.u = L::select(L::both(counts, L::is_less(probability, L::all(1))),
                             remap_sample<L>(choice.u, probability), choice.u);
    }
    choice.probability = chosen / choice.total;
    choice.total = L::select(L::is_less(zero, chosen), choice.total, zero);
    return choice;
}

/// Of the chosen lights, in the lanes where there is a choice. The density is that of the light, or
/// of those in the tree.
template <class L>
CAROM_KERNEL LightSampleOf<L> sample_choice(const WaveScene& scene, const LightChoiceOf<L>& choice,
                                            MaskOf<L> wanted, const PlaceOf<L>& place,
                                            ValueOf<L> y) {
    const Vec2Of<L> u{choice.u, y};
    const auto is_own = L::is_less_int(L::all_int(-1), choice.light);
    const LightSampleOf<L> found =
        sample_numbered<L>(scene, choice.light, L::both(wanted, is_own), place, u);
    const auto is_many = L::both(L::without(wanted, is_own), L::is_less(L::all(0), choice.total));
    if (!scene.light_tree.exists() || L::none(is_many)) {
        return found;
    }
    const SeenTreeOf<L> seen = see_tree<L>(scene.light_tree, place.position, place.normal);
    return select_sample<L>(is_many, sample_many<L>(scene, seen, place, u), found);
}
