// What paths bring that left the scene, in lanes. Included as render/lanes/kernels/vectors.h is.

/// The weight of the environment's light for paths that left the scene (light_hits.h).
template <class L>
CAROM_KERNEL ValueOf<L> weight_of_environment(const WaveScene& scene, const PathQueue& paths,
                                              IntOf<L> path, ValueOf<L> pdf) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const auto is_delta = L::is_equal_int(gather<L>(paths.is_delta, path), L::all_int(1));
    auto expected = gather<L>(paths.environment_samples, path);
    if (paths.vertex != 1) {
        const auto total = gather<L>(paths.total_importance, path);
        const auto exists = L::is_less(zero, total);
        expected = L::select(
            exists, L::all(scene.environment_importance) / L::select(exists, total, one), zero);
    }
    const auto last = L::select(is_delta, one, gather<L>(paths.pdf, path));
    const auto by_light = expected * pdf;
    auto weight = one;
    if (scene.strategy == DirectStrategy::both) {
        weight = power_heuristic<L>(last, by_light);
    } else if (scene.strategy == DirectStrategy::lights_only) {
        weight = L::select(L::is_less(zero, by_light), zero, one);
    }
    return L::select(is_delta, one, weight);
}

/// Writes the light of the paths from the `first` of the list on.
template <class L>
CAROM_KERNEL void shade_background(const WaveScene& scene, const PathQueue& paths,
                                   const EscapedQueue& missed, int first) {
    const auto path = load<L>(missed.paths.at, first);
    const Vec3Of<L> direction = gather<L>(paths.direction, path);
    const Vec2Of<L> uv = environment_uv<L>(scene.sky, direction);
    const auto pdf = environment_pdf<L>(scene.sky, direction, uv);
    const Vec3Of<L> radiance =
        environment_radiance<L>(scene.sky, uv) * weight_of_environment<L>(scene, paths, path, pdf);
    store<L>(gather<L>(paths.throughput, path) * radiance, missed.light, first);
}
