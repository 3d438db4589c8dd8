// What paths bring that left the scene, in lanes. Included as render/lanes/kernels/vectors.h is.

template <class L>
CAROM_KERNEL ValueOf<L> weight_of_environment(const WaveScene& scene, const PathQueue& paths,
                                              IntOf<L> path, ValueOf<L> pdf) {
    auto expected = gather<L>(paths.environment_samples, path);
    if (paths.vertex != 1) {
        expected = expected_samples<L>(paths, path, L::all(scene.environment_importance));
    }
    return weight_of_found<L>(scene, paths, path, expected, pdf);
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
