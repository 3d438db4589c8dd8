// The random numbers of samples (sampler.h) in lanes, one sample in each. Included as
// render/lanes/kernels/vectors.h is.

/// See SampleStream; sets are those of `seek`.
template <class L>
class SamplerOf {
    using V = ValueOf<L>;
    using Word = WordOf<L>;

  public:
    CAROM_KERNEL SamplerOf(Word pixel_hash, Word reversed_sample)
        : pixel_hash_(pixel_hash), reversed_sample_(reversed_sample) {}

    /// A point of the unit cube in four dimensions.
    CAROM_KERNEL void get_4d(Word set, V (&u)[4]) const {
        const Word hash = hash_of_set<L>(pixel_hash_, set);
        Word coordinates[4];
        sobol<4>(shuffled_index<L>(reversed_sample_, hash), coordinates);
        for (int d = 0; d < 4; ++d) {
            u[d] = scrambled_coordinate<L>(coordinates[d], seed(hash, d));
        }
    }

    /// Four points of the unit square for each sample: all x coordinates, and all y coordinates.
    /// The points of all samples together form one low-discrepancy sequence of four times the
    /// length. For fewer than 2^30 samples.
    CAROM_KERNEL void get_2d_block(std::uint32_t set, V (&x)[4], V (&y)[4]) const {
        const Word hash = hash_of_set<L>(pixel_hash_, L::all_word(set));
        const Word shuffled = shuffled_index<L>(reversed_sample_, hash);
        // The index is 4 i: all four points are taken, so their order within the block does not
        // matter.
        Word coordinates[2];
        sobol<2>(L::template shifted_right<2>(shuffled), coordinates);
        const Word seed_x = seed(hash, 0);
        const Word seed_y = seed(hash, 1);
        for (std::uint32_t k = 0; k < 4; ++k) {
            const Word to_x = L::all_word(detail::block_difference(0, k));
            const Word to_y = L::all_word(detail::block_difference(1, k));
            x[k] = scrambled_coordinate<L>(coordinates[0] ^ to_x, seed_x);
            y[k] = scrambled_coordinate<L>(coordinates[1] ^ to_y, seed_y);
        }
    }

    /// SampleStream::camera_sample: pixel, lens, time. The index is not shuffled here; the sets of
    /// the bounces are, each in a different order.
    CAROM_KERNEL void get_camera_sample(V (&u)[5]) const {
        const Word hash = hash_of_set<L>(pixel_hash_, L::all_word(detail::kCameraSet));
        Word coordinates[5];
        sobol<5>(reversed_sample_, coordinates);
        for (int d = 0; d < 5; ++d) {
            u[d] = scrambled_coordinate<L>(coordinates[d], seed(hash, d));
        }
    }

    /// A number that is independent from sample to sample.
    [[nodiscard]] CAROM_KERNEL V get_1d(Word set) const {
        return independent_number<L>(hash_of_set<L>(pixel_hash_, set), reversed_sample_);
    }

  private:
    CAROM_KERNEL static Word seed(Word hash, int dimension) {
        return seed_of_dimension<L>(hash, L::all_word(detail::kDimensionSalts[dimension]));
    }
    /// The exclusive or over the eight nibbles of the index.
    template <int kDimensions>
    CAROM_KERNEL static void sobol(Word reversed_index, Word* coordinates) {
        for (int nibble = 0; nibble < 8; ++nibble) {
            const auto digit =
                L::from_word(L::shifted_right_by(reversed_index, 4 * nibble) & L::all_word(15));
            for (int d = 0; d < kDimensions; ++d) {
                const Word part = L::one_of_sixteen(detail::kSobol.at[nibble][d], digit);
                coordinates[d] = nibble == 0 ? part : coordinates[d] ^ part;
            }
        }
    }

    Word pixel_hash_, reversed_sample_;
};
