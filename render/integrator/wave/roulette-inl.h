// Russian roulette of a wave's paths. Included once per instruction set.
#include "render/integrator/kernels-inl.h"
#include "render/integrator/path_state.h"
#include "render/integrator/wave/wave_lanes-inl.h"
#include "render/sampling/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// PathDimensions::vertex_index.
HWY_INLINE U vertex_index_of(const PathQueue& paths, I path) {
    static_assert(PathDimensions::kVertices == 1u << 7);
    const I index = hn::ShiftLeft<7>(gather(paths.branch, path)) + hn::Set(IntTag(), paths.vertex);
    return hn::BitCast(WordTag(), index);
}

inline HWY_ATTR void russian_roulette(const CameraSamples& samples, PathQueue& paths,
                                      IndexList& reached) {
    const FloatTag d;
    int survivors = 0;
    for (int first = 0; first < reached.count; first += lane_count()) {
        // Lanes beyond the last path repeat it.
        const I place = hn::Min(hn::Iota(IntTag(), first), hn::Set(IntTag(), reached.count - 1));
        const I path = gather(reached.at, place);
        const I slot = gather(paths.slot, path);
        const LaneSampler sampler(hn::BitCast(WordTag(), gather(samples.pixel_hash, slot)),
                                  hn::BitCast(WordTag(), gather(samples.reversed_sample, slot)));
        const U index = vertex_index_of(paths, path);
        F u[4];
        sampler.get_4d(index + index + all_words(1), u);
        const F3 throughput = gather(paths.throughput, path);
        const F survival = survival_of<Lanes>(throughput);
        const PackedLanes survives(
            hn::And(hn::Lt(u[2], survival),
                    hn::FirstN(d, static_cast<std::size_t>(reached.count - first))));
        hn::ScatterIndex(throughput.x / survival, d, paths.throughput.x.at, path);
        hn::ScatterIndex(throughput.y / survival, d, paths.throughput.y.at, path);
        hn::ScatterIndex(throughput.z / survival, d, paths.throughput.z.at, path);
        // What is overwritten has been read.
        store_some(path, survives, reached.at, survivors);
        survivors += survives.count();
    }
    reached.count = survivors;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
