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

/// Radiance that paths bring from a light with a surface that they hit, weighted.
template <class L>
CAROM_KERNEL Vec3Of<L> radiance_of_light(const WaveScene& scene, const WaveLight& light,
                                         const PathQueue& paths, IntOf<L> path,
                                         const LightHitOf<L>& hit) {
    const Vec3Of<L> emitted = emitted_by<L>(light, hit);
    const PlaceOf<L> last{gather<L>(paths.last_position, path), gather<L>(paths.last_normal, path),
                          gather<L>(paths.time, path)};
    auto pdf = density_of<L>(scene, light, last, hit);
    auto factor = L::all(1);
    if (light.kind == WaveLight::Kind::area) {
        const auto is_delta = is_set<L>(gather<L>(paths.is_delta, path));
        factor = L::select(is_delta, factor, gain_of_area_light<L>(light.area, pdf));
    }
    if (scene.lights.exists()) {
        const WaveLight& entry = light.is_in_tree ? scene.lights[scene.lights.count() - 1] : light;
        auto expected = L::all(static_cast<float>(entry.samples));
        if (paths.vertex != 1) {
            expected = expected_samples<L>(paths, path, importance_of<L>(scene, entry, last));
        }
        if (light.is_in_tree) {
            pdf = pdf * chance_in_tree<L>(scene.light_tree,
                                          see_tree<L>(scene.light_tree, last.position, last.normal),
                                          L::all_int(light.number));
        }
        factor = factor * weight_of_found<L>(scene, paths, path, expected, pdf);
    }
    return select<L>(L::is_less(L::all(0), largest<L>(emitted)), emitted * factor, emitted);
}
