// Loudness of what `carom sound` writes, against what it reports, and the memory that it takes.
#include <algorithm>
#include <cmath>
#include <regex>
#include <span>

#include "sound/level/loudness.h"
#include "tests/pipeline/cli/sound_fixture.h"

namespace carom::cli {
namespace {

using carom::testing::in_full_scale;
using carom::testing::RunResult;
using carom::testing::SoundCommands;
using carom::testing::WavSamples;
using carom::testing::write_text;

class SoundLevel : public SoundCommands {};

/// The number after a word of the report.
double reported(const std::string& text, const std::string& name) {
    std::smatch found;
    EXPECT_TRUE(std::regex_search(text, found, std::regex(name + " +(-?[0-9.]+)"))) << text;
    return found.empty() ? 0 : std::stod(found[1]);
}

TEST_F(SoundLevel, Report_SaysTheLevelsOfTheFile) {
    for (const std::string name : {"nine_ball_break", "bank_shot", "jump_shot"}) {
        const RunResult result = run({"sound", example(name), "-q", "-o", "film.wav", "--report"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const WavSamples samples = wav("film");
        sound::LoudnessMeter meter;
        meter.add(in_full_scale(samples.left), in_full_scale(samples.right));
        EXPECT_NEAR(reported(result.out, "loudness"), meter.integrated(), 0.1) << name;
        const double true_peak = 20 * std::log10(meter.true_peak());
        EXPECT_NEAR(reported(result.out, "true peak"), true_peak, 0.1) << name;
        EXPECT_LE(true_peak, -1.0) << name;
        // All but the quietest films are as loud as they may be.
        EXPECT_GT(true_peak, -1.05) << name;
    }
}

TEST_F(SoundLevel, AnHourOfSixteenBalls_FitsIntoSixtyFourMegabytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the memory of the sanitizer itself would be counted";
#endif
    const auto memory_of = [this](int seconds) {
        write_text(path("camera.yaml"), fmt::format(R"(cameras:
  - name: seat
    video: [0 s, {} s]
    scene: {{from: 0.4 s, speeds: [[8 s, 1], [8.2 s, 0]]}}
    position: [0.3, 1.5, 0.6]
    target: [0.8, 0.35, 0]
    fov: 60 deg
)",
                                                    seconds));
        const RunResult result =
            run({"sound", example("nine_ball_break"), "-q", "--camera", "camera.yaml", "--set",
                 "sound.gain.full_scale=20 Pa", "--report"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return static_cast<double>(result.peak_memory);
    };
    EXPECT_GT(memory_of(10), 0);  // it makes the bake, which the others have from the cache
    const double minute = memory_of(60);
    const double growth = (memory_of(600) - minute) / 9;  // bytes per minute
    EXPECT_LT(minute + 59 * growth, 64 * 0x1p20);
}

}  // namespace
}  // namespace carom::cli
