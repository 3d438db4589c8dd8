// Vertices of a wave in lanes, and the BSDF of their surfaces. Included once per instruction set.
#if defined(CAROM_WAVE_VERTICES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_VERTICES_INL_H
#undef CAROM_WAVE_VERTICES_INL_H
#else
#define CAROM_WAVE_VERTICES_INL_H
#endif

#include "render/integrator/path_state.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using Layers = LayersOf<Lanes>;
using Lobes = LobesOf<Lanes>;
using LobeValue = LobeValueOf<Lanes>;

/// Vertices in the lanes: surface, path, and sampling decisions.
struct VertexLanes {
    int first;  // of the vertices
    M valid;
    I path;
    F3 position, geometric_normal, origin;
    F time;
    Basis frame;
    F3 throughput;
    F3 wo;  // towards the viewer, in the axes of `frame`, z > 0
    F3 base;
    Layers layers;
    Lobes lobes;
    M scatters;      // has a lobe that is not specular
    M splits;        // the coat and the base are followed separately
    M shows_gloss;   // the coat is sampled several times
    bool any_gloss;  // false: it is not in any lane
    F coat_samples;  // number of directions of the coat
    M connects;      // caustics may be sampled
    U vertex_index;
    F total_importance, environment_samples;
};

HWY_INLINE M no_lanes() {
    return hn::MaskFromVec(hn::Zero(FloatTag()));
}

/// `number_of` returns a number of each lane's material. Waves have no glass.
template <class NumberOf>
HWY_INLINE Layers layers_from(const WaveMaterials& materials, I material,
                              const NumberOf& number_of) {
    Layers layers;
    std::size_t place = 0;
    Layers::each_number(
        layers, [&](F& number) HWY_ATTR { number = number_of(materials.numbers[place++]); });
    layers.transmission = all(0.f);
    layers.tables = materials.tables();
    layers.first = Lanes::product(material, kAlbedoNodes);
    return layers;
}

/// Vertices are sorted, so that mostly all lanes have the same material.
HWY_INLINE Layers layers_of(const WaveMaterials& materials, I material) {
    const IntTag di;
    const std::int32_t first = hn::GetLane(material);
    if (hn::AllTrue(di, hn::Eq(material, hn::Set(di, first)))) {
        const auto index = static_cast<std::size_t>(first);
        return layers_from(materials, material, [&](const std::vector<float>& numbers) HWY_ATTR {
            return all(numbers[index]);
        });
    }
    return layers_from(materials, material, [&](const std::vector<float>& numbers) HWY_ATTR {
        return gather(numbers, material);
    });
}

/// Sets which lobes there are, and how they are followed.
HWY_INLINE void decide(const WaveStep& step, VertexLanes& v) {
    const LobeKindsOf<Lanes> kinds = kinds_of_lobes<Lanes>(v.layers, v.lobes);
    v.scatters = hn::And(kinds.scatters(), v.valid);
    v.connects = hn::AndNot(kinds.is_narrow, v.scatters);
    const M has_coat = hn::And(v.valid, hn::Gt(v.lobes.coat, all(0.f)));
    const FollowingOf<Lanes> following =
        following_at<Lanes>(step.paths.vertex, step.scene.split_vertices, step.scene.glossy_samples,
                            has_coat, v.lobes.has_rough_coat);
    v.splits = following.splits;
    v.shows_gloss = following.shows_gloss;
    v.any_gloss = following.any_gloss;
    v.coat_samples =
        select(v.shows_gloss, all(static_cast<float>(step.scene.glossy_samples)), all(1.f));
}

HWY_INLINE VertexLanes vertices_at(const WaveStep& step, int first) {
    const VertexWave& in = step.vertices;
    const FloatTag d;
    const IntTag di;
    VertexLanes v;
    v.first = first;
    v.valid = hn::FirstN(d, static_cast<std::size_t>(in.count - first));
    v.path = load(in.path, first);
    v.position = load(in.position, first);
    v.geometric_normal = load(in.geometric_normal, first);
    v.origin = v.position + v.geometric_normal * load(in.offset, first);
    v.time = gather(step.paths.time, v.path);
    v.frame = basis_around<Lanes>(load(in.normal, first));
    v.throughput = gather(step.paths.throughput, v.path);
    v.wo = v.frame.from_world(-gather(step.paths.direction, v.path));
    v.wo.z = hn::Max(v.wo.z, all(kLeastLocalCosine));
    v.base = load(in.base, first);
    // Lanes beyond the last vertex have the material of the first one.
    const I known = load(in.material, first);
    const I material =
        hn::IfThenElse(hn::RebindMask(di, v.valid), known, hn::Set(di, hn::GetLane(known)));
    v.layers = layers_of(step.scene.materials, material);
    v.lobes = weigh_lobes<Lanes>(v.layers, v.base, v.wo.z, no_lanes());
    decide(step, v);
    const I vertex_index =
        hn::ShiftLeft<7>(gather(step.paths.branch, v.path)) + hn::Set(di, step.paths.vertex);
    static_assert(PathDimensions::kVertices == 1u << 7);
    v.vertex_index = hn::BitCast(WordTag(), vertex_index);
    v.total_importance = all(0.f);
    v.environment_samples = gather(step.paths.environment_samples, v.path);
    return v;
}

/// Probability of sampling the base.
HWY_INLINE F base_probability(const VertexLanes& v) {
    return select(v.splits, all(1.f), all(1.f) - v.lobes.coat_choice);
}

/// `wi` in the axes of the vertex' frame; only its height if that suffices for the lobes.
HWY_INLINE F3 local_direction(const VertexLanes& v, const F3& wi, F height) {
    if (v.lobes.any_glossy()) {
        return {dot(wi, v.frame.x), dot(wi, v.frame.y), height};
    }
    return {all(0.f), all(0.f), height};
}

HWY_INLINE LobeValue base_towards(const VertexLanes& v, const F3& wi) {
    return base_towards<Lanes>(v.layers, v.lobes, v.base, v.wo, wi);
}
HWY_INLINE LobeValue coat_towards(const VertexLanes& v, const F3& wi) {
    return coat_towards<Lanes>(v.layers, v.lobes, v.wo, wi);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
