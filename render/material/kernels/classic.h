// The shading model of distributed ray tracing (phong.h), in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// PhongModel of the material in each lane, and its emission.
template <class L>
struct ClassicOf {
    Vec3Of<L> emission, ambient;
    ValueOf<L> has_ambient, diffuse_fraction;
    Vec3Of<L> specular;
    ValueOf<L> shininess;
    Vec3Of<L> reflectance;
    ValueOf<L> metal;
    Vec3Of<L> transmittance;
    ValueOf<L> index;
    // Of reflection and transmission: standard deviation of the angle, and
    // gaussian_within_a_quarter_turn of it.
    ValueOf<L> reflectance_spread, reflectance_most;
    ValueOf<L> transmittance_spread, transmittance_most;

    /// Calls `visit` with each number, always in the same order.
    template <class Classic, class Visit>
    CAROM_KERNEL static void each_number(Classic& model, const Visit& visit) {
        each_number_of(model.emission, visit);
        each_number_of(model.ambient, visit);
        each_number_of(model.specular, visit);
        each_number_of(model.reflectance, visit);
        each_number_of(model.transmittance, visit);
        visit(model.has_ambient);
        visit(model.diffuse_fraction);
        visit(model.shininess);
        visit(model.metal);
        visit(model.index);
        visit(model.reflectance_spread);
        visit(model.reflectance_most);
        visit(model.transmittance_spread);
        visit(model.transmittance_most);
    }

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> diffuse_colour(const Vec3Of<L>& base) const {
        return base * diffuse_fraction;
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> ambient_colour(const Vec3Of<L>& base) const {
        return select<L>(L::is_less(L::all(0), has_ambient), ambient, diffuse_colour(base));
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> reflectance_colour(const Vec3Of<L>& base) const {
        return reflectance + base * metal;
    }
};

/// The part of the irradiance over pi that goes from the unit direction `wi` to `wo`; world axes.
template <class L>
CAROM_KERNEL Vec3Of<L> classic_towards(const ClassicOf<L>& model, const Vec3Of<L>& base,
                                       const Vec3Of<L>& normal, const Vec3Of<L>& wo,
                                       const Vec3Of<L>& wi) {
    const auto zero = L::all(0);
    Vec3Of<L> sum = model.diffuse_colour(base) * dot(normal, wi);
    const auto highlight = dot(reflect<L>(wi, normal), wo);
    const auto shines =
        L::both(L::is_less(zero, highlight), L::is_less(zero, largest<L>(model.specular)));
    if (!L::none(shines)) {
        const auto height =
            power_of<L>(L::select(shines, highlight, zero), L::larger(model.shininess, L::all(0)));
        sum = sum + model.specular * L::select(shines, height, zero);
    }
    return sum;
}

/// Rays of one kind that leave a surface around one direction.
template <class L>
struct ClassicLobeOf {
    Vec3Of<L> axis;    // unit, world
    Vec3Of<L> colour;  // factor on the light that they bring
};

/// Reflection, and refraction by Snell's law: at total reflection what would pass is reflected.
/// `wo`: towards the viewer, world, as are both normals, which are on the viewer's side.
template <class L>
struct ClassicLobesOf {
    ClassicLobeOf<L> reflection, refraction;
};

/// `refracts`: whether refracted rays are sent at all.
template <class L>
CAROM_KERNEL ClassicLobesOf<L> classic_lobes(const ClassicOf<L>& model, const Vec3Of<L>& base,
                                             const Vec3Of<L>& geometric_normal,
                                             const Vec3Of<L>& normal, const Vec3Of<L>& wo,
                                             MaskOf<L> from_behind, bool refracts) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const Vec3<V> black{zero, zero, zero};
    ClassicLobesOf<L> lobes;
    lobes.reflection = {reflect<L>(wo, normal), model.reflectance_colour(base)};
    lobes.refraction = {Vec3<V>{zero, zero, zero} - wo, black};
    if (refracts) {
        const V eta = L::select(from_behind, model.index, one / model.index);
        const V cosine = dot(normal, wo);
        const V cosine2 = one - eta * eta * (one - cosine * cosine);
        const auto passes = L::is_less(zero, cosine2);
        const Vec3<V> bent = normal * (eta * cosine - L::root(L::larger(cosine2, zero))) - wo * eta;
        lobes.refraction.axis = select<L>(passes, unit<L>(bent), lobes.refraction.axis);
        lobes.refraction.colour = select<L>(passes, model.transmittance, black);
        lobes.reflection.colour =
            lobes.reflection.colour + select<L>(passes, black, model.transmittance);
    }
    // A bump-mapped normal may reflect or refract to the wrong side; the geometric normal does not.
    const auto stays = L::is_at_most(dot(lobes.reflection.axis, geometric_normal), zero);
    lobes.reflection.axis =
        select<L>(stays, reflect<L>(wo, geometric_normal), lobes.reflection.axis);
    const auto returns = L::is_at_most(zero, dot(lobes.refraction.axis, geometric_normal));
    lobes.refraction.axis = select<L>(returns, black - wo, lobes.refraction.axis);
    return lobes;
}
