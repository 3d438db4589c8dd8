// Vertices of a wave, and the BSDF of their surfaces, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// Surface, path, and sampling decisions.
template <class L>
struct VertexOf {
    int first;  // of the vertices
    MaskOf<L> valid;
    IntOf<L> path;
    Vec3Of<L> position, origin;
    ValueOf<L> time;
    Vec3Of<L> throughput;
    BsdfOf<L> bsdf;
    MaskOf<L> scatters;       // has a lobe that is not specular
    MaskOf<L> splits;         // the coat and the base are followed separately
    MaskOf<L> shows_gloss;    // the coat is sampled several times
    bool any_gloss;           // false: it is not in any lane
    ValueOf<L> coat_samples;  // number of directions of the coat
    MaskOf<L> connects;       // caustics may be sampled
    WordOf<L> vertex_index;
    ValueOf<L> total_importance, environment_samples;
};

/// Sets the numbers of a material. `number_in` returns each lane's number of a row.
template <class L, class NumberIn, class Numbers>
CAROM_KERNEL void set_numbers(const NumberRows& rows, const NumberIn& number_in, Numbers& numbers) {
    int row = 0;
    Numbers::each_number(numbers, [&](ValueOf<L>& number) CAROM_KERNEL_ATTRIBUTE {
        number = number_in(rows.row(row++));
    });
}

template <class L, class NumberIn>
CAROM_KERNEL void set_constants(const WaveMaterials& materials, const NumberIn& number_in,
                                LayersOf<L>& layers) {
    set_numbers<L>(materials.layers, number_in, layers);
    const auto is_glass = L::is_less(L::all(0), layers.transmission);
    layers.any_glass = materials.glass.numbers.exists() && !L::none(is_glass);
    if (layers.any_glass) {
        set_numbers<L>(materials.glass, number_in, layers.glass);
    }
    layers.is_phong = L::first_lanes(0);
    if (materials.phong.numbers.exists()) {
        layers.is_phong = L::is_less(L::all(0), number_in(materials.is_phong.data()));
    }
    layers.any_phong = !L::none(layers.is_phong);
    if (layers.any_phong) {
        set_numbers<L>(materials.phong, number_in, layers.phong);
    }
    layers.tables = AlbedoNumbers::in_rows(materials.albedos.row(0), materials.albedos.count);
    layers.varies = false;
}

/// Vertices are sorted, so that mostly all lanes have the same material.
template <class L>
CAROM_KERNEL void set_layers(const WaveMaterials& materials, IntOf<L> material,
                             LayersOf<L>& layers) {
    const std::int32_t first = L::first_of(material);
    if (L::none(L::opposite(L::is_equal_int(material, L::all_int(first))))) {
        const auto of_all = [&](const float* row)
                                CAROM_KERNEL_ATTRIBUTE { return L::all(row[first]); };
        set_constants<L>(materials, of_all, layers);
        layers.first = L::all_int(materials.first_albedo[first]);
    } else {
        const auto of_each = [&](const float* row)
                                 CAROM_KERNEL_ATTRIBUTE { return L::gather(row, material); };
        set_constants<L>(materials, of_each, layers);
        layers.first = L::gather_int(materials.first_albedo.data(), material);
    }
}

/// The layers of the surfaces at vertices from `first` on.
template <class L>
CAROM_KERNEL void set_layers(const WaveMaterials& materials, const SurfaceQueue& vertices,
                             int first, IntOf<L> material, LayersOf<L>& layers) {
    set_layers<L>(materials, material, layers);
    if (!materials.varies) {
        return;
    }
    const Floats* numbers = vertices.numbers;
    LayersOf<L>::each_textured(layers, [&](ValueOf<L>& number) CAROM_KERNEL_ATTRIBUTE {
        number = load<L>(*numbers++, first);
    });
    const auto slices = L::gather(materials.slices.data(), material);
    layers.varies = true;
    layers.of_alpha = table_slices<L>(layers.first, slices, layers.alpha);
    layers.of_coat_alpha = table_slices<L>(layers.first, slices, layers.coat_alpha);
}

