// The numbers that describe materials (LayerConstants, GlassConstants, PhongModel), in lanes.
// Included as render/lanes/kernels/vectors.h is.

/// GlassConstants of the material in each lane.
template <class L>
struct GlassOf {
    typename L::Value ior, alpha;
    Three<typename L::Value> tint;

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
    Three<typename L::Value> specular, reflectance, transmittance;
    typename L::Value index;  // inside over outside
    typename L::Value highlight_exponent, mirrored_exponent, through_exponent;

    /// Calls `visit` with each number, always in the same order.
    template <class Phong, class Visit>
    CAROM_KERNEL static void each_number(Phong& phong, const Visit& visit) {
        for (auto* colour : {&phong.specular, &phong.reflectance, &phong.transmittance}) {
            each_number_of(*colour, visit);
        }
        visit(phong.index);
        visit(phong.highlight_exponent);
        visit(phong.mirrored_exponent);
        visit(phong.through_exponent);
    }
};

/// LayerConstants of the material in each lane.
template <class L>
struct LayersOf {
    typename L::Value coat_weight, coat_ior, coat_alpha;
    typename L::Value sheen;
    Three<typename L::Value> sheen_colour;
    typename L::Value metal, specular, alpha;
    typename L::Value transmission;  // fraction of the base that is glass
    bool any_glass, any_phong;       // false: in no lane, and these numbers are not set
    GlassOf<L> glass;
    PhongOf<L> phong;
    typename L::Mask is_phong;
    AlbedoNumbers tables;
    typename L::Int first;  // of the material's numbers in each of the tables

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
};
