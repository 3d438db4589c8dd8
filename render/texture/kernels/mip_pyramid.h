// Look-ups of mip_pyramid.h in lanes, which may read different levels. Included as
// render/lanes/kernels/vectors.h is.

/// The value of the half float (IEEE 754-2008, binary16) in the lower 16 bits; the others are
/// ignored. By integers and normal numbers alone, so that the mode in which denormal numbers count
/// as 0 does not matter.
template <class L>
CAROM_KERNEL ValueOf<L> half_value(WordOf<L> bits) {
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
CAROM_KERNEL Vec3Of<L> half_colour(WordOf<L> first, WordOf<L> second) {
    return {half_value<L>(first), half_value<L>(L::template shifted_right<16>(first)),
            half_value<L>(second)};
}

/// SignedCodec's texel in the lower 16 bits.
template <class L>
CAROM_KERNEL ValueOf<L> signed_value(WordOf<L> bits) {
    const auto raised = L::from_word(L::template shifted_left<16>(bits));
    return L::to_value(L::template shifted_right_int<16>(raised)) * L::all(1.0f / 32767.0f);
}

/// CoverageCodec's texel in the lower 8 bits.
template <class L>
CAROM_KERNEL ValueOf<L> coverage_value(WordOf<L> bits) {
    return L::to_value(L::from_word(bits & L::all_word(0xffu))) * L::all(1.0f / 255.0f);
}

template <class L>
struct TexelPlaceOf {
    IntOf<L> upper, lower;  // indices of the left texels of two rows
    ValueOf<L> fx, fy;      // weights of the right texels and of the lower row
};

/// Where a coordinate lies in a picture that repeats, so that far ones keep their precision.
template <class L>
CAROM_KERNEL ValueOf<L> repeated_part(ValueOf<L> x) {
    return limited<L>(x - L::rounded_down(x), 0, 1);
}

/// The four texels around `uv` on the finest level whose texels are at least half as large as the
/// footprint, in units of uv of the longer side. Any number is safe.
template <class L>
CAROM_KERNEL TexelPlaceOf<L> texel_place(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                         ValueOf<L> footprint) {
    const auto texels = limited<L>(footprint * L::all(pyramid.longest_side), 1, 1e9f);
    const auto exponent = L::template shifted_right_int<23>(L::bits_of(texels)) - L::all_int(127);
    const auto level = L::smaller_int(exponent, L::all_int(pyramid.first.count() - 1));
    const auto width = L::gather_int(pyramid.width.data(), level);
    const auto height = L::gather_int(pyramid.height.data(), level);
    const auto tile = [&](ValueOf<L> x) CAROM_KERNEL_ATTRIBUTE {
        return pyramid.repeats ? repeated_part<L>(x) : limited<L>(x, 0, 1);
    };
    const auto x = tile(uv.x) * L::to_value(width) - L::all(0.5f);
    const auto y = tile(uv.y) * L::to_value(height) - L::all(0.5f);
    const auto floor_x = L::rounded_down(x);
    const auto floor_y = L::rounded_down(y);
    const auto stride = width + L::all_int(2);
    const auto upper = L::gather_int(pyramid.first.data(), level) + L::to_int(floor_y) * stride +
                       L::to_int(floor_x);
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

/// The value at `uv`, v = 0 at the top, averaged over about `footprint` (in the same unit, of the
/// larger side), from the finest level whose texels are at least half as large.
template <class L>
CAROM_KERNEL Vec3Of<L> look_up_half_colour(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                           ValueOf<L> footprint) {
    const TexelPlaceOf<L> place = texel_place<L>(pyramid, uv, footprint);
    const auto texel = [&](IntOf<L> index) CAROM_KERNEL_ATTRIBUTE {
        const auto twofold = index + index;
        const auto fourfold = twofold + twofold;
        const auto words = L::gather_bytes_pair(pyramid.texels.data(), fourfold + fourfold);
        return half_colour<L>(words.first, words.second);
    };
    const auto one = L::all_int(1);
    return bilinear<L, Vec3Of<L>>(texel(place.upper), texel(place.upper + one), texel(place.lower),
                                  texel(place.lower + one), place);
}

/// Likewise of numbers of kBits: both texels of a row are in one word. `decoded`:
/// the value of a texel in a word's lower bits.
template <class L, int kBits, class Decode>
CAROM_KERNEL ValueOf<L> look_up_number(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                       ValueOf<L> footprint, const Decode& decoded) {
    const TexelPlaceOf<L> place = texel_place<L>(pyramid, uv, footprint);
    const auto words = [&](IntOf<L> index) CAROM_KERNEL_ATTRIBUTE {
        return L::gather_bytes(pyramid.texels.data(), L::product(index, kBits / 8));
    };
    const auto upper = words(place.upper);
    const auto lower = words(place.lower);
    return bilinear<L, ValueOf<L>>(decoded(upper), decoded(L::template shifted_right<kBits>(upper)),
                                   decoded(lower), decoded(L::template shifted_right<kBits>(lower)),
                                   place);
}

template <class L>
CAROM_KERNEL ValueOf<L> look_up_signed(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                       ValueOf<L> footprint) {
    return look_up_number<L, 16>(pyramid, uv, footprint, [](WordOf<L> word) CAROM_KERNEL_ATTRIBUTE {
        return signed_value<L>(word);
    });
}

template <class L>
CAROM_KERNEL ValueOf<L> look_up_coverage(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                         ValueOf<L> footprint) {
    return look_up_number<L, 8>(pyramid, uv, footprint, [](WordOf<L> word) CAROM_KERNEL_ATTRIBUTE {
        return coverage_value<L>(word);
    });
}

template <class L>
CAROM_KERNEL ValueOf<L> look_up_half(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                     ValueOf<L> footprint) {
    return look_up_number<L, 16>(pyramid, uv, footprint, [](WordOf<L> word) CAROM_KERNEL_ATTRIBUTE {
        return half_value<L>(word);
    });
}

/// The value of a texel of the finest level.
template <class L>
CAROM_KERNEL Vec3Of<L> coded_texel(const ImageTables& picture, IntOf<L> index) {
    const auto value = [&](WordOf<L> code) CAROM_KERNEL_ATTRIBUTE {
        return L::gather(picture.values.data(), L::from_word(code));
    };
    const auto first_code = L::product(index, picture.is_grey ? 1 : 3);
    if (picture.is_grey) {
        const auto word = L::gather_bytes(
            picture.codes.data(), picture.has_16_bits ? first_code + first_code : first_code);
        const auto grey = value(word & L::all_word(picture.has_16_bits ? 0xffffu : 0xffu));
        return {grey, grey, grey};
    }
    if (picture.has_16_bits) {
        const auto words = L::gather_bytes_pair(picture.codes.data(), first_code + first_code);
        const auto mask = L::all_word(0xffffu);
        return {value(words.first & mask), value(L::template shifted_right<16>(words.first)),
                value(words.second & mask)};
    }
    const auto word = L::gather_bytes(picture.codes.data(), first_code);
    const auto mask = L::all_word(0xffu);
    return {value(word & mask), value(L::template shifted_right<8>(word) & mask),
            value(L::template shifted_right<16>(word) & mask)};
}

/// The finest level around `uv`.
template <class L>
CAROM_KERNEL Vec3Of<L> look_up_coded(const ImageTables& picture, const Vec2Of<L>& uv) {
    const auto width = L::all_int(picture.width);
    const auto height = L::all_int(picture.height);
    const auto one = L::all_int(1);
    const auto zero = L::all_int(0);
    const auto x = repeated_part<L>(uv.x) * L::to_value(width) - L::all(0.5f);
    const auto y = repeated_part<L>(uv.y) * L::to_value(height) - L::all(0.5f);
    const auto floor_x = L::rounded_down(x);
    const auto floor_y = L::rounded_down(y);
    // From -1 to one less than the size.
    const auto left = L::to_int(floor_x);
    const auto upper = L::to_int(floor_y);
    const auto before = [&](IntOf<L> i, IntOf<L> size) CAROM_KERNEL_ATTRIBUTE {
        return L::select_int(L::is_less_int(i, zero), size - one, i);
    };
    const auto behind = [&](IntOf<L> i, IntOf<L> size) CAROM_KERNEL_ATTRIBUTE {
        return L::select_int(L::is_less_int(i + one, size), i + one, zero);
    };
    const auto upper_row = before(upper, height) * width;
    const auto lower_row = behind(upper, height) * width;
    const auto left_column = before(left, width);
    const auto right_column = behind(left, width);
    const TexelPlaceOf<L> place{zero, zero, x - floor_x, y - floor_y};
    return bilinear<L, Vec3Of<L>>(coded_texel<L>(picture, upper_row + left_column),
                                  coded_texel<L>(picture, upper_row + right_column),
                                  coded_texel<L>(picture, lower_row + left_column),
                                  coded_texel<L>(picture, lower_row + right_column), place);
}

/// See look_up_half_colour.
template <class L>
CAROM_KERNEL_OUTLINED Vec3Of<L> look_up_image(const ImageTables& picture, const Vec2Of<L>& uv,
                                              ValueOf<L> footprint) {
    const auto from_levels = [&]() CAROM_KERNEL_ATTRIBUTE {
        if (!picture.is_grey) {
            return look_up_half_colour<L>(picture.levels, uv, footprint);
        }
        const auto grey = look_up_half<L>(picture.levels, uv, footprint);
        return Vec3Of<L>{grey, grey, grey};
    };
    if (!picture.codes.exists()) {
        return from_levels();
    }
    // The levels begin with the second one, whose longer side counts as half of the finest one's.
    const auto is_finest = L::is_less(
        limited<L>(footprint * L::all(picture.levels.longest_side), 0.5f, 1e9f), L::all(1));
    if (L::none(is_finest)) {
        return from_levels();
    }
    const auto finest = look_up_coded<L>(picture, uv);
    if (L::none(L::opposite(is_finest))) {
        return finest;
    }
    return select<L>(is_finest, finest, from_levels());
}
