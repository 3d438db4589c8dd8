// Look-ups of mip_pyramid.h in lanes, which may read different levels. Included as
// render/lanes/kernels/vectors.h is.

/// The value of the half float (IEEE 754-2008, binary16) in the lower 16 bits; the others are
/// ignored. By integers and normal numbers alone, so that the mode in which denormal numbers count
/// as 0 does not matter.
template <class L>
CAROM_KERNEL typename L::Value half_value(typename L::Word bits) {
    const auto magnitude = bits & L::all_word(0x7fffu);
    // The exponent is shifted by 224 instead of by 127 - 15 = 112: infinity becomes infinity, and
    // the product removes the rest.
    const auto raised = L::template shifted_left<13>(magnitude) + L::all_word(224u << 23);
    const auto normal = L::from_bits(L::from_word(raised)) * L::all(0x1p-112f);
    const auto denormal = L::to_value(L::from_word(magnitude)) * L::all(0x1p-24f);
    const auto is_denormal = L::is_less_int(L::from_word(magnitude), L::all_int(0x400));
    const auto sign = L::from_bits(L::from_word(L::template shifted_left<16>(bits)));
    return L::flip_sign(L::select(is_denormal, denormal, normal), sign);
}

/// HalfColourCodec's texel, two words long.
template <class L>
CAROM_KERNEL Three<typename L::Value> half_colour(typename L::Word first, typename L::Word second) {
    return {half_value<L>(first), half_value<L>(L::template shifted_right<16>(first)),
            half_value<L>(second)};
}

/// SignedCodec's texel in the lower 16 bits.
template <class L>
CAROM_KERNEL typename L::Value signed_value(typename L::Word bits) {
    const auto raised = L::from_word(L::template shifted_left<16>(bits));
    return L::to_value(L::template shifted_right_int<16>(raised)) * L::all(1.0f / 32767.0f);
}

/// CoverageCodec's texel in the lower 8 bits.
template <class L>
CAROM_KERNEL typename L::Value coverage_value(typename L::Word bits) {
    return L::to_value(L::from_word(bits & L::all_word(0xffu))) * L::all(1.0f / 255.0f);
}

template <class L>
struct TexelPlaceOf {
    typename L::Int upper, lower;  // indices of the left texels of two rows
    typename L::Value fx, fy;      // weights of the right texels and of the lower row
};

/// The four texels around `uv` on the finest level whose texels are at least half as large as the
/// footprint, in units of uv of the longer side. Any number is safe.
template <class L>
CAROM_KERNEL TexelPlaceOf<L> texel_place(const PyramidTables& pyramid,
                                         const Two<typename L::Value>& uv,
                                         typename L::Value footprint) {
    const auto texels = limited<L>(footprint * L::all(pyramid.longest_side), 1, 1e9f);
    const auto exponent = L::template shifted_right_int<23>(L::bits_of(texels)) - L::all_int(127);
    const auto level = L::smaller_int(exponent, L::all_int(pyramid.level_count - 1));
    const auto width = L::gather_int(pyramid.width, level);
    const auto height = L::gather_int(pyramid.height, level);
    // Removes repeats first, so that far coordinates keep their precision.
    const auto tile = [&](typename L::Value x) CAROM_KERNEL_ATTRIBUTE {
        return limited<L>(pyramid.repeats ? x - L::rounded_down(x) : x, 0, 1);
    };
    const auto x = tile(uv.x) * L::to_value(width) - L::all(0.5f);
    const auto y = tile(uv.y) * L::to_value(height) - L::all(0.5f);
    const auto floor_x = L::rounded_down(x);
    const auto floor_y = L::rounded_down(y);
    const auto stride = width + L::all_int(2);
    const auto upper =
        L::gather_int(pyramid.first, level) + L::to_int(floor_y) * stride + L::to_int(floor_x);
    return {upper, upper + stride, x - floor_x, y - floor_y};
}

/// T: a number or a vector in lanes.
template <class L, class T>
CAROM_KERNEL T bilinear(const T& upper_left, const T& upper_right, const T& lower_left,
                        const T& lower_right, const TexelPlaceOf<L>& place) {
    const auto left = L::all(1) - place.fx;
    const T upper = upper_left * left + upper_right * place.fx;
    const T lower = lower_left * left + lower_right * place.fx;
    return upper * (L::all(1) - place.fy) + lower * place.fy;
}

/// See MipPyramid::lookup.
template <class L>
CAROM_KERNEL Three<typename L::Value> look_up_half_colour(const PyramidTables& pyramid,
                                                          const Two<typename L::Value>& uv,
                                                          typename L::Value footprint) {
    const TexelPlaceOf<L> place = texel_place<L>(pyramid, uv, footprint);
    const auto texel = [&](typename L::Int index) CAROM_KERNEL_ATTRIBUTE {
        const auto twofold = index + index;
        const auto fourfold = twofold + twofold;
        const auto words = L::gather_bytes_pair(pyramid.texels, fourfold + fourfold);
        return half_colour<L>(words.first, words.second);
    };
    const auto one = L::all_int(1);
    return bilinear<L, Three<typename L::Value>>(texel(place.upper), texel(place.upper + one),
                                                 texel(place.lower), texel(place.lower + one),
                                                 place);
}

/// See MipPyramid::lookup. Both texels of a row are in one word.
template <class L>
CAROM_KERNEL typename L::Value look_up_signed(const PyramidTables& pyramid,
                                              const Two<typename L::Value>& uv,
                                              typename L::Value footprint) {
    const TexelPlaceOf<L> place = texel_place<L>(pyramid, uv, footprint);
    const auto upper = L::gather_bytes(pyramid.texels, place.upper + place.upper);
    const auto lower = L::gather_bytes(pyramid.texels, place.lower + place.lower);
    return bilinear<L, typename L::Value>(
        signed_value<L>(upper), signed_value<L>(L::template shifted_right<16>(upper)),
        signed_value<L>(lower), signed_value<L>(L::template shifted_right<16>(lower)), place);
}

/// See MipPyramid::lookup. Both texels of a row are in one word.
template <class L>
CAROM_KERNEL typename L::Value look_up_coverage(const PyramidTables& pyramid,
                                                const Two<typename L::Value>& uv,
                                                typename L::Value footprint) {
    const TexelPlaceOf<L> place = texel_place<L>(pyramid, uv, footprint);
    const auto upper = L::gather_bytes(pyramid.texels, place.upper);
    const auto lower = L::gather_bytes(pyramid.texels, place.lower);
    return bilinear<L, typename L::Value>(
        coverage_value<L>(upper), coverage_value<L>(L::template shifted_right<8>(upper)),
        coverage_value<L>(lower), coverage_value<L>(L::template shifted_right<8>(lower)), place);
}
