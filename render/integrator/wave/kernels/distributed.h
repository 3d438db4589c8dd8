// One generation of rays of distributed ray tracing, in lanes: the light of their vertices, and the
// rays that these send. Included as render/lanes/kernels/vectors.h is.

// Every ray of the tree draws its random numbers from sets of its own, identified by its place.
inline constexpr std::uint32_t kLightSets = 0x9e3779b9u;

template <class L>
CAROM_KERNEL WordOf<L> child_of(WordOf<L> node, WordOf<L> child) {
    auto x = node * L::all_word(0x85ebca6bu) + child + L::all_word(0x165667b1u);
    x = (x ^ L::template shifted_right<15>(x)) * L::all_word(0x2c1b3c6du);
    return x ^ L::template shifted_right<13>(x);
}

/// Vertices of a generation.
template <class L>
struct DistributedVertexOf {
    int first;
    MaskOf<L> valid, from_behind;
    IntOf<L> ray, slot;
    Vec3Of<L> position, geometric_normal, normal, base;
    Vec3Of<L> wo;  // towards the viewer
    Vec3Of<L> throughput;
    ValueOf<L> time;
    WordOf<L> node;
    ClassicOf<L> model;
    SamplerOf<L> sampler;
};

template <class L>
CAROM_KERNEL DistributedVertexOf<L> distributed_vertex_at(const DistributedStep& step, int first) {
    const SurfaceQueue& in = step.vertices;
    const auto valid = L::first_lanes(in.count - first);
    const auto ray = load<L>(in.path, first);
    const auto slot = gather<L>(step.rays.slot, ray);
    const Vec3Of<L> direction = gather<L>(step.rays.direction, ray);
    const auto material = materials_of<L>(in, first, valid);
    ClassicOf<L> model;
    set_numbers<L>(
        step.scene.materials.classic,
        [&](const float* row) CAROM_KERNEL_ATTRIBUTE { return L::gather(row, material); }, model);
    return {first,
            valid,
            is_set<L>(load<L>(in.from_behind, first)),
            ray,
            slot,
            load<L>(in.position, first),
            load<L>(in.geometric_normal, first),
            load<L>(in.normal, first),
            load<L>(in.base, first),
            opposite<L>(direction),
            gather<L>(step.rays.throughput, ray),
            gather<L>(step.rays.time, ray),
            L::to_word(gather<L>(step.rays.branch, ray)),
            model,
            sampler_of<L>(step.samples, slot)};
}

/// The rays towards one light, which are `count`. Returns the number of the next ray.
template <class L>
CAROM_KERNEL int shade_by_light(const DistributedStep& step, const DistributedVertexOf<L>& v,
                                const WaveLight& light, const Vec2Of<L>& u, int count, int k) {
    const auto zero = L::all(0);
    const PlaceOf<L> place{v.position, v.normal, v.time};
    const SeenTreeOf<L> seen = see_light<L>(step.scene, light, place);
    const auto share = L::all(kInversePi / static_cast<float>(count));
    for (int j = 0; j < count; ++j, ++k) {
        const LightSampleOf<L> found =
            sample_light<L>(step.scene, light, seen, place, lattice_point<L>(u, j, count));
        const auto is_above = L::both(L::is_less(zero, dot(v.normal, found.direction)),
                                      L::is_less(zero, dot(v.geometric_normal, found.direction)));
        const auto emits = L::both(L::both(v.valid, found.valid), is_above);
        const Vec3Of<L> scattered =
            classic_towards<L>(v.model, v.base, v.normal, v.wo, found.direction);
        const Vec3Of<L> value = v.throughput * scattered * found.radiance * (share / found.pdf);
        put_rays<L>(step.shadows, k, v.first, found, value,
                    L::both(emits, L::is_less(zero, largest<L>(value))));
    }
    return k;
}

