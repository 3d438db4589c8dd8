// Hashes and scrambled numbers of the sampler (sampler.h) in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// Finaliser of MurmurHash3 (Appleby 2011).
template <class L>
CAROM_KERNEL WordOf<L> hashed(WordOf<L> x) {
    x = x ^ L::template shifted_right<16>(x);
    x = x * L::all_word(0x85ebca6bu);
    x = x ^ L::template shifted_right<13>(x);
    x = x * L::all_word(0xc2b2ae35u);
    return x ^ L::template shifted_right<16>(x);
}

/// Nested uniform (Owen) scrambling in base 2 of a number whose bits are reversed: each bit is
/// flipped depending on `seed` and the bits below it. The form is Laine and Karras 2011,
/// "Stratified sampling for stochastic transparency", section 3.1; constants and order of steps
/// are Vegdahl 2021, "Building a better LK hash", which mixes the first bits more thoroughly.
template <class L>
CAROM_KERNEL WordOf<L> scramble_reversed(WordOf<L> x, WordOf<L> seed) {
    x = x ^ (x * L::all_word(0x3d20adeau));
    x = x + seed;
    x = x * (L::template shifted_right<16>(seed) | L::all_word(1));
    x = x ^ (x * L::all_word(0x05526c56u));
    return x ^ (x * L::all_word(0x53a22864u));
}

/// The 24 highest bits, so that the result is below 1.
template <class L>
CAROM_KERNEL ValueOf<L> in_unit_interval(WordOf<L> x) {
    return L::to_value(L::from_word(L::template shifted_right<8>(x))) * L::all(0x1p-24f);
}

/// What the numbers of a pixel's set are made from.
template <class L>
CAROM_KERNEL WordOf<L> hash_of_set(WordOf<L> pixel_hash, WordOf<L> set) {
    return hashed<L>(pixel_hash ^ hashed<L>(set));
}

/// The sample's place in the order of the set, which is another one for each set; both with their
/// bits reversed.
template <class L>
CAROM_KERNEL WordOf<L> shuffled_index(WordOf<L> reversed_sample, WordOf<L> set_hash) {
    return scramble_reversed<L>(reversed_sample, hashed<L>(set_hash + L::all_word(0x9e3779b9u)));
}

/// By which a dimension of a set is scrambled. `salt`: the dimension's (sobol_tables.h).
template <class L>
CAROM_KERNEL WordOf<L> seed_of_dimension(WordOf<L> set_hash, WordOf<L> salt) {
    return hashed<L>(set_hash + salt);
}

/// The scrambled coordinate; `reversed`: a coordinate of a Sobol point with its bits reversed.
template <class L>
CAROM_KERNEL ValueOf<L> scrambled_coordinate(WordOf<L> reversed, WordOf<L> seed) {
    return in_unit_interval<L>(L::reversed_bits(scramble_reversed<L>(reversed, seed)));
}

/// See SampleStream::get_1d.
template <class L>
CAROM_KERNEL ValueOf<L> independent_number(WordOf<L> set_hash, WordOf<L> reversed_sample) {
    return in_unit_interval<L>(hashed<L>(set_hash ^ reversed_sample));
}
