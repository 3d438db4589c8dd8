// A shot that is simulated and rendered within a fraction of a second.
#pragma once

#include <string>

namespace carom::testing {

/// Two balls on a bare cloth, one struck at the other; 6 frames of 64 x 36.
[[nodiscard]] inline std::string tiny_shot() {
    return R"(carom: 1
simulation: {duration: 0.6 s}
table: {kind: cloth}
balls:
  cue: {at: [-0.3, 0]}
  one: {at: [0.1, 0.01]}
events:
  - strike: {ball: cue, at: 0.1 s, toward: one, speed: 3}
lights:
  lamp: {rectangle: [1, 0.4], at: [0, 0, 1], facing: [0, 0, -1], radiance: [10, 10, 10]}
cameras:
  - name: seat
    video: [0 s, 0.6 s]
    scene: [0 s, 0.6 s]
    position: [0, -1, 0.8]
    target: [0, 0, 0]
    fov: 40 deg
render: {size: [64, 36], fps: 10, samples: 4, max_bounces: 1}
output: {preset: ultrafast}
)";
}

}  // namespace carom::testing
