// The value of a SharedExponent (shared_exponent.h), in lanes. Included as
// render/lanes/kernels/vectors.h is.

template <class L>
CAROM_KERNEL Vec3Of<L> shared_exponent_value(WordOf<L> bits) {
    const auto mask = L::all_word(511);
    const auto exponent = L::template shifted_right<27>(bits) + L::all_word(127 - 24);
    const auto scale = L::from_bits(L::from_word(L::template shifted_left<23>(exponent)));
    const auto channel = [&](WordOf<L> mantissa) CAROM_KERNEL_ATTRIBUTE {
        return L::to_value(L::from_word(mantissa & mask)) * scale;
    };
    return {channel(bits), channel(L::template shifted_right<9>(bits)),
            channel(L::template shifted_right<18>(bits))};
}
