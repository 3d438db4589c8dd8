// The picture of an environment, in lanes. Included as render/lanes/kernels/vectors.h is.

/// (u, v) in the picture, v = 0 at the top. The middle column is the direction +x; columns to its
/// right turn towards -y, as seen from the middle of the scene.
template <class L>
CAROM_KERNEL Vec2Of<L> environment_uv(const EnvironmentPicture& picture,
                                      const Vec3Of<L>& direction) {
    const auto u =
        L::all(0.5f + picture.turns) - quick_angle<L>(direction.x, direction.y) * L::all(1 / kTurn);
    const auto polar = quick_arccosine<L>(limited<L>(direction.z, -1, 1));
    return {u - L::rounded_down(u), L::smaller(polar * L::all(kInversePi), L::all(1))};
}

/// The bilinear picture.
template <class L>
CAROM_KERNEL Vec3Of<L> environment_radiance(const EnvironmentPicture& picture,
                                            const Vec2Of<L>& uv) {
    const auto x = uv.x * L::all(static_cast<float>(picture.width)) - L::all(0.5f);
    const auto y = uv.y * L::all(static_cast<float>(picture.height)) - L::all(0.5f);
    // uv may be 1 for a direction straight down or by rounding at the seam.
    const auto x0 = L::smaller_int(L::to_int(L::rounded_down(x)), L::all_int(picture.width - 1));
    const auto y0 = L::smaller_int(L::to_int(L::rounded_down(y)), L::all_int(picture.height - 1));
    const auto fx = x - L::to_value(x0);
    const auto fy = y - L::to_value(y0);
    const int stride = picture.width + 2;
    const auto first = L::product(y0, stride) + x0;
    const auto row = [&](int offset) CAROM_KERNEL_ATTRIBUTE {
        const auto index = first + L::all_int(offset);
        return L::gather_bytes_pair(picture.padded.data(), index + index + index + index);
    };
    const auto mix = [](const Vec3Of<L>& a, const Vec3Of<L>& b, ValueOf<L> t)
                         CAROM_KERNEL_ATTRIBUTE { return a * (L::all(1) - t) + b * t; };
    const auto mix_pixels = [&](const typename L::WordPair& pixels) CAROM_KERNEL_ATTRIBUTE {
        return mix(shared_exponent_value<L>(pixels.first), shared_exponent_value<L>(pixels.second),
                   fx);
    };
    const auto top = mix_pixels(row(stride + 1));
    const auto bottom = mix_pixels(row(2 * stride + 1));
    return mix(top, bottom, fy) * all_of<L>(picture.scale);
}

/// Density of `sample_environment_map` for a direction, `uv` being its place, 1/sr.
template <class L>
CAROM_KERNEL ValueOf<L> environment_pdf(const EnvironmentPicture& picture,
                                        const Vec3Of<L>& direction, const Vec2Of<L>& uv) {
    const auto sine = L::root(direction.x * direction.x + direction.y * direction.y);
    const auto exists = L::is_less(L::all(0), sine);
    const auto density = pdf_piecewise_constant<L>(picture.distribution, uv) /
                         (L::all(kTurn * kPi) * L::select(exists, sine, L::all(1)));
    return L::select(exists, density, L::all(0));
}

template <class L>
struct EnvironmentSampleOf {
    Vec3Of<L> direction;
    ValueOf<L> pdf;  // 1/sr
    Vec2Of<L> uv;
    MaskOf<L> valid;
};

/// A direction in proportion to brightness and solid angle.
template <class L>
CAROM_KERNEL EnvironmentSampleOf<L> sample_environment_map(const EnvironmentPicture& picture,
                                                           const Vec2Of<L>& u) {
    const UvSampleOf<L> place = sample_piecewise_constant<L>(picture.distribution, u);
    const SinCosOf<L> polar = sin_cos_turn<L>(L::all(0.5f) * place.uv.y);
    const SinCosOf<L> azimuth = sin_cos_turn<L>(L::all(0.5f + picture.turns) - place.uv.x);
    const auto zero = L::all(0);
    const auto valid = L::both(L::is_less(zero, place.pdf), L::is_less(zero, polar.sine));
    const Vec3Of<L> direction{polar.sine * azimuth.cosine, polar.sine * azimuth.sine, polar.cosine};
    const auto sine = L::select(valid, polar.sine, L::all(1));
    return {unit<L>(direction), place.pdf / (L::all(kTurn * kPi) * sine), place.uv, valid};
}
