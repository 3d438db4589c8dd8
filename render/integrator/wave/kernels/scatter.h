// The next directions of a wave's paths, in lanes. Included as render/lanes/kernels/vectors.h is.

/// A ray that continues from a vertex: what PathQueue has of it in every integrator.
template <class L>
struct NextRayOf {
    IntOf<L> slot, branch;
    Vec3Of<L> origin, direction;
    ValueOf<L> time;
    Vec3Of<L> throughput;
    ValueOf<L> cone_width, cone_spread;
};

/// All that PathQueue has of a path.
template <class L>
struct NextPathOf : NextRayOf<L> {
    Vec3Of<L> last_position, last_normal;
    ValueOf<L> pdf, total_importance, environment_samples;
    IntOf<L> is_delta, connects, connected_sphere, entered_sphere;
};

/// What continues from the vertices whatever their directions.
template <class L>
struct ContinuationOf {
    ValueOf<L> cone_width, cone_spread;
    IntOf<L> branch;
    MaskOf<L> by_chance;   // either the coat or the base is followed
    MaskOf<L> takes_coat;  // the coat, by chance
};

/// `u`: the number by which coat or base is chosen.
template <class L>
CAROM_KERNEL ContinuationOf<L> continuation_of(const WaveStep& step, const VertexOf<L>& v,
                                               ValueOf<L> u) {
    ContinuationOf<L> from;
    from.cone_spread = gather<L>(step.paths.cone_spread, v.path);
    from.cone_width = gather<L>(step.paths.cone_width, v.path) +
                      from.cone_spread * load<L>(step.vertices.distance, v.first);
    from.branch = gather<L>(step.paths.branch, v.path);
    from.by_chance = L::without(v.valid, v.splits);
    from.takes_coat = L::both(from.by_chance, L::is_less(u, v.bsdf.lobes.coat_probability));
    return from;
}

/// Caustics are sampled for paths of a broad lobe followed by one specular reflection on a sphere,
/// or by the two refractions of a path through it.
template <class L>
CAROM_KERNEL void set_spheres(const WaveStep& step, const VertexOf<L>& v, const DirectionOf<L>& to,
                              NextPathOf<L>& path) {
    const auto none = L::all_int(-1);
    const auto object = load<L>(step.vertices.object, v.first);
    const auto connected = L::is_equal_int(gather<L>(step.paths.connects, v.path), L::all_int(1));
    const auto reflects = L::without(to.is_delta, to.passes);
    path.connected_sphere = L::select_int(L::both(reflects, connected), object, none);
    path.entered_sphere = none;
    if (!step.scene.materials.transmits) {
        return;
    }
    const auto refracts = L::both(to.passes, to.is_delta);
    const auto is_inside =
        L::both(refracts, is_set<L>(load<L>(step.vertices.from_behind, v.first)));
    const auto leaves =
        L::both(is_inside, L::is_equal_int(gather<L>(step.paths.entered_sphere, v.path), object));
    path.connected_sphere =
        L::select_int(leaves, object | L::all_int(PathQueue::kPassedSphere), path.connected_sphere);
    const auto enters = step.paths.vertex > 0 ? L::both(L::without(refracts, is_inside), connected)
                                              : L::first_lanes(0);
    path.entered_sphere = L::select_int(enters, object, none);
}

