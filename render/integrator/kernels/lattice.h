// Well-spread points of the unit square, in lanes. Included as render/lanes/kernels/vectors.h is.

/// The `k`th of `n` well-spread points, each uniform if `u` is: a lattice shifted by `u` (Cranley
/// and Patterson 1976, "Randomization of number theoretic methods for multiple integration").
template <class L>
CAROM_KERNEL Vec2Of<L> lattice_point(const Vec2Of<L>& u, int k, int n) {
    if (n == 1) {
        return u;
    }
    const auto x = u.x + L::all(static_cast<float>(k) / static_cast<float>(n));
    const auto y = u.y + L::all(static_cast<float>(k) * 0.618034f);
    return {x - L::rounded_down(x), y - L::rounded_down(y)};
}
