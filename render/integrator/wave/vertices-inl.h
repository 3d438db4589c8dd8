// Vertices of a wave in lanes, and the BSDF of their surfaces, with the formulas of
// material/lobe_weights.cpp, bsdf.cpp and sheen.h. Included once per instruction set.
#if defined(CAROM_WAVE_VERTICES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_VERTICES_INL_H
#undef CAROM_WAVE_VERTICES_INL_H
#else
#define CAROM_WAVE_VERTICES_INL_H
#endif

#include "render/integrator/path_state.h"
#include "render/integrator/wave/wave_kernels.h"
#include "render/integrator/wave/wave_lanes-inl.h"
#include "render/material/lobe_weights.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Vertices in the lanes: surface, path, and sampling decisions.
struct VertexLanes {
    int first;  // of the vertices
    M valid;
    I path;
    F3 position, geometric_normal, origin;
    Basis frame;
    F3 throughput;
    F wo_z;
    F3 wo;
    F coat;
    F coat_choice;
    F3 diffuse;
    M has_sheen;
    bool any_sheen;  // false: sheen can be skipped; the result of a lane does not depend on it
    F3 sheen;
    F choose_sheen;  // probability of sampling the base by its sheen
    M scatters;      // has a base that is not black
    M splits;
    U vertex_index;
    F total_importance, environment_samples;
};

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
    v.frame = basis_around<Lanes>(load(in.normal, first));
    v.throughput = gather(step.paths.throughput, v.path);
    v.wo = -gather(step.paths.direction, v.path);
    v.wo_z = hn::Max(dot(v.wo, v.frame.z), all(1e-4f));
    const F coat_weight = load(in.coat_weight, first);
    v.coat = all(0.f);
    if (!hn::AllFalse(d, hn::Gt(coat_weight, all(0.f)))) {
        v.coat = coat_weight * fresnel_dielectric(v.wo_z, load(in.coat_ior, first));
    }
    const F rest = all(1.f) - v.coat;
    const F sheen_fraction = load(in.sheen_fraction, first);
    v.has_sheen = hn::Gt(sheen_fraction, all(0.f));
    v.any_sheen = !hn::AllFalse(d, hn::And(v.valid, v.has_sheen));
    v.diffuse = load(in.base, first) * rest;
    v.sheen = all(V3f(0, 0, 0));
    v.choose_sheen = all(0.f);
    F base = largest(v.diffuse);
    if (v.any_sheen) {
        v.diffuse = load(in.base, first) * (rest * (all(1.f) - hn::Min(all(1.f), sheen_fraction)));
        v.sheen = select(v.has_sheen, load(in.sheen, first) * rest, v.sheen);
        const F by_sheen = sheen_fraction * rest;
        const F by_both = by_sheen + largest(v.diffuse);
        v.choose_sheen = select(hn::Gt(by_both, all(0.f)), by_sheen / by_both, all(0.f));
        base = largest(v.diffuse) + largest(v.sheen);
    }
    v.scatters = hn::And(v.valid, hn::Gt(base, all(0.f)));
    const M is_coated = hn::Gt(v.coat, all(0.f));
    const F probability =
        hn::Min(hn::Max(v.coat / (v.coat + base), all(kLeastCoatChoice)), all(kMostCoatChoice));
    v.coat_choice =
        select(is_coated, select(hn::Gt(base, all(0.f)), probability, all(1.f)), all(0.f));
    v.splits = step.paths.vertex < step.scene.split_vertices ? hn::And(v.valid, is_coated)
                                                             : hn::MaskFromVec(all(0.f));
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
    return select(v.splits, all(1.f), all(1.f) - v.coat_choice);
}

/// The base's BSDF times the cosine of `wi`, as factors of the diffuse lobe's density and of the
/// sheen's.
struct BaseLanes {
    F diffuse, sheen;
    F pdf;  // of sampling the base
};

/// Evaluates Bsdf::evaluate_base with sheen.h, for `wi` with this positive cosine to the normal.
HWY_INLINE BaseLanes base_towards(const VertexLanes& v, const F3& wi, F cosine) {
    BaseLanes base{cosine * all(kInversePi), all(0.f), all(0.f)};
    base.pdf = base.diffuse;
    if (v.any_sheen) {
        const F3 h = v.wo + wi;
        const F height = v.wo_z + cosine;
        const F sine2 = hn::Max(all(0.f), all(1.f) - height * height / dot(h, h));
        const F density = all(2.5f * kInversePi) * sine2 * hn::Sqrt(sine2);
        base.sheen = density * cosine / (all(4.f) * (cosine + v.wo_z - cosine * v.wo_z));
        const F by_both =
            (all(1.f) - v.choose_sheen) * base.diffuse + v.choose_sheen * all(0.5f * kInversePi);
        base.pdf = select(v.has_sheen, by_both, base.diffuse);
    }
    return base;
}

HWY_INLINE F3 value_of(const VertexLanes& v, const BaseLanes& base) {
    const F3 diffuse = v.diffuse * base.diffuse;
    return v.any_sheen ? select(v.has_sheen, diffuse + v.sheen * base.sheen, diffuse) : diffuse;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
