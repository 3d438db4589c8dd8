// How the frames of parts become the frames of a film.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/sequence/sequence_job.h"
#include "pipeline/sequence/sequence_writer.h"

namespace carom::pipeline {
namespace {

/// A film of parts with these lengths and fades; the second is a title card.
Sequence film_of(std::vector<std::pair<std::int64_t, std::int64_t>> parts) {
    Sequence sequence;
    sequence.width = 64;
    sequence.height = 36;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        SequencePart part;
        ShotPart shot;
        shot.first = 100;
        part.content = shot;
        if (i == 1) {
            part.content = TitleCard{};
        }
        part.frames = parts[i].first;
        part.fade = parts[i].second;
        sequence.parts.push_back(part);
    }
    return sequence;
}

TEST(Sequence, Fades_AreFramesOfBothParts) {
    const Sequence film = film_of({{10, 0}, {5, 2}, {8, 1}});
    EXPECT_EQ(film.starts(), (std::vector<std::int64_t>{0, 8, 12}));
    EXPECT_EQ(film.frames(), 20);
    ASSERT_EQ(layers_of(film, 7).size(), 1U);
    const std::vector<SequenceLayer> fading = layers_of(film, 8);
    ASSERT_EQ(fading.size(), 2U);
    EXPECT_EQ(fading[0].part, 0U);
    EXPECT_EQ(fading[0].frame, 8);
    EXPECT_EQ(fading[0].weight, 0.75);
    EXPECT_EQ(fading[1].part, 1U);
    EXPECT_EQ(fading[1].frame, 0);
    EXPECT_EQ(fading[1].weight, 0.25);
    for (std::int64_t frame = 0; frame < film.frames(); ++frame) {
        double sum = 0;
        for (const SequenceLayer& layer : layers_of(film, frame)) {
            sum += layer.weight;
        }
        EXPECT_EQ(sum, 1) << frame;
    }
}

TEST(Sequence, OwnFrames_AreThoseOfTheShotsFilm) {
    const Sequence film = film_of({{10, 0}, {5, 2}, {8, 1}});
    EXPECT_EQ(own_frames(film, 0, {0, 7, 9, 10}), (std::vector<std::int64_t>{100, 107, 109}));
    EXPECT_TRUE(own_frames(film, 1, {9, 10}).empty());
    EXPECT_EQ(own_frames(film, 2, {11, 12, 19}), (std::vector<std::int64_t>{100, 107}));
}

TEST(SequenceMixer, PassesOnEveryFrameInOrder) {
    const Sequence film = film_of({{6, 2}, {4, 2}, {5, 1}});
    std::vector<std::int64_t> frames;
    std::vector<int> values;
    SequenceMixer mixer(film, [&](std::int64_t frame, std::span<const std::uint16_t> rgb) {
        frames.push_back(frame);
        values.push_back(rgb[0]);
    });
    for (std::size_t part = 0; part < 3; ++part) {
        const std::vector<std::uint16_t> rgb(3, static_cast<std::uint16_t>(1000 * (part + 1)));
        for (std::int64_t own = 0; own < film.parts[part].frames; ++own) {
            mixer.add(part, own, rgb);
        }
    }
    EXPECT_EQ(frames, (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
    // Out of black, then 1000, a fade of two frames to 2000, one of one frame to 3000.
    EXPECT_EQ(values, (std::vector<int>{250, 750, 1000, 1000, 1250, 1750, 2000, 2500, 3000, 3000,
                                        3000, 3000}));
}

TEST(TitleCard, IsDrawnOnItsBackground) {
    TitleCard card;
    card.text = "30-degree rule";
    card.background = {0, 0, 0.2};
    const std::vector<std::uint16_t> rgb = drawn_card(card, 320, 180);
    ASSERT_EQ(rgb.size(), std::size_t{3} * 320 * 180);
    EXPECT_EQ(rgb[0], 0);
    EXPECT_NEAR(rgb[2], 65535 * (1.055 * std::pow(0.2, 1 / 2.4) - 0.055), 70);
    EXPECT_GT(std::ranges::max(rgb), 60000);  // letters
    const auto lit = std::ranges::count_if(rgb, [](std::uint16_t value) { return value > 60000; });
    EXPECT_GT(lit, 300);
    EXPECT_LT(lit, 20000);
}

}  // namespace
}  // namespace carom::pipeline
