// The shadow rays of a wave's vertices, in lanes. Included as render/lanes/kernels/vectors.h is.
// Each vertex has places of its own for its rays (ShadowQueue).

/// Writes the `k`th shadow ray of vertices: `radiance` arrives in the lanes `is_lit` unless
/// occluded.
template <class L>
CAROM_KERNEL void put_rays(const ShadowQueue& out, int k, int first, const LightSampleOf<L>& light,
                           const Vec3Of<L>& radiance, MaskOf<L> is_lit) {
    const int at = out.place(k, first);
    store<L>(light.direction, out.direction, at);
    store<L>(L::select(is_lit, light.distance * L::all(kOneMinusShadowEpsilon), L::all(0)),
             out.t_max, at);
    store<L>(radiance, out.radiance, at);
}

/// Which of the `k`th shadow rays of vertices there are; after they were traced, which are not
/// occluded.
template <class L>
CAROM_KERNEL MaskOf<L> has_rays(const ShadowQueue& shadows, int k, int first) {
    return L::is_less(L::all(0), load<L>(shadows.t_max, shadows.place(k, first)));
}

/// Sums the unoccluded light for each of the vertices.
template <class L>
CAROM_KERNEL void sum_light(const ShadowQueue& shadows, int first) {
    const auto zero = L::all(0);
    const Vec3Of<L> black{zero, zero, zero};
    Vec3Of<L> sum = black;
    for (int k = 0; k < shadows.rays; ++k) {
        const Vec3Of<L> light = load<L>(shadows.radiance, shadows.place(k, first));
        sum = sum + select<L>(has_rays<L>(shadows, k, first), light, black);
    }
    store<L>(sum, shadows.sum, first);
}

/// The weight of light that was sampled with the density `pdf`, where another way would have found
/// it with the density `other`.
template <class L>
CAROM_KERNEL ValueOf<L> weight_of(const WaveScene& scene, ValueOf<L> pdf, ValueOf<L> other) {
    return scene.strategy == DirectStrategy::both ? power_heuristic<L>(pdf, other) : L::all(1);
}

/// The light that a vertex scatters from a direction, per unit of radiance, weighted against the
/// scattering that could have found the light. `passes`: it is beyond the surface.
template <class L>
CAROM_KERNEL Vec3Of<L> weighted_value(const WaveScene& scene, const VertexOf<L>& v,
                                      const Vec3Of<L>& wi, MaskOf<L> passes, ValueOf<L> light_pdf) {
    const LobeValueOf<L> base = base_towards<L>(v.bsdf, wi, passes);
    const auto by_base = base_probability<L>(v.bsdf, v.splits) * base.pdf;
    if (!v.bsdf.lobes.any_rough_coat) {
        return base.value * weight_of<L>(scene, light_pdf, by_base);
    }
    const LobeValueOf<L> coat = coat_towards<L>(v.bsdf, wi, passes);
    const auto by_all = by_base + v.bsdf.lobes.coat_probability * coat.pdf;
    const auto weight_of_base =
        weight_of<L>(scene, light_pdf, L::select(v.splits, by_base, by_all));
    const auto weight_of_coat =
        weight_of<L>(scene, light_pdf, L::select(v.splits, coat.pdf * v.coat_samples, by_all));
    return base.value * weight_of_base + coat.value * weight_of_coat;
}

/// The density of samples of a light as it counts for their weight: beyond the near box no
/// scattered path finds the light instead.
template <class L>
CAROM_KERNEL ValueOf<L> density_for_weight(const WaveScene& scene, const VertexOf<L>& v,
                                           const LightSampleOf<L>& light, ValueOf<L> pdf) {
    if (!scene.has_far) {
        return pdf;
    }
    const Vec3Of<L> end = v.position + light.direction * light.distance;
    const Vec3Of<L> low = all_of<L>(scene.near_low);
    const Vec3Of<L> high = all_of<L>(scene.near_high);
    const auto in_x = L::both(L::is_less(low.x, end.x), L::is_less(end.x, high.x));
    const auto in_y = L::both(L::is_less(low.y, end.y), L::is_less(end.y, high.y));
    const auto in_z = L::both(L::is_less(low.z, end.z), L::is_less(end.z, high.z));
    const auto is_sky = L::is_less(L::all(kLeastFarDistance), light.distance);
    const auto is_found = L::either(L::both(in_x, L::both(in_y, in_z)), is_sky);
    return L::select(is_found, pdf, L::all(kDeltaPdf));
}

/// Writes the `k`th shadow ray of the vertices. `expected`: expected number of directions towards
/// the light at each vertex.
template <class L>
CAROM_KERNEL void add_shadow_rays(const WaveStep& step, const VertexOf<L>& v,
                                  const LightSampleOf<L>& light, ValueOf<L> expected,
                                  MaskOf<L> wanted, int k) {
    const auto zero = L::all(0);
    const auto cosine = dot(v.bsdf.frame.z, light.direction);
    const SideOf<L> side = side_of<L>(v.bsdf, light.direction, cosine);
    const auto above = L::larger(cosine, zero);
    const auto height = v.bsdf.any_transmits ? L::select(side.passes, cosine, above) : above;
    const Vec3Of<L> wi = local_direction<L>(v, light.direction, height);
    const auto pdf = light.pdf * expected;
    const auto emits = L::both(L::both(wanted, light.valid), L::either(side.is_above, side.passes));
    const auto weighed = density_for_weight<L>(step.scene, v, light, pdf);
    const Vec3Of<L> value = v.throughput *
                            weighted_value<L>(step.scene, v, wi, side.passes, weighed) *
                            light.radiance * (L::all(1) / pdf);
    const auto is_lit = L::both(emits, L::is_less(zero, largest<L>(value)));
    put_rays<L>(step.shadows, k, v.first, light, value, is_lit);
    if (step.scene.materials.transmits) {
        store<L>(origin_of_rays<L>(v, side.passes), step.shadows.ray_origin,
                 step.shadows.place(k, v.first));
    }
}

