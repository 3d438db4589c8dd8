// A shot with one example of everything that is exported.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/export/export_scene.h"
#include "sim/bake.h"

namespace carom::testing {

struct SampleScene {
    pipeline::Shot shot;
    sim::Timeline timeline;
    pipeline::ExportScene scene;
};

/// Two balls that collide, a striped ball that spins, one that is put elsewhere, a falling tile, a
/// keyed box that makes two turns, a cone, lights of several kinds, two cameras.
[[nodiscard]] inline SampleScene sample_scene() {
    constexpr const char* kText = R"(carom: 1
simulation: {duration: 0.6 s}
table: {kind: cloth}
ball_set: {kind: pool}
balls:
  cue: {at: [-0.3, 0]}
  one: {at: [0.1, 0.01]}
  nine: {at: [0.3, 0.3], spin: [0, 0, 300 rad/s]}
  two: {at: [-0.4, 0.3], velocity: [0.5, 0]}
objects:
  tile: {box: [0.01, 0.03, 0.06], at: [0.5, 0, 0.2], physics: {density: 700 kg/m^3}, material: clear}
  wheel: {box: [0.1, 0.02, 0.02], at: [0, 0.4, 0.1],
          motion: {easing: linear, keys: [{at: 0 s}, {at: 0.5 s, turn: {axis: [0, 0, 1], angle: 720 deg}}]}}
  tip: {cone: {radius: 0.1, height: 0.2}, at: [0.2, -0.4, 0.1]}
materials:
  clear: {standard: {base: [0.9, 0.9, 0.9], transmission: 1, ior: 1.45, roughness: 0}}
events:
  - strike: {ball: cue, at: 0.1 s, toward: one, speed: 3}
  - place: {ball: two, spot: [0.4, -0.2], at: 0.33 s}
lights:
  lamp: {rectangle: [1, 0.4], at: [0, 0, 1], facing: [0, 0, -1], radiance: [10, 10, 5]}
  bulb: {sphere: 0.05, at: [1, 0, 1], radiance: [3, 3, 3]}
  spark: {point: [2, 2, 2], at: [1, 0, 1]}
  room: {environment: 0.3}
cameras:
  - {name: seat, video: [0 s, 0.5 s], scene: [0.6 s, 0.1 s], position: {bezier: [[0, -1, 0.8], [0.2, -1, 0.8]]},
     target: [0, 0, 0], fov: [40 deg, 20 deg], focus: one, f_number: 4}
  - {name: close, video: [0.5 s, 1 s], scene: 0.2 s, position: [0, -1, 0.3], target: [0, 0, 0]}
render: {size: [64, 36], fps: 10}
)";
    pipeline::LoadResult loaded = pipeline::load_shot_text(kText, "sample.yaml");
    for (const pipeline::Problem& problem : loaded.problems) {
        ADD_FAILURE() << problem.message;
    }
    SampleScene sample;
    sample.shot = std::move(loaded.shot.value());
    sample.timeline = sim::bake(sample.shot.world);
    for (const sim::Track& track : sample.shot.keyed) {
        sample.timeline.tracks.push_back(track);
    }
    sample.scene = pipeline::export_scene(sample.shot, sample.timeline);
    return sample;
}

}  // namespace carom::testing
