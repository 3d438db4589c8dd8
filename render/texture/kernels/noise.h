// Reproducible noise from an integer hash, in lanes. Included as render/lanes/kernels/vectors.h is.

/// A well-mixed permutation of 32-bit integers (C. Wellons, "Prospecting for Hash Functions", 2018:
/// the two-round xorshift-multiply function of least bias, "lowbias32").
template <class L>
CAROM_KERNEL WordOf<L> mix_bits(WordOf<L> x) {
    x = x ^ L::template shifted_right<16>(x);
    x = x * L::all_word(0x7feb352du);
    x = x ^ L::template shifted_right<15>(x);
    x = x * L::all_word(0x846ca68bu);
    return x ^ L::template shifted_right<16>(x);
}

/// [0, 1)
template <class L>
CAROM_KERNEL ValueOf<L> unit_float(WordOf<L> bits) {
    return L::to_value(L::from_word(L::template shifted_right<8>(bits))) * L::all(0x1p-24f);
}

/// Weight of a pattern of the given period after averaging over `footprint` (same unit): 1 while
/// the period is well resolved, 0 from two periods per three footprints on.
template <class L>
CAROM_KERNEL ValueOf<L> band_weight(ValueOf<L> footprint, float period) {
    // 1 up to three footprints per period, 0 from one and a half on.
    const auto wide = L::all(1.5f) * footprint;
    const auto t = limited<L>((L::all(period) - wide) / (wide + L::all(1e-30f)), 0, 1);
    return t * t * (L::all(3) - L::all(2) * t);
}

/// The fraction of [x - width/2, x + width/2] above 0, smoothed: an anti-aliased step.
template <class L>
CAROM_KERNEL ValueOf<L> smooth_step(ValueOf<L> x, ValueOf<L> width) {
    const auto t = limited<L>(x / width + L::all(0.5f), 0, 1);
    return t * t * (L::all(3) - L::all(2) * t);
}

template <class L>
struct NoiseCellOf {
    WordOf<L> index;
    ValueOf<L> offset;  // [0, 1)
};

template <class L>
CAROM_KERNEL NoiseCellOf<L> noise_cell(ValueOf<L> x) {
    const auto floor = L::rounded_down(x);
    return {L::to_word(L::to_int(limited<L>(floor, -1073741824.0f, 1073741824.0f))), x - floor};
}

template <class L>
CAROM_KERNEL ValueOf<L> noise_fade(ValueOf<L> t) {
    return t * t * t * (t * (t * L::all(6) - L::all(15)) + L::all(10));
}

/// a where t is 0, b where it is 1.
template <class L>
CAROM_KERNEL ValueOf<L> between(ValueOf<L> a, ValueOf<L> b, ValueOf<L> t) {
    return a + (b - a) * t;
}

/// The dot product of `offset` with one of the twelve edge directions of a cube (four of them
/// twice, so that the four highest bits of the hash choose).
template <class L>
CAROM_KERNEL ValueOf<L> edge_gradient(WordOf<L> hash, const Vec3Of<L>& offset) {
    const auto zero = L::all_int(0);
    const auto bits = [&](std::uint32_t mask)
                          CAROM_KERNEL_ATTRIBUTE { return L::from_word(hash & L::all_word(mask)); };
    const auto is_upper = L::is_less_int(L::from_word(hash), zero);
    const auto is_lowest = L::is_equal_int(bits(0xc0000000u), zero);
    const auto is_repeated =
        L::is_equal_int(bits(0xd0000000u), L::all_int(static_cast<std::int32_t>(0xc0000000u)));
    const auto u = L::select(is_upper, offset.y, offset.x);
    const auto v = L::select(is_lowest, offset.y, L::select(is_repeated, offset.x, offset.z));
    const auto sign_u = L::from_bits(L::from_word(L::template shifted_left<3>(hash)));
    const auto sign_v = L::from_bits(L::from_word(L::template shifted_left<2>(hash)));
    return L::flip_sign(u, sign_u) + L::flip_sign(v, sign_v);
}

/// Gradient noise after Perlin, "Improving Noise", 2002 (quintic fade, eq. 1; gradients towards the
/// edges of a cube), on a lattice that is hashed instead of tabulated. Mean 0, range within [-1,
/// 1], one feature per unit length. Coordinates beyond +-2^30 repeat.
template <class L>
CAROM_KERNEL_OUTLINED ValueOf<L> gradient_noise(const Vec3Of<L>& position, std::uint32_t seed) {
    const NoiseCellOf<L> x = noise_cell<L>(position.x);
    const NoiseCellOf<L> y = noise_cell<L>(position.y);
    const NoiseCellOf<L> z = noise_cell<L>(position.z);
    const auto one = L::all(1);
    const auto next = L::all_word(1);
    const auto u = noise_fade<L>(x.offset);
    const auto along_x = [&](WordOf<L> hash, ValueOf<L> dy, ValueOf<L> dz) CAROM_KERNEL_ATTRIBUTE {
        const auto a = edge_gradient<L>(mix_bits<L>(x.index + hash), {x.offset, dy, dz});
        const auto b =
            edge_gradient<L>(mix_bits<L>(x.index + next + hash), {x.offset - one, dy, dz});
        return between<L>(a, b, u);
    };
    const auto v = noise_fade<L>(y.offset);
    const auto along_y = [&](WordOf<L> hash, ValueOf<L> dz) CAROM_KERNEL_ATTRIBUTE {
        const auto a = along_x(mix_bits<L>(y.index + hash), y.offset, dz);
        const auto b = along_x(mix_bits<L>(y.index + next + hash), y.offset - one, dz);
        return between<L>(a, b, v);
    };
    const auto seeds = L::all_word(seed);
    const auto a = along_y(mix_bits<L>(z.index + seeds), z.offset);
    const auto b = along_y(mix_bits<L>(z.index + next + seeds), z.offset - one);
    return limited<L>(between<L>(a, b, noise_fade<L>(z.offset)), -1, 1);
}

/// The seed of an octave of noise, the first being 0.
CAROM_KERNEL std::uint32_t octave_seed(std::uint32_t seed, int octave) {
    return seed + static_cast<std::uint32_t>(octave) * 0x9e3779b9u;
}

/// Sum of `octaves` gradient noises `noise(position, seed)`, each of twice the frequency and half
/// the amplitude of the previous one; the first has amplitude 1. Octaves finer than `footprint` (in
/// units of `position`) fade out, so that the sum is band-limited to what a pixel can show.
template <class L, class Vector, class Noise>
CAROM_KERNEL ValueOf<L> sum_octaves(Vector position, int octaves, ValueOf<L> footprint,
                                    std::uint32_t seed, const Noise& noise) {
    auto sum = L::all(0);
    float amplitude = 1;
    float period = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        const auto weight = band_weight<L>(footprint, period);
        const auto is_seen = L::is_less(L::all(0), weight);
        if (L::none(is_seen)) {
            break;
        }
        const auto part = weight * L::all(amplitude) * noise(position, octave_seed(seed, octave));
        sum = L::select(is_seen, sum + part, sum);
        position = position * L::all(2);
        amplitude *= 0.5f;
        period *= 0.5f;
    }
    return sum;
}

template <class L>
CAROM_KERNEL ValueOf<L> fractal_noise(const Vec3Of<L>& position, int octaves, ValueOf<L> footprint,
                                      std::uint32_t seed) {
    return sum_octaves<L>(position, octaves, footprint, seed,
                          [](const Vec3Of<L>& at, std::uint32_t salt)
                              CAROM_KERNEL_ATTRIBUTE { return gradient_noise<L>(at, salt); });
}