template <class L>
CAROM_KERNEL PlaceOf<L> place_of(const VertexOf<L>& v) {
    return {v.position, v.bsdf.frame.z, v.time};
}

template <class L>
CAROM_KERNEL ValueOf<L> environment_sample_count(const WaveStep& step, const VertexOf<L>& v) {
    if (!step.scene.has_environment) {
        return v.coat_samples;
    }
    auto total = L::all(0);
    for (const WaveLight& light : step.scene.lights) {
        total = total + importance_of<L>(step.scene, light, place_of<L>(v));
    }
    const auto fraction =
        L::all(step.scene.environment_importance) / (L::all(kFullSamplingFraction) * total);
    const auto expected = L::select(L::is_less(L::all(0), total),
                                    limited<L>(fraction, kMinEnvironmentSamples, 1), L::all(1));
    return L::select(v.shows_gloss, v.coat_samples, expected);
}

/// Samples the environment: sometimes, or several times where a rough coat shows it. Returns the
/// number of the next ray.
template <class L>
CAROM_KERNEL int sample_environment(const WaveStep& step, const VertexOf<L>& v, const Vec2Of<L>& u,
                                    int k) {
    const auto expected = v.environment_samples;
    const auto always = L::is_at_most(L::all(1), expected);
    const auto wanted = L::both(v.scatters, L::either(always, L::is_less(u.x, expected)));
    const auto rest = L::select(always, u.x, L::smaller(u.x / expected, L::all(kOneMinusEpsilon)));
    const int samples = step.vertices.has_gloss ? step.scene.glossy_samples : 1;
    for (int j = 0; j < samples; ++j, ++k) {
        if (j > 0 && L::none(v.shows_gloss)) {
            store<L>(L::all(0), step.shadows.t_max, step.shadows.place(k, v.first));
            continue;
        }
        Vec2Of<L> point{rest, u.y};
        if (v.any_gloss) {
            const Vec2Of<L> shifted = lattice_point<L>(u, j, samples);
            point = {L::select(v.shows_gloss, shifted.x, rest),
                     L::select(v.shows_gloss, shifted.y, u.y)};
        }
        const auto now = j == 0 ? wanted : v.shows_gloss;
        add_shadow_rays<L>(step, v, sample_sky<L>(step.scene, point), expected, now, k);
    }
    return k;
}

/// Samples every light, at a path's first vertex.
template <class L>
CAROM_KERNEL void sample_all_lights(const WaveStep& step, VertexOf<L>& v,
                                    const SamplerOf<L>& sampler) {
    v.environment_samples = environment_sample_count<L>(step, v);
    const PlaceOf<L> place = place_of<L>(v);
    ValueOf<L> pair[4];
    std::uint32_t asked = 0;
    int k = 0;
    for (int index = 0; index < step.scene.lights.count(); ++index) {
        const WaveLight& light = step.scene.lights[index];
        const SeenTreeOf<L> seen = see_light<L>(step.scene, light, place);
        if (light.samples > 1) {
            const auto samples = L::all(static_cast<float>(light.samples));
            ValueOf<L> x[4], y[4];
            for (int j = 0; j < light.samples; ++j) {
                if (j % 4 == 0) {
                    const auto block =
                        static_cast<std::uint32_t>(index + j / 4 * step.scene.lights.count());
                    sampler.get_2d_block(kLightBlockSets + block, x, y);
                }
                const LightSampleOf<L> found =
                    sample_entry<L>(step.scene, light, seen, place, {x[j % 4], y[j % 4]});
                add_shadow_rays<L>(step, v, found, samples, v.scatters, k++);
            }
            continue;
        }
        if (asked % 2 == 0) {
            sampler.get_4d(L::all_word(kLightPairSets + asked / 2), pair);
        }
        const std::uint32_t first = 2 * (asked % 2);
        const Vec2Of<L> u{pair[first], pair[first + 1]};
        asked += 1;
        if (light.is_environment()) {
            k = sample_environment<L>(step, v, u, k);
        } else {
            add_shadow_rays<L>(step, v, sample_entry<L>(step.scene, light, seen, place, u),
                               L::all(1), v.scatters, k++);
        }
    }
}

/// Samples one light, chosen by importance, at later vertices.
template <class L>
CAROM_KERNEL void sample_one_light(const WaveStep& step, VertexOf<L>& v, const Vec2Of<L>& u) {
    const LightChoiceOf<L> choice = choose_light<L>(step.scene, place_of<L>(v), u.x);
    v.total_importance = L::select(v.scatters, choice.total, L::all(0));
    const LightSampleOf<L> found =
        sample_choice<L>(step.scene, choice, v.scatters, place_of<L>(v), u.y);
    add_shadow_rays<L>(step, v, found, choice.probability, v.scatters, 0);
}