/// Passes a direction on to `next` where it is on the right side of the surface and carries light.
/// `samples`: the number of directions taken of the part.
template <class L, class Next>
CAROM_KERNEL void proceed(const WaveStep& step, const VertexOf<L>& v, const ContinuationOf<L>& from,
                          const DirectionOf<L>& to, IntOf<L> branch, ValueOf<L> samples,
                          MaskOf<L> wanted, bool connects, const Next& next) {
    const auto one = L::all_int(1);
    const auto zero = L::all_int(0);
    const SideOf<L> side = side_of<L>(v.bsdf, to.world, to.wi.z);
    const Vec3Of<L> weight = to.weight * (L::all(1) / samples);
    const auto agrees =
        L::either(L::without(side.is_above, to.passes), L::both(to.passes, side.passes));
    const auto emits = L::is_less(L::all(0), largest<L>(weight));
    const auto goes = L::both(L::both(wanted, to.valid), L::both(agrees, emits));
    if (L::none(goes)) {
        return;
    }
    NextPathOf<L> path;
    path.slot = gather<L>(step.paths.slot, v.path);
    path.branch = branch;
    path.origin = origin_of_rays<L>(v, side.passes);
    path.direction = to.world;
    path.time = v.time;
    path.throughput = v.throughput * weight;
    path.cone_width = from.cone_width;
    const auto lobe = L::smaller(L::all(kLobeFraction) / L::root(to.pdf), L::all(kWidestSpread));
    const auto mirrored =
        L::smaller(from.cone_spread * L::all(kMirrorSpread), L::all(kWidestSpread));
    path.cone_spread = L::select(to.is_delta, mirrored, L::larger(from.cone_spread, lobe));
    path.last_position = v.position;
    path.last_normal = v.bsdf.frame.z;
    path.pdf = to.pdf * samples;
    path.total_importance = v.total_importance;
    path.environment_samples = v.environment_samples;
    path.is_delta = L::select_int(to.is_delta, one, zero);
    path.connects = zero;
    if (connects) {
        path.connects = L::select_int(L::without(v.connects, to.is_delta), one, zero);
    }
    set_spheres<L>(step, v, to, path);
    next(path, goes);
}

/// `next.at(k)` takes the `k`th direction of each coat.
template <class L, class Next>
CAROM_KERNEL void follow_coats(const WaveStep& step, const VertexOf<L>& v,
                               const ContinuationOf<L>& from, const SamplerOf<L>& sampler,
                               const Vec2Of<L>& u, bool connects, const Next& next) {
    const auto coats =
        L::both(L::either(v.splits, from.takes_coat), L::is_less(L::all(0), v.bsdf.lobes.coat));
    if (L::none(coats)) {
        return;
    }
    Vec2Of<L> numbers{after_choice<L>(v.bsdf, v.splits, u.x), u.y};
    if (v.bsdf.lobes.any_rough_coat) {
        ValueOf<L> further[4];
        sampler.get_4d(v.vertex_index + v.vertex_index + L::all_word(1), further);
        numbers = {L::select(v.splits, further[0], numbers.x),
                   L::select(v.splits, further[1], numbers.y)};
    }
    const auto twice = L::select_int(v.splits, from.branch + from.branch, from.branch);
    const int samples = v.any_gloss ? step.scene.glossy_samples : 1;
    for (int k = 0; k < samples; ++k) {
        Vec2Of<L> point = numbers;
        if (v.any_gloss) {
            const Vec2Of<L> shifted = lattice_point<L>(numbers, k, samples);
            point = {L::select(v.shows_gloss, shifted.x, numbers.x),
                     L::select(v.shows_gloss, shifted.y, numbers.y)};
        }
        const auto branch = twice + L::all_int(static_cast<std::int32_t>(kBranchesOfOneCoat) * k);
        proceed<L>(step, v, from, sample_coat<L>(v.bsdf, v.splits, from.takes_coat, point), branch,
                   v.coat_samples, k == 0 ? coats : v.shows_gloss, connects, next.at(k));
    }
}

/// Likewise; there is one direction.
template <class L, class Next>
CAROM_KERNEL void follow_base(const WaveStep& step, const VertexOf<L>& v,
                              const ContinuationOf<L>& from, const Vec2Of<L>& u, bool connects,
                              const Next& next) {
    const auto bases = L::without(v.valid, from.takes_coat);
    const DirectionOf<L> to =
        sample_base<L>(v.bsdf, v.splits, {after_choice<L>(v.bsdf, v.splits, u.x), u.y});
    const auto branch =
        L::select_int(v.splits, from.branch + from.branch + L::all_int(1), from.branch);
    proceed<L>(step, v, from, to, branch, L::all(1), bases, connects, next.at(0));
}
