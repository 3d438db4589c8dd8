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
using LobeValue = LobeValueOf<Lanes>;

/// Vertices in the lanes: surface, path, and sampling decisions.
struct VertexLanes {
    int first;  // of the vertices
    M valid;
    I path;
    F3 position, origin;
    F time;
    F3 throughput;
    BsdfOf<Lanes> bsdf;
    M scatters;      // has a lobe that is not specular
    M splits;        // the coat and the base are followed separately
    M shows_gloss;   // the coat is sampled several times
    bool any_gloss;  // false: it is not in any lane
    F coat_samples;  // number of directions of the coat
    M connects;      // caustics may be sampled
    U vertex_index;
    F total_importance, environment_samples;
};

/// `number_of` returns a number of each lane's material.
template <class NumberOf>
HWY_INLINE void set_layers(const WaveMaterials& materials, I material, const NumberOf& number_of,
                           Layers& layers) {
    const auto set = [&](const WaveNumberTable& table, auto& numbers) HWY_ATTR {
        std::size_t place = 0;
        std::decay_t<decltype(numbers)>::each_number(
            numbers, [&](F& number) HWY_ATTR { number = number_of(table[place++]); });
    };
    set(materials.layers, layers);
    const M is_glass = hn::Gt(layers.transmission, all(0.f));
    layers.any_glass = !materials.glass.empty() && !hn::AllFalse(FloatTag(), is_glass);
    if (layers.any_glass) {
        set(materials.glass, layers.glass);
    }
    layers.is_phong = no_lanes();
    if (!materials.phong.empty()) {
        layers.is_phong = hn::Gt(number_of(materials.is_phong), all(0.f));
    }
    layers.any_phong = !hn::AllFalse(FloatTag(), layers.is_phong);
    if (layers.any_phong) {
        set(materials.phong, layers.phong);
    }
    layers.tables = materials.tables();
    layers.first = Lanes::product(material, kAlbedoNodes);
}

/// Vertices are sorted, so that mostly all lanes have the same material.
HWY_INLINE void set_layers(const WaveMaterials& materials, I material, Layers& layers) {
    const IntTag di;
    const std::int32_t first = hn::GetLane(material);
    if (hn::AllTrue(di, hn::Eq(material, hn::Set(di, first)))) {
        const auto index = static_cast<std::size_t>(first);
        const auto of_all = [&](const std::vector<float>& numbers)
                                HWY_ATTR { return all(numbers[index]); };
        set_layers(materials, material, of_all, layers);
    } else {
        const auto of_each = [&](const std::vector<float>& numbers)
                                 HWY_ATTR { return gather(numbers, material); };
        set_layers(materials, material, of_each, layers);
    }
}

/// Sets which lobes there are, and how they are followed.
HWY_INLINE void decide(const WaveStep& step, VertexLanes& v) {
    const LobeKindsOf<Lanes> kinds = kinds_of_lobes<Lanes>(v.bsdf);
    v.scatters = hn::And(kinds.scatters(), v.valid);
    v.connects = hn::AndNot(hn::Or(kinds.is_narrow, v.bsdf.transmits), v.scatters);
    const M has_coat = hn::And(v.valid, hn::Gt(v.bsdf.lobes.coat, all(0.f)));
    const SplittingOf<Lanes> splitting =
        splitting_at<Lanes>(step.paths.vertex, step.scene.split_vertices, step.scene.glossy_samples,
                            has_coat, v.bsdf.lobes.has_rough_coat);
    v.splits = splitting.splits;
    v.shows_gloss = splitting.shows_gloss;
    v.any_gloss = splitting.any_gloss;
    v.coat_samples =
        select(v.shows_gloss, all(static_cast<float>(step.scene.glossy_samples)), all(1.f));
}

HWY_INLINE VertexLanes vertices_at(const WaveStep& step, int first) {
    const SurfaceQueue& in = step.vertices;
    const FloatTag d;
    const IntTag di;
    const I zero = hn::Zero(di);
    VertexLanes v;
    v.first = first;
    v.valid = hn::FirstN(d, static_cast<std::size_t>(in.count - first));
    v.path = load(in.path, first);
    v.position = load(in.position, first);
    const F3 geometric_normal = load(in.geometric_normal, first);
    v.origin = v.position + geometric_normal * load(in.offset, first);
    v.time = gather(step.paths.time, v.path);
    v.throughput = gather(step.paths.throughput, v.path);
    // Lanes beyond the last vertex have the material of the first one.
    const I known = load(in.material, first);
    const I material =
        hn::IfThenElse(hn::RebindMask(di, v.valid), known, hn::Set(di, hn::GetLane(known)));
    M from_behind = no_lanes();
    if (step.scene.materials.transmits) {
        from_behind = hn::AndNot(is_equal(load(in.from_behind, first), zero), v.valid);
    }
    set_layers(step.scene.materials, material, v.bsdf.layers);
    complete<Lanes>(v.bsdf, load(in.base, first), geometric_normal, load(in.normal, first),
                    -gather(step.paths.direction, v.path), from_behind);
    if (in.some_end) {
        v.valid = hn::And(v.valid, is_equal(load(in.ends, first), zero));
    }
    decide(step, v);
    const I vertex_index =
        hn::ShiftLeft<7>(gather(step.paths.branch, v.path)) + hn::Set(di, step.paths.vertex);
    static_assert(PathDimensions::kVertices == 1u << 7);
    v.vertex_index = hn::BitCast(WordTag(), vertex_index);
    v.total_importance = all(0.f);
    v.environment_samples = gather(step.paths.environment_samples, v.path);
    return v;
}

/// Where rays in a direction start: beyond the surface in the lanes that pass through it.
HWY_INLINE F3 origin_of_rays(const VertexLanes& v, M passes) {
    if (!v.bsdf.any_transmits) {
        return v.origin;
    }
    return select(passes, v.position * all(2.f) - v.origin, v.origin);
}

/// `wi` in the axes of the vertex' frame; only its height if that suffices for the lobes.
HWY_INLINE F3 local_direction(const VertexLanes& v, const F3& wi, F height) {
    if (v.bsdf.any_glossy()) {
        return {dot(wi, v.bsdf.frame.x), dot(wi, v.bsdf.frame.y), height};
    }
    return {all(0.f), all(0.f), height};
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
