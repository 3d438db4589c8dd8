// Russian roulette of long paths, in lanes. Included as render/lanes/kernels/vectors.h is.

/// The probability with which a path of this throughput continues from kRouletteVertex on.
template <class L>
CAROM_KERNEL ValueOf<L> survival_of(const Vec3Of<L>& throughput) {
    return limited<L>(largest<L>(throughput), kLeastSurvival, 1);
}
