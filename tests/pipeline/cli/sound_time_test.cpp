// How `carom sound` follows the film's speed: slow motion, reverse and still pictures.
#include <cmath>

#include "tests/pipeline/cli/sound_fixture.h"

namespace carom::cli {
namespace {

using carom::testing::clack_shot;
using carom::testing::HeardRow;
using carom::testing::in_full_scale;
using carom::testing::kSampleRate;
using carom::testing::peak_index;
using carom::testing::SoundCommands;
using carom::testing::spectral_peak;
using carom::testing::tiny_shot;
using carom::testing::WavSamples;
using carom::testing::write_text;

class SoundTime : public SoundCommands {
  protected:
    SoundTime() { write_text(path("clack.yaml"), clack_shot(1)); }

    /// What is heard of the clack at a speed.
    struct Clack {
        double frequency = 0;  // Hz, at which its spectrum is highest
        double late = 0;       // s, by which its peak comes after the film shows the contact
        HeardRow row;
    };
    [[nodiscard]] Clack clack_at(const std::string& speed, const std::vector<std::string>& more) {
        listen("clack.yaml", "clack",
               joined(joined(plain(), more),
                      {"--set", "sound.mix.rolling=-100 dB", "--speed", speed}));
        const std::vector<double> samples = in_full_scale(wav("clack").left);
        const std::vector<HeardRow> rows = heard("clack");
        EXPECT_EQ(rows.size(), 1U);
        const std::size_t peak = peak_index(wav("clack").left, 0, 1 << 30);
        return {spectral_peak(std::vector(samples.begin(), samples.begin() + 4800), 50, 8000),
                static_cast<double>(peak) / kSampleRate - rows.at(0).film_time, rows.at(0)};
    }
};

TEST_F(SoundTime, SlowMotion_LowersThePitchByThreeOctavesAndNoMore) {
    const Clack normal = clack_at("1", {});
    EXPECT_GT(normal.frequency, 1500);
    EXPECT_LT(normal.frequency, 3000);
    const Clack half = clack_at("1/2", {});
    EXPECT_NEAR(half.frequency, normal.frequency / 2, 0.01 * normal.frequency / 2);
    const Clack eighth = clack_at("1/8", {});
    EXPECT_NEAR(eighth.frequency, normal.frequency / 8, 0.01 * normal.frequency / 8);
    EXPECT_NEAR(eighth.row.film_time, 8 * normal.row.film_time, 1e-12);
    const Clack slower = clack_at("1/40", {});
    EXPECT_NEAR(slower.frequency, eighth.frequency, 0.002 * eighth.frequency);
    EXPECT_NEAR(slower.row.film_time, 40 * normal.row.film_time, 1e-11);
    // Its peak comes as late as it does at 1/8, after the way to the listener.
    EXPECT_NEAR(slower.late, eighth.late, 2 / kSampleRate);
    EXPECT_NEAR(eighth.late - 1 / 343.0, 8 * (normal.late - 1 / 343.0), 10 / kSampleRate);
}

TEST_F(SoundTime, PitchIsKept_WhenAskedFor) {
    const std::vector<std::string> keep{"--set", "sound.pitch=keep"};
    const Clack normal = clack_at("1", keep);
    for (const char* speed : {"1/8", "1/40"}) {
        EXPECT_NEAR(clack_at(speed, keep).frequency, normal.frequency, 0.002 * normal.frequency);
    }
}

TEST_F(SoundTime, Reverse_IsTheMirroredFile) {
    // Two balls and cushions; both last for longer than the film shows what happens.
    std::string shot = tiny_shot();
    shot.replace(shot.find("kind: cloth"), 11, "kind: pool");
    write_text(path("shot.yaml"), shot);
    const std::vector<std::string> options =
        joined(plain(), {"--set", "sound.delay=false", "--set", "sound.mix.rolling=-100 dB"});
    listen("shot.yaml", "forward", options);
    listen("shot.yaml", "back", joined(options, {"--reverse"}));
    const std::vector<std::int32_t> forward = wav("forward").left;
    const std::vector<std::int32_t> back = wav("back").left;
    ASSERT_EQ(forward.size(), back.size());
    EXPECT_GE(heard("forward").size(), 2U);
    // The sample n of one is at the time at which the other has its sample (length - n); without
    // those that fade at the ends.
    const std::size_t length = forward.size();
    std::int32_t largest = 0;
    std::int32_t highest = 0;
    for (std::size_t n = 250; n + 250 < length; ++n) {
        largest = std::max(largest, std::abs(back[n] - forward[length - n]));
        highest = std::max(highest, std::abs(forward[n]));
    }
    EXPECT_LE(largest, 1);
    EXPECT_GT(highest, 100'000);
}

TEST_F(SoundTime, StillPictureAfterAnImpact_DiesAwayInTheRoom) {
    std::string shot = tiny_shot();
    const auto replace = [&shot](const std::string& old, const std::string& text) {
        shot.replace(shot.find(old), old.size(), text);
    };
    replace("    video: [0 s, 0.6 s]\n    scene: [0 s, 0.6 s]\n",
            "    video: [0 s, 2 s]\n    scene: {from: 0 s, speeds: [[0.4 s, 1], "
            "[0.5 s, 0]]}\n");
    write_text(path("shot.yaml"), shot);
    listen("shot.yaml", "still", {"--set", "sound.room=club"});
    const std::vector<HeardRow> rows = heard("still");
    ASSERT_GE(rows.size(), 2U);
    EXPECT_LT(rows.back().film_time, 0.5);
    const WavSamples samples = wav("still");
    ASSERT_EQ(samples.left.size(), 96'000U);
    const auto peak_from = [&samples](double time) {
        const auto first = static_cast<std::int64_t>(time * kSampleRate);
        return std::max(std::abs(samples.left[peak_index(samples.left, first, 96'000)]),
                        std::abs(samples.right[peak_index(samples.right, first, 96'000)]));
    };
    EXPECT_GT(peak_from(0.45), 1000);  // it rolls and rings until then
    EXPECT_GT(peak_from(0.55), 100);   // the room goes on
    // 1.5 times the club's reverberation time of 0.6 s: -90 dB of the impacts' full scale.
    EXPECT_LT(peak_from(0.5 + 1.5 * 0.6), std::pow(10, -90 / 20.0) * 0x1p23);
}

TEST_F(SoundTime, NothingMoves_OnlyZeros) {
    std::string shot = tiny_shot();
    const std::size_t events = shot.find("events:");
    shot.erase(events, shot.find("lights:") - events);
    write_text(path("shot.yaml"), shot);
    listen("shot.yaml", "rest", {});
    EXPECT_TRUE(heard("rest").empty());
    const WavSamples samples = wav("rest");
    ASSERT_EQ(samples.left.size(), 28'800U);
    EXPECT_EQ(samples.left, std::vector<std::int32_t>(28'800));
    EXPECT_EQ(samples.right, samples.left);
}

}  // namespace
}  // namespace carom::cli
