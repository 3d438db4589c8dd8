// Light that paths find by scattered rays, which was perhaps sampled at the vertex before, weighted
// against that sampling; in lanes. Included as render/lanes/kernels/vectors.h is.

/// The weight of multiple importance sampling. `expected`: the expected number of directions that
/// the vertex before sampled towards the light, each with the density `pdf`.
template <class L>
CAROM_KERNEL ValueOf<L> weight_of_found(const WaveScene& scene, const PathQueue& paths,
                                        IntOf<L> path, ValueOf<L> expected, ValueOf<L> pdf) {
    const auto one = L::all(1);
    const auto is_delta = is_set<L>(gather<L>(paths.is_delta, path));
    const auto last = L::select(is_delta, one, gather<L>(paths.pdf, path));
    const auto by_light = expected * pdf;
    auto weight = one;
    if (scene.strategy == DirectStrategy::both) {
        weight = power_heuristic<L>(last, by_light);
    } else if (scene.strategy == DirectStrategy::lights_only) {
        weight = L::select(L::is_less(L::all(0), by_light), L::all(0), one);
    }
    return L::select(is_delta, one, weight);
}

/// The expected number of directions towards a light that is chosen with this importance, if one
/// light was chosen.
template <class L>
CAROM_KERNEL ValueOf<L> expected_samples(const PathQueue& paths, IntOf<L> path,
                                         ValueOf<L> importance) {
    const auto total = gather<L>(paths.total_importance, path);
    const auto exists = L::is_less(L::all(0), total);
    return L::select(exists, importance / L::select(exists, total, L::all(1)), L::all(0));
}

/// The weight of light from a lamp or an emissive object that the paths hit.
template <class L>
CAROM_KERNEL ValueOf<L> weight_of_light(const WaveScene& scene, const WaveLight& light,
                                        const PathQueue& paths, IntOf<L> path, ValueOf<L> pdf) {
    auto expected = L::all(static_cast<float>(light.samples));
    if (paths.vertex != 1) {
        const PlaceOf<L> last{gather<L>(paths.last_position, path), gather<L>(paths.time, path)};
        const auto importance =
            importance_of<L>(scene, light, last, gather<L>(paths.last_normal, path));
        expected = expected_samples<L>(paths, path, importance);
    }
    return weight_of_found<L>(scene, paths, path, expected, pdf);
}

/// Radiance of an area light that paths hit at a distance.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_of_area_light(const WaveScene& scene, const WaveLight& light,
                                              const PathQueue& paths, IntOf<L> path,
                                              ValueOf<L> distance) {
    const Vec3Of<L> direction = gather<L>(paths.direction, path);
    const auto pdf =
        pdf_of_area_light<L>(light.area, gather<L>(paths.last_position, path), direction, distance);
    const auto is_delta = is_set<L>(gather<L>(paths.is_delta, path));
    const auto gain = L::select(is_delta, L::all(1), gain_of_area_light<L>(light.area, pdf));
    const Vec3Of<L> emitted = emitted_by_area_light<L>(light.area, opposite<L>(direction));
    const Vec3Of<L> radiance =
        emitted * (gain * weight_of_light<L>(scene, light, paths, path, pdf));
    return select<L>(L::is_less(L::all(0), largest<L>(emitted)), radiance, emitted);
}

/// Weight of the light of an emissive object that paths hit at a distance, where its front has this
/// unit normal.
template <class L>
CAROM_KERNEL ValueOf<L> weight_of_object(const WaveScene& scene, const WaveLight& light,
                                         const PathQueue& paths, IntOf<L> path, ValueOf<L> distance,
                                         const Vec3Of<L>& normal) {
    const Vec3Of<L> direction = gather<L>(paths.direction, path);
    const BodyOf<L> body = body_of<L>(light, gather<L>(paths.time, path));
    const auto pdf =
        light.kind == WaveLight::Kind::flat_object
            ? pdf_of_surface<L>(light.surface, distance, L::opposite_sign(dot(direction, normal)))
            : pdf_of_shape<L>(light.shape, body.point(gather<L>(paths.last_position, path)),
                              body.vector(direction), distance, body.vector(normal));
    return weight_of_light<L>(scene, light, paths, path, pdf);
}
