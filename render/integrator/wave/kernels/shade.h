// One step of a wave's paths: at each vertex lights are sampled, caustics are requested and
// directions are sampled; in lanes. Included as render/lanes/kernels/vectors.h is.
// `next`: where what continues goes. A device gives each of its calls a place of its own, a
// processor appends the lanes.

/// The vertices that sample caustics, with the decision of caustics.cpp.
template <class L>
CAROM_KERNEL MaskOf<L> asks_for_caustics(const WaveStep& step, const VertexOf<L>& v,
                                         const SamplerOf<L>& sampler) {
    const auto object = load<L>(step.vertices.object, v.first);
    const auto own = gather<L>(step.scene.sphere_of_object, object);
    auto total = L::all(0);
    for (int index = 0; index < step.scene.spheres.count(); ++index) {
        const SphereBounds& sphere = step.scene.spheres[index];
        const auto share =
            solid_angle_fraction<L>(all_of<L>(sphere.centre) - v.position, v.bsdf.geometric_normal,
                                    sphere.bounding_radius, sphere.radius2, sphere.gain);
        const auto is_own = L::is_equal_int(own, L::all_int(index));
        total = total + L::select(is_own, L::all(0), share);
    }
    const auto roulette =
        sampler.get_1d(L::all_word(kCausticSets) + v.vertex_index + v.vertex_index);
    return L::both(v.connects, L::is_less(roulette, total));
}

/// Writes the shadow rays of the vertices from `first` on. `next` has `coat` and `base`, which take
/// paths and the lanes that continue, and `near_sphere`, which takes the lanes that sample
/// caustics.
template <class L, class Next>
CAROM_KERNEL void shade_surfaces(const WaveStep& step, int first, const Next& next) {
    const int vertex = step.paths.vertex;
    const bool has_lights = step.shadows.rays > 0;
    const bool connects = step.scene.caustics && vertex < kConnectingVertices &&
                          vertex < step.scene.max_bounces && step.scene.spheres.exists();
    VertexOf<L> v = vertex_at<L>(step, first);
    const auto sampler = sampler_of<L>(step.samples, gather<L>(step.paths.slot, v.path));
    ValueOf<L> u[4];
    sampler.get_4d(v.vertex_index + v.vertex_index, u);
    if (L::none(v.scatters)) {
        for (int k = 0; k < step.shadows.rays; ++k) {
            store<L>(L::all(0), step.shadows.t_max, step.shadows.place(k, first));
        }
    } else if (has_lights && vertex == 0) {
        sample_all_lights<L>(step, v, sampler);
    } else if (has_lights) {
        sample_one_light<L>(step, v, {u[0], u[1]});
    }
    store<L>(v.origin, step.shadows.origin, first);
    store<L>(v.time, step.shadows.time, first);
    if (connects) {
        next.near_sphere(asks_for_caustics<L>(step, v, sampler));
    }
    const Vec2Of<L> of_direction{u[2], u[3]};
    const ContinuationOf<L> from = continuation_of<L>(step, v, of_direction.x);
    follow_coats<L>(step, v, from, sampler, of_direction, connects, next.coat);
    follow_base<L>(step, v, from, of_direction, connects, next.base);
}

/// One direction of the coat of each vertex that has one, which stands for all of its directions.
template <class L, class Next>
CAROM_KERNEL void trace_coats(const WaveStep& step, int first, const Next& next) {
    const VertexOf<L> v = vertex_at<L>(step, first);
    if (L::none(v.splits)) {
        return;
    }
    Vec2Of<L> numbers{L::all(0), L::all(0)};
    if (v.bsdf.lobes.any_rough_coat) {
        const auto sampler = sampler_of<L>(step.samples, gather<L>(step.paths.slot, v.path));
        ValueOf<L> further[4];
        sampler.get_4d(v.vertex_index + v.vertex_index + L::all_word(1), further);
        numbers = {further[0], further[1]};
    }
    const ContinuationOf<L> from = continuation_of<L>(step, v, L::all(0));
    DirectionOf<L> to = sample_coat<L>(v.bsdf, v.splits, from.takes_coat, numbers);
    to.weight = to.weight * v.coat_samples;
    proceed<L>(step, v, from, to, from.branch + from.branch, v.coat_samples, v.splits, false, next);
}
