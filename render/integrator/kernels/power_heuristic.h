// Multiple importance sampling in lanes. Included as render/lanes/kernels/vectors.h is.

/// Weight of a sample made with density `pdf` when another strategy makes the same sample with
/// density `other`: the power heuristic with exponent 2 (Veach 1997, section 9.2.4).
template <class L>
CAROM_KERNEL ValueOf<L> power_heuristic(ValueOf<L> pdf, ValueOf<L> other) {
    const auto ratio = other / pdf;
    return L::all(1) / (L::all(1) + ratio * ratio);
}
