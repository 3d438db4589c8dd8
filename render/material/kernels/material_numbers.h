// The numbers that describe materials, in lanes.
// Included as render/lanes/kernels/vectors.h is.

/// GlassConstants of the material in each lane.
template <class L>
struct GlassOf {
    ValueOf<L> ior, alpha;
    Vec3Of<L> tint;

    /// Calls `visit` with each number, always in the same order.
    template <class Glass, class Visit>
    CAROM_KERNEL static void each_number(Glass& glass, const Visit& visit) {
        visit(glass.ior);
        visit(glass.alpha);
        each_number_of(glass.tint, visit);
    }
};

/// PhongModel of the material in each lane, as far as path tracing needs it.
template <class L>
struct PhongOf {
    Vec3Of<L> specular, reflectance, transmittance;
    ValueOf<L> index;  // inside over outside
    ValueOf<L> highlight_exponent, mirrored_exponent, through_exponent;

    /// Calls `visit` with each number, always in the same order.
    template <class Phong, class Visit>
    CAROM_KERNEL static void each_number(Phong& phong, const Visit& visit) {
        each_number_of(phong.specular, visit);
        each_number_of(phong.reflectance, visit);
        each_number_of(phong.transmittance, visit);
        visit(phong.index);
        visit(phong.highlight_exponent);
        visit(phong.mirrored_exponent);
        visit(phong.through_exponent);
    }
};

/// The layers of the surface in each lane, without its base. From the top down: coat, sheen, then
/// metal or dielectric highlight over a diffuse base. Each layer takes from the layers below what
/// it scatters itself towards the viewer, so that no layering creates energy. A lobe whose alpha is
/// 0 is a smooth mirror.
template <class L>
struct LayersOf {
    ValueOf<L> coat_weight, coat_ior, coat_alpha;
    ValueOf<L> sheen;
    Vec3Of<L> sheen_colour;
    ValueOf<L> metal, specular, alpha;
    ValueOf<L> transmission;    // fraction of the base that is glass
    bool any_glass, any_phong;  // false: in no lane, and these numbers are not set
    GlassOf<L> glass;
    PhongOf<L> phong;
    MaskOf<L> is_phong;
    AlbedoNumbers tables;
    IntOf<L> first;  // of the material's numbers in each of the tables
    bool varies;     // false: the roughness is the material's everywhere, and these are not set
    TableSlicesOf<L> of_alpha, of_coat_alpha;  // tables for roughnesses around the surface's

    /// Calls `visit` with each number of the layers themselves, always in the same order.
    template <class Layers, class Visit>
    CAROM_KERNEL static void each_number(Layers& layers, const Visit& visit) {
        visit(layers.coat_weight);
        visit(layers.coat_ior);
        visit(layers.coat_alpha);
        visit(layers.sheen);
        each_number_of(layers.sheen_colour, visit);
        visit(layers.metal);
        visit(layers.specular);
        visit(layers.alpha);
        visit(layers.transmission);
    }

    /// Calls `visit` with each number that textures may give, in the order of TexturedNumber.
    template <class Layers, class Visit>
    CAROM_KERNEL static void each_textured(Layers& layers, const Visit& visit) {
        visit(layers.metal);
        visit(layers.alpha);
        visit(layers.specular);
        visit(layers.sheen);
        visit(layers.coat_weight);
        visit(layers.coat_alpha);
    }
};
