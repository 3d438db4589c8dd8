// The sound of films of several shots.
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/sequence/sequence_job.h"
#include "tests/pipeline/video/click_source.h"
#include "tests/pipeline/video/decoded_sound.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ClickSource;
using carom::testing::decode_sound;
using carom::testing::DecodedSound;
using carom::testing::ScratchFolder;

Sequence two_cards() {
    Sequence sequence;
    sequence.name = "cards";
    sequence.width = 64;
    sequence.height = 36;
    sequence.fps = Rational(25);
    for (const char* text : {"one", "two"}) {
        TitleCard card;
        card.text = text;
        sequence.parts.push_back({card, 10, 0});
    }
    return sequence;
}

DecodedSound written(const Sequence& sequence, const std::string& frames) {
    const ScratchFolder folder;
    FilmJobOptions options;
    options.output = folder.path("film.mkv");
    options.cache_folder = folder.path("cache");
    options.frames = frames.empty() ? FrameRange{} : parse_frame_range(frames);
    options.sound = [](const SoundContext&) {
        return std::make_unique<ClickSource>(std::vector{0.1, 0.5, 0.7});
    };
    (void)make_sequence(sequence, {}, options, {}, {});
    return decode_sound(options.output);
}

TEST(SequenceSound, FilmOfSeveralParts_HasTheSoundOfItsFrames) {
    const ClickSource clicks({0.1, 0.5, 0.7});
    for (const auto& [frames, first, count] : {std::tuple{"", 0, 20}, std::tuple{"8-13", 8, 6}}) {
        const DecodedSound found = written(two_cards(), frames);
        EXPECT_EQ(found.picture_times.size(), static_cast<std::size_t>(count));
        const std::vector<double> left = found.channel(false);
        ASSERT_EQ(left.size(), static_cast<std::size_t>(1920 * count));
        for (std::size_t i = 0; i < left.size(); ++i) {
            const double exact = clicks.value(static_cast<std::int64_t>(i) + 1920 * first, 0);
            ASSERT_EQ(left[i], std::nearbyint(exact * 8388608) / 8388608) << i;
        }
    }
}

TEST(SequenceSound, AudioNone_WritesASilentFilm) {
    Sequence sequence = two_cards();
    sequence.output.audio = AudioCodec::none;
    EXPECT_FALSE(written(sequence, "").has_sound);
}

}  // namespace
}  // namespace carom::pipeline
