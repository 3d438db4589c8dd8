// Russian roulette of a wave's paths, in lanes. Included as render/lanes/kernels/vectors.h is.

/// PathDimensions::vertex_index.
template <class L>
CAROM_KERNEL WordOf<L> vertex_index_of(const PathQueue& paths, IntOf<L> path) {
    const auto branch = L::to_word(gather<L>(paths.branch, path));
    return L::template shifted_left<kVertexBits>(branch) +
           L::all_word(static_cast<std::uint32_t>(paths.vertex));
}

/// Which of the paths continue; divides their throughput by the probability.
template <class L>
CAROM_KERNEL MaskOf<L> survivors_of(const CameraSamples& samples, const PathQueue& paths,
                                    IntOf<L> path) {
    const auto sampler = sampler_of<L>(samples, gather<L>(paths.slot, path));
    const auto index = vertex_index_of<L>(paths, path);
    ValueOf<L> u[4];
    sampler.get_4d(index + index + L::all_word(1), u);
    const Vec3Of<L> throughput = gather<L>(paths.throughput, path);
    const auto survival = survival_of<L>(throughput);
    scatter<L>({throughput.x / survival, throughput.y / survival, throughput.z / survival},
               paths.throughput, path);
    return L::is_less(u[2], survival);
}