/// Sets which lobes there are, and how they are followed.
template <class L>
CAROM_KERNEL void decide(const WaveStep& step, VertexOf<L>& v) {
    const LobeKindsOf<L> kinds = kinds_of_lobes<L>(v.bsdf);
    v.scatters = L::both(kinds.scatters(), v.valid);
    v.connects = L::without(v.scatters, L::either(kinds.is_narrow, v.bsdf.transmits));
    const auto has_coat = L::both(v.valid, L::is_less(L::all(0), v.bsdf.lobes.coat));
    const SplittingOf<L> splitting =
        splitting_at<L>(step.paths.vertex, step.scene.split_vertices, step.scene.glossy_samples,
                        has_coat, v.bsdf.lobes.has_rough_coat);
    v.splits = splitting.splits;
    v.shows_gloss = splitting.shows_gloss;
    v.any_gloss = splitting.any_gloss;
    v.coat_samples =
        L::select(v.shows_gloss, L::all(static_cast<float>(step.scene.glossy_samples)), L::all(1));
}

/// The materials of vertices from `first` on; lanes beyond the last vertex have that of the first
/// one.
template <class L>
CAROM_KERNEL IntOf<L> materials_of(const SurfaceQueue& vertices, int first, MaskOf<L> valid) {
    const auto known = load<L>(vertices.material, first);
    return L::select_int(valid, known, L::all_int(L::first_of(known)));
}

template <class L>
CAROM_KERNEL MaskOf<L> is_set(IntOf<L> word) {
    return L::opposite(L::is_equal_int(word, L::all_int(0)));
}

template <class L>
CAROM_KERNEL VertexOf<L> vertex_at(const WaveStep& step, int first) {
    const SurfaceQueue& in = step.vertices;
    VertexOf<L> v;
    v.first = first;
    v.valid = L::first_lanes(in.count - first);
    v.path = load<L>(in.path, first);
    v.position = load<L>(in.position, first);
    const Vec3Of<L> geometric_normal = load<L>(in.geometric_normal, first);
    v.origin = v.position + geometric_normal * load<L>(in.offset, first);
    v.time = gather<L>(step.paths.time, v.path);
    v.throughput = gather<L>(step.paths.throughput, v.path);
    auto from_behind = L::first_lanes(0);
    if (step.scene.materials.transmits) {
        from_behind = L::both(is_set<L>(load<L>(in.from_behind, first)), v.valid);
    }
    set_layers<L>(step.scene.materials, in, first, materials_of<L>(in, first, v.valid),
                  v.bsdf.layers);
    const Vec3Of<L> direction = gather<L>(step.paths.direction, v.path);
    complete<L>(v.bsdf, load<L>(in.base, first), geometric_normal, load<L>(in.normal, first),
                opposite<L>(direction), from_behind);
    if (in.some_end) {
        v.valid = L::without(v.valid, is_set<L>(load<L>(in.ends, first)));
    }
    decide<L>(step, v);
    v.vertex_index = vertex_index_of<L>(step.paths, v.path);
    v.total_importance = L::all(0);
    v.environment_samples = gather<L>(step.paths.environment_samples, v.path);
    return v;
}

/// Where rays in a direction start: beyond the surface in the lanes that pass through it.
template <class L>
CAROM_KERNEL Vec3Of<L> origin_of_rays(const VertexOf<L>& v, MaskOf<L> passes) {
    if (!v.bsdf.any_transmits) {
        return v.origin;
    }
    return select<L>(passes, v.position * L::all(2) - v.origin, v.origin);
}

/// `wi` in the axes of the vertex' frame; only its height if that suffices for the lobes.
template <class L>
CAROM_KERNEL Vec3Of<L> local_direction(const VertexOf<L>& v, const Vec3Of<L>& wi,
                                       ValueOf<L> height) {
    if (v.bsdf.any_glossy()) {
        return {dot(wi, v.bsdf.frame.x), dot(wi, v.bsdf.frame.y), height};
    }
    return {L::all(0), L::all(0), height};
}