/// Writes the light of the surfaces from `first` on, and their shadow rays.
template <class L>
CAROM_KERNEL void shade_rays(const DistributedStep& step, int first) {
    const auto zero = L::all(0);
    const DistributedVertexOf<L> v = distributed_vertex_at<L>(step, first);
    const Vec3Of<L> emitted = select<L>(v.from_behind, {zero, zero, zero}, v.model.emission);
    store<L>(v.throughput * (emitted + v.model.ambient_colour(v.base) * L::all(step.ambient)),
             step.own, first);
    const auto offset = load<L>(step.vertices.offset, first);
    store<L>(v.position + v.geometric_normal * offset, step.shadows.origin, first);
    store<L>(v.time, step.shadows.time, first);
    ValueOf<L> numbers[4];
    int k = 0;
    for (int index = 0; index < step.scene.lights.count(); ++index) {
        const WaveLight& light = step.scene.lights[index];
        if (index % 2 == 0) {
            const auto pair = static_cast<std::uint32_t>(index / 2);
            v.sampler.get_4d(child_of<L>(v.node ^ L::all_word(kLightSets), L::all_word(pair)),
                             numbers);
        }
        const int pair_at = 2 * (index % 2);
        Vec2Of<L> u{numbers[pair_at], numbers[pair_at + 1]};
        if (step.counts.centred) {
            // Both coordinates of a rectangle, the axis of a sphere's cone.
            u = {L::all(light.is_round ? 0.F : 0.5F), L::all(0.5F)};
        }
        // All rays to a delta light are the same.
        const int count = light.kind == WaveLight::Kind::delta ? 1 : step.counts.shadow;
        k = shade_by_light<L>(step, v, light, u, count, k);
    }
}

/// A direction of a lobe, with its cosine to the axis.
template <class L>
struct LobeRayOf {
    Vec3Of<L> direction;  // around +z
    ValueOf<L> weight;
};

template <class L>
CAROM_KERNEL LobeRayOf<L> lobe_ray(const Vec2Of<L>& numbers, int k, int samples, ValueOf<L> spread,
                                   ValueOf<L> most, MaskOf<L> spreads) {
    const auto one = L::all(1);
    const Vec2Of<L> u = lattice_point<L>(numbers, k, samples);
    const Vec3Of<L> along{L::all(0), L::all(0), one};
    const Vec3Of<L> direction = select<L>(
        spreads, sample_gaussian_lobe<L>(u, L::select(spreads, spread, one), most), along);
    return {direction, direction.z};
}

/// The random numbers of a lobe's rays, and the place in the tree of which they are children.
template <class L>
struct LobeNumbersOf {
    Vec2Of<L> u;
    WordOf<L> branch;
};

template <class L>
CAROM_KERNEL LobeNumbersOf<L> numbers_of_lobe(const DistributedVertexOf<L>& v, float side) {
    const auto branch = child_of<L>(v.node, L::all_word(side > 0 ? 0 : 1));
    ValueOf<L> u[4];
    v.sampler.get_4d(branch, u);
    return {{u[0], u[1]}, branch};
}

/// Writes a lobe of the vertices. `samples`: of lobes that spread. Returns the most rays that any
/// lane sends.
template <class L>
CAROM_KERNEL int find_lobe(const DistributedVertexOf<L>& v, const ClassicLobeOf<L>& lobe,
                           ValueOf<L> spread, ValueOf<L> most, int samples, const LobeWave& out) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const auto exists = L::both(L::both(v.valid, L::is_less(zero, largest<L>(lobe.colour))),
                                samples > 0 ? v.valid : L::first_lanes(0));
    const auto spreads =
        samples > 1 ? L::both(exists, L::is_less(zero, spread)) : L::first_lanes(0);
    const bool any_spreads = !L::none(spreads);
    auto sum = one;
    if (any_spreads) {
        const Vec2Of<L> u = numbers_of_lobe<L>(v, out.side).u;
        auto weights = zero;
        for (int k = 0; k < samples; ++k) {
            weights = weights + lobe_ray<L>(u, k, samples, spread, most, spreads).weight;
        }
        sum = L::select(spreads, weights, sum);
    }
    store<L>(lobe.axis, out.axis, v.first);
    const auto counts = L::both(exists, L::is_less(zero, sum));
    store<L>(v.throughput * lobe.colour * (one / L::select(counts, sum, one)), out.colour, v.first);
    store<L>(L::select(spreads, spread, zero), out.spread, v.first);
    store<L>(most, out.most, v.first);
    const auto number = L::select_int(spreads, L::all_int(samples), L::all_int(1));
    store<L>(L::select_int(counts, number, L::all_int(0)), out.count, v.first);
    return any_spreads ? samples : L::none(exists) ? 0 : 1;
}

