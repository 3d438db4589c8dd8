// Left and right of what `carom sound` writes.
#include <cmath>
#include <cstdlib>

#include "tests/pipeline/cli/sound_fixture.h"

namespace carom::cli {
namespace {

using carom::testing::kSampleRate;
using carom::testing::peak_index;
using carom::testing::SoundCommands;
using carom::testing::WavSamples;
using carom::testing::write_text;

class SoundSpace : public SoundCommands {
  protected:
    /// Two balls collide at the left edge of the picture, or, mirrored, at the right one. The edge
    /// is at tan(20 deg) 16/9 = 0.647 from the middle, as seen from 1 m.
    [[nodiscard]] WavSamples edge(bool is_mirrored, const std::vector<std::string>& options) {
        const char* minus = is_mirrored ? "" : "-";
        const char* plus = is_mirrored ? "-" : "";
        write_text(path("edge.yaml"), fmt::format(R"(carom: 1
simulation: {{duration: 0.5 s}}
table: {{kind: pool}}
balls:
  cue: {{at: [{0}0.7, 0.05], velocity: [{1}0.9, -0.45]}}
  one: {{at: [{0}0.64, 0]}}
lights:
  lamp: {{rectangle: [1, 0.4], at: [0, 0, 1], facing: [0, 0, -1], radiance: [10, 10, 10]}}
cameras:
  - name: seat
    video: [0 s, 0.5 s]
    scene: [0 s, 0.5 s]
    position: [0, -1, 0.028575]
    target: [0, 0, 0.028575]
    fov: 40 deg
render: {{size: [64, 36], fps: 24, samples: 4}}
)",
                                                  minus, plus));
        listen(
            "edge.yaml", "edge",
            joined({"--set", "sound.room=none", "--set", "sound.gain.full_scale=20 Pa"}, options));
        return wav("edge");
    }
};

/// The time of the first sample that is a fiftieth of the highest, s.
double onset(const std::vector<std::int32_t>& samples) {
    const std::size_t peak = peak_index(samples, 0, 1 << 30);
    const std::int32_t least = std::abs(samples[peak]) / 50;
    for (std::size_t n = 0; n < peak; ++n) {
        if (std::abs(samples[n]) > least) {
            // Between the samples on a straight line.
            const double before = n == 0 ? 0 : std::abs(samples[n - 1]);
            const double part = (least - before) / (std::abs(samples[n]) - before);
            return (static_cast<double>(n) - 1 + part) / kSampleRate;
        }
    }
    return static_cast<double>(peak) / kSampleRate;
}

std::int32_t highest(const std::vector<std::int32_t>& samples) {
    return std::abs(samples[peak_index(samples, 0, 1 << 30)]);
}

TEST_F(SoundSpace, ClackAtTheLeftEdge_ComesEarlierAndLouderToTheLeftEar) {
    const WavSamples samples =
        edge(false, {"--set", "sound.mix.rolling=-100 dB", "--set", "sound.bed=0"});
    // The edges sound from the loudspeakers, at 30 degrees: a/c (sin 30 deg + 30 deg) = 0.261 ms
    // (Woodworth), with a = 87.5 mm.
    const double between = onset(samples.right) - onset(samples.left);
    EXPECT_GT(between, 0.2e-3);
    EXPECT_LT(between, 0.3e-3);
    EXPECT_GT(highest(samples.left), 1.2 * highest(samples.right));
}

TEST_F(SoundSpace, MirroredShot_HasMirroredChannels) {
    // With rolling, the bed's reflection and everything else but a room, whose reverberation is not
    // the same in both channels.
    const WavSamples left = edge(false, {});
    const WavSamples right = edge(true, {});
    EXPECT_GT(highest(left.left), 10'000);
    EXPECT_NE(left.left, left.right);
    EXPECT_TRUE(left.left == right.right);
    EXPECT_TRUE(left.right == right.left);
}

}  // namespace
}  // namespace carom::cli
