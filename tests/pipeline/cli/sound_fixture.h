// A fixture for the acceptance tests of sound: it runs `carom sound` and reads its files.
#pragma once

#include <fmt/core.h>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/cli/sound_files.h"

namespace carom::testing {

/// Two pool balls of which one hits the other at `speed` (m/s), fully and along x, at the start of
/// a film of half a second. It is seen from 1 m, at 60 degrees to the line of centres.
[[nodiscard]] inline std::string clack_shot(double speed) {
    // The cloth slows the ball by its friction, so it starts right before the contact.
    constexpr double kGap = 2e-5;  // m
    return fmt::format(R"(carom: 1
simulation: {{duration: 0.5 s}}
table: {{kind: cloth}}
balls:
  cue: {{at: [-{}, 0], velocity: [{}, 0]}}
  one: {{at: [0, 0]}}
lights:
  lamp: {{rectangle: [1, 0.4], at: [0, 0, 1], facing: [0, 0, -1], radiance: [10, 10, 10]}}
cameras:
  - name: seat
    video: [0 s, 0.5 s]
    scene: [0 s, 0.5 s]
    position: [0.471425, -0.8660254, 0.028575]
    target: [-0.028575, 0, 0.028575]
    fov: 40 deg
render: {{size: [64, 36], fps: 24, samples: 4}}
)",
                       0.05715 + kGap, speed);
}

class SoundCommands : public EndToEnd {
  protected:
    /// Options with which samples are pascals and only what sounds by itself is heard: a sample of
    /// 1 is `full_scale` (Pa).
    static std::vector<std::string> plain(const std::string& full_scale = "20 Pa") {
        std::vector<std::string> words;
        for (const std::string& setting :
             {std::string("room=none"), std::string("stereo=mono"), std::string("dynamics=natural"),
              "gain.full_scale=" + full_scale}) {
            words.insert(words.end(), {"--set", "sound." + setting});
        }
        return words;
    }
    static std::vector<std::string> joined(std::vector<std::string> a,
                                           const std::vector<std::string>& b) {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    }
    static std::string example(const std::string& name) {
        return std::string(CAROM_SOURCE_DIR) + "/examples/" + name + ".yaml";
    }

    /// Runs `carom sound shot -o NAME.wav --heard NAME.csv` with more options.
    void listen(const std::string& shot, const std::string& name,
                const std::vector<std::string>& options) const {
        const RunResult result = run(
            joined({"sound", shot, "-q", "-o", name + ".wav", "--heard", name + ".csv"}, options));
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    [[nodiscard]] WavSamples wav(const std::string& name) const {
        return read_wav(path(name + ".wav"));
    }
    [[nodiscard]] std::vector<HeardRow> heard(const std::string& name) const {
        return read_heard(path(name + ".csv"));
    }
};

}  // namespace carom::testing