/// The most rays of any of some vertices, by kind.
struct LobeRays {
    int reflection = 0, refraction = 0;
};

template <class L>
CAROM_KERNEL LobeRays find_lobes(const DistributedStep& step, int first) {
    const DistributedVertexOf<L> v = distributed_vertex_at<L>(step, first);
    const ClassicLobesOf<L> lobes =
        classic_lobes<L>(v.model, v.base, v.geometric_normal, v.normal, v.wo, v.from_behind,
                         step.counts.refraction > 0);
    return {find_lobe<L>(v, lobes.reflection, v.model.reflectance_spread, v.model.reflectance_most,
                         step.counts.reflection, step.reflection),
            find_lobe<L>(v, lobes.refraction, v.model.transmittance_spread,
                         v.model.transmittance_most, step.counts.refraction, step.refraction)};
}

/// The `k`th rays of a lobe. `next` takes them and the lanes that send one.
template <class L, class Next>
CAROM_KERNEL void send_rays(const DistributedStep& step, const LobeWave& lobe, int k, int first,
                            const Next& next) {
    const auto zero = L::all(0);
    const auto wanted = L::both(L::first_lanes(step.vertices.count - first),
                                L::is_less_int(L::all_int(k), load<L>(lobe.count, first)));
    if (L::none(wanted)) {
        return;
    }
    const DistributedVertexOf<L> v = distributed_vertex_at<L>(step, first);
    const auto spread = load<L>(lobe.spread, first);
    const auto spreads = L::is_less(zero, spread);
    const LobeNumbersOf<L> numbers = numbers_of_lobe<L>(v, lobe.side);
    const int samples = L::none(spreads) ? 1 : lobe.samples;
    const Vec3Of<L> axis = load<L>(lobe.axis, first);
    const Vec3Of<L> outside = v.geometric_normal * L::all(lobe.side);
    LobeRayOf<L> ray{{zero, zero, L::all(1)}, L::all(1)};
    NextRayOf<L> sent;
    sent.direction = axis;
    if (samples > 1) {
        ray = lobe_ray<L>(numbers.u, k, samples, spread, load<L>(lobe.most, first), spreads);
        const BasisOf<L> basis = basis_around<L>(axis);
        const Vec3Of<L> turned{L::opposite_sign(ray.direction.x), L::opposite_sign(ray.direction.y),
                               ray.direction.z};
        const Vec3Of<L> near = unit<L>(basis.to_world(ray.direction));
        // A ray that would pass to the wrong side is turned to the opposite azimuth.
        const auto stays = L::is_less(zero, dot(near, outside));
        const Vec3Of<L> far = unit<L>(basis.to_world(turned));
        sent.direction = select<L>(spreads, select<L>(stays, near, far), axis);
    }
    const auto cone = gather<L>(step.rays.cone_spread, v.ray);
    sent.slot = v.slot;
    sent.branch =
        L::from_word(child_of<L>(numbers.branch, L::all_word(static_cast<std::uint32_t>(k) + 2)));
    sent.origin = v.position + outside * load<L>(step.vertices.offset, first);
    sent.time = v.time;
    sent.throughput = load<L>(lobe.colour, first) * ray.weight;
    sent.cone_width =
        gather<L>(step.rays.cone_width, v.ray) + cone * load<L>(step.vertices.distance, first);
    const auto mirrored = L::smaller(cone * L::all(kMirrorSpread), L::all(kWidestSpread));
    const auto widened = L::smaller(L::larger(spread, cone), L::all(kWidestSpread));
    sent.cone_spread = L::select(spreads, widened, mirrored);
    next(sent, wanted);
}
