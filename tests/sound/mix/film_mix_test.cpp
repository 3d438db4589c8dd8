// A film's blocks are the same each time, whether they are kept or mixed again.
#include "sound/mix/film_mix.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"

namespace carom::sound {
namespace {

using Block = std::array<double, kBlock>;

/// The samples of the next blocks, left and right by turns.
std::vector<double> read(FilmMix& mix, int count) {
    std::vector<double> samples;
    for (int i = 0; i < count; ++i) {
        Block left{};
        Block right{};
        left.fill(7);  // is replaced
        right.fill(7);
        mix.next(left, right);
        samples.insert(samples.end(), left.begin(), left.end());
        samples.insert(samples.end(), right.begin(), right.end());
    }
    return samples;
}

TEST(FilmMix, EveryReading_HasTheMixedSamples) {
    for (const std::int64_t frames : {std::int64_t{48'000}, FilmMix::kMaxKept + 1}) {
        SmallFilm film;
        film.collide(0.01);
        film.collide(0.04);
        film.show(0, 1, 0, 1);
        film.scene.frames = frames;
        FilmMix once(film.scene);
        const std::vector<double> expected = read(once, 12);
        EXPECT_GT(highest(expected), 0);
        FilmMix mix(film.scene);
        const std::vector<double> first = read(mix, 5);
        EXPECT_EQ(first, std::vector<double>(expected.begin(), expected.begin() + 10 * kBlock));
        mix.rewind();
        EXPECT_EQ(read(mix, 12), expected);
        mix.rewind();
        EXPECT_EQ(read(mix, 12), expected);
    }
}

}  // namespace
}  // namespace carom::sound
