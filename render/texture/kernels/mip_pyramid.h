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

/// HalfColourCodec's texel, two words long: its colour, or its alpha in all channels.
template <class L, bool kAlpha = false>
CAROM_KERNEL Vec3Of<L> half_colour(WordOf<L> first, WordOf<L> second) {
    if constexpr (kAlpha) {
        const auto alpha = half_value<L>(L::template shifted_right<16>(second));
        return {alpha, alpha, alpha};
    }
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

/// The four texels around `uv` on a level. Any place is safe.
template <class L>
CAROM_KERNEL TexelPlaceOf<L> texels_around(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                           IntOf<L> level) {
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

/// Whole numbers and fractions of logarithms to base 2 of numbers >= 1; the fraction is linear
/// between powers of 2.
template <class L>
struct LogarithmOf {
    IntOf<L> whole;
    ValueOf<L> fraction;

    CAROM_KERNEL explicit LogarithmOf(ValueOf<L> x) {
        const auto bits = L::bits_of(x);
        whole = L::template shifted_right_int<23>(bits) - L::all_int(127);
        const auto mantissa = bits & L::all_int(0x7fffff);
        fraction = L::from_bits(mantissa | L::all_int(127 << 23)) - L::all(1);
    }
};

/// The four texels around `uv` on the finest level whose texels are at least half as large as the
/// footprint, in units of uv of the longer side. Any number is safe.
template <class L>
CAROM_KERNEL TexelPlaceOf<L> texel_place(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                         ValueOf<L> footprint) {
    const LogarithmOf<L> level(limited<L>(footprint * L::all(pyramid.longest_side), 1, 1e9f));
    return texels_around<L>(pyramid, uv,
                            L::smaller_int(level.whole, L::all_int(pyramid.first.count() - 1)));
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

template <class L, bool kAlpha = false>
CAROM_KERNEL Vec3Of<L> look_up_half_colour(const PyramidTables& pyramid,
                                           const TexelPlaceOf<L>& place) {
    const auto texel = [&](IntOf<L> index) CAROM_KERNEL_ATTRIBUTE {
        const auto twofold = index + index;
        const auto fourfold = twofold + twofold;
        const auto words = L::gather_bytes_pair(pyramid.texels.data(), fourfold + fourfold);
        return half_colour<L, kAlpha>(words.first, words.second);
    };
    const auto one = L::all_int(1);
    return bilinear<L, Vec3Of<L>>(texel(place.upper), texel(place.upper + one), texel(place.lower),
                                  texel(place.lower + one), place);
}

/// The value at `uv`, v = 0 at the top, averaged over about `footprint` (in the same unit, of the
/// larger side), from the finest level whose texels are at least half as large.
template <class L>
CAROM_KERNEL Vec3Of<L> look_up_half_colour(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                           ValueOf<L> footprint) {
    return look_up_half_colour<L>(pyramid, texel_place<L>(pyramid, uv, footprint));
}

/// Likewise of numbers of kBits: both texels of a row are in one word. `decoded`:
/// the value of a texel in a word's lower bits.
template <class L, int kBits, class Decode>
CAROM_KERNEL ValueOf<L> look_up_number(const PyramidTables& pyramid, const TexelPlaceOf<L>& place,
                                       const Decode& decoded) {
    const auto words = [&](IntOf<L> index) CAROM_KERNEL_ATTRIBUTE {
        return L::gather_bytes(pyramid.texels.data(), L::product(index, kBits / 8));
    };
    const auto upper = words(place.upper);
    const auto lower = words(place.lower);
    return bilinear<L, ValueOf<L>>(decoded(upper), decoded(L::template shifted_right<kBits>(upper)),
                                   decoded(lower), decoded(L::template shifted_right<kBits>(lower)),
                                   place);
}

/// See look_up_half_colour.
template <class L>
CAROM_KERNEL ValueOf<L> look_up_signed(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                       ValueOf<L> footprint) {
    return look_up_number<L, 16>(pyramid, texel_place<L>(pyramid, uv, footprint),
                                 [](WordOf<L> word)
                                     CAROM_KERNEL_ATTRIBUTE { return signed_value<L>(word); });
}

/// Likewise.
template <class L>
CAROM_KERNEL ValueOf<L> look_up_coverage(const PyramidTables& pyramid, const Vec2Of<L>& uv,
                                         ValueOf<L> footprint) {
    return look_up_number<L, 8>(pyramid, texel_place<L>(pyramid, uv, footprint),
                                [](WordOf<L> word)
                                    CAROM_KERNEL_ATTRIBUTE { return coverage_value<L>(word); });
}

template <class L>
CAROM_KERNEL ValueOf<L> look_up_half(const PyramidTables& pyramid, const TexelPlaceOf<L>& place) {
    return look_up_number<L, 16>(
        pyramid, place, [](WordOf<L> word) CAROM_KERNEL_ATTRIBUTE { return half_value<L>(word); });
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

/// The bilinear value at `uv` on a level; 0 is the finest one.
template <class L, bool kAlpha>
CAROM_KERNEL Vec3Of<L> look_up_level(const ImageTables& picture, const Vec2Of<L>& uv,
                                     IntOf<L> level) {
    const auto from_levels = [&](IntOf<L> of_pyramid) CAROM_KERNEL_ATTRIBUTE {
        const TexelPlaceOf<L> place = texels_around<L>(picture.levels, uv, of_pyramid);
        if (!picture.is_grey) {
            return look_up_half_colour<L, kAlpha>(picture.levels, place);
        }
        const auto grey = look_up_half<L>(picture.levels, place);
        return Vec3Of<L>{grey, grey, grey};
    };
    if (!picture.codes.exists()) {
        return from_levels(level);
    }
    // The pyramid begins with the second level.
    const auto coarser = L::larger_int(level - L::all_int(1), L::all_int(0));
    const auto is_finest = L::is_less_int(level, L::all_int(1));
    if (L::none(is_finest)) {
        return from_levels(coarser);
    }
    const auto finest = look_up_coded<L>(picture, uv);
    if (L::none(L::opposite(is_finest))) {
        return finest;
    }
    return select<L>(is_finest, finest, from_levels(coarser));
}

/// Between the values of the two levels whose texels are about as large as `texels` (>= 1) of the
/// finest one.
template <class L, bool kAlpha>
CAROM_KERNEL Vec3Of<L> look_up_between(const ImageTables& picture, const Vec2Of<L>& uv,
                                       ValueOf<L> texels) {
    const int last = picture.levels.first.count() - (picture.codes.exists() ? 0 : 1);
    const LogarithmOf<L> level(limited<L>(texels, 1, 1e9f));
    const auto finer = L::smaller_int(level.whole, L::all_int(last));
    const Vec3Of<L> fine = look_up_level<L, kAlpha>(picture, uv, finer);
    if (L::none(L::is_less(L::all(0), level.fraction))) {
        return fine;
    }
    const auto coarser = L::smaller_int(level.whole + L::all_int(1), L::all_int(last));
    const Vec3Of<L> coarse = look_up_level<L, kAlpha>(picture, uv, coarser);
    return fine + (coarse - fine) * level.fraction;
}

/// A place in a picture, v = 0 at the top, and how it changes along two sides of a pixel.
template <class L>
struct PixelOf {
    Vec2Of<L> uv, along, across;
};

/// The mean of a picture over a pixel's parallelogram: trilinear values side by side along its
/// longer side, as wide as the shorter one, or an eighth of the longer one (Heckbert 1989; hardware
/// does likewise, EXT_texture_filter_anisotropic).
template <class L, bool kAlpha>
CAROM_KERNEL_OUTLINED Vec3Of<L> look_up_channels(const ImageTables& picture,
                                                 const PixelOf<L>& pixel) {
    constexpr int kMostValues = 8;
    // Samples of a pixel lie side by side, so that each may see a little less than all of it.
    constexpr float kPartOfPixel = 0.7f;
    const auto zero = L::all(0);
    const auto texels_of = [&](const Vec2Of<L>& v) CAROM_KERNEL_ATTRIBUTE {
        const auto x = v.x * L::all(kPartOfPixel * static_cast<float>(picture.width));
        const auto y = v.y * L::all(kPartOfPixel * static_cast<float>(picture.height));
        return L::root(x * x + y * y);
    };
    const auto along = texels_of(pixel.along);
    const auto across = texels_of(pixel.across);
    const auto is_across = L::is_less(along, across);
    const auto longer = L::larger(along, across);
    const Vec2Of<L> side{L::select(is_across, pixel.across.x, pixel.along.x),
                         L::select(is_across, pixel.across.y, pixel.along.y)};
    const auto width = L::larger(L::smaller(along, across), L::all(1));
    // As many as it takes, unless one texel holds all.
    const auto wanted = limited<L>(longer / width, 1, kMostValues);
    const auto count = L::rounded_down(wanted + L::all(0.999f));
    const auto texels = L::larger(width, longer * L::all(1.0f / kMostValues));
    Vec3Of<L> sum{zero, zero, zero};
    for (int i = 0; i < kMostValues; ++i) {
        const auto counts = L::is_less(L::all(static_cast<float>(i)), count);
        if (L::none(counts)) {
            break;
        }
        const auto from_middle = (L::all(static_cast<float>(i) + 0.5f) / count - L::all(0.5f));
        const Vec3Of<L> value = look_up_between<L, kAlpha>(
            picture, {pixel.uv.x + side.x * from_middle, pixel.uv.y + side.y * from_middle},
            texels);
        sum = sum + select<L>(counts, value, {zero, zero, zero});
    }
    return sum * (L::all(1) / count);
}

/// What a texture gives at a point.
template <class L>
struct TextureValueOf {
    Vec3Of<L> colour;  // of pictures with alpha, times that
    ValueOf<L> alpha;
};

template <class L>
CAROM_KERNEL TextureValueOf<L> look_up_image(const ImageTables& picture, const PixelOf<L>& pixel) {
    TextureValueOf<L> value{look_up_channels<L, false>(picture, pixel), L::all(1)};
    if (picture.has_alpha) {
        value.alpha = look_up_channels<L, true>(picture, pixel).x;
    }
    return value;
}
