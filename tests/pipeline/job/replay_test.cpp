// A film of snooker with replays: what its texts say in every frame.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/frame_graphics.h"
#include "sim/bake.h"
#include "sim/event_time.h"

namespace carom::pipeline {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 54;

// The red is potted at about 0.2 s of the scene. The film shows it, slowly once more, in reverse
// after a cross-fade, and continues.
const std::string kFilm = R"(carom: 1
include: tables/snooker_12ft.yaml
simulation: {duration: 4 s}
balls: {cue: {at: [1.5, 0.6], velocity: [1.2, 1.2]}, red: {at: [1.7, 0.8]}}
cameras:
  - {name: main, video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, 0, 1], target: [1.7, 0.8, 0]}
  - {name: slow, video: [1 s, 3.5 s], scene: [{potted: red, before: 0.1 s}, {potted: red, after: 0.15 s}], position: [0, 0.8, 1], target: [1.7, 0.8, 0]}
  - {name: back, video: [3 s, 4 s], scene: [0.9 s, 0 s], fade: 0.5 s, position: [0, 0.8, 1], target: [1.7, 0.8, 0]}
  - {name: on, video: [4 s, 5 s], scene: [1 s, 2 s], position: [0, 0, 1], target: [1.7, 0.8, 0]}
annotations:
  - {text: "0", size: 0.4, to: {potted: red}}
  - {text: "1", size: 0.4, from: {potted: red}}
render: {size: [96, 54], fps: 24}
)";

TEST(Replays, Score_StaysAsItWasFirstShown) {
    LoadResult loaded = load_shot_text(kFilm, "film.yaml");
    ASSERT_TRUE(loaded.shot) << loaded.problems.size();
    Shot& shot = *loaded.shot;
    const sim::Timeline timeline = sim::bake(shot.world);
    ASSERT_TRUE(resolve_moments(shot, loaded.source, timeline).empty());
    const double potted = shot.annotations.at(1).from->seconds;
    ASSERT_GT(potted, 0.1);
    ASSERT_LT(potted, 0.9);

    FrameGraphics graphics(shot, timeline, 1);
    std::vector<std::uint8_t> before, after;
    for (std::int64_t frame = 0; frame < frame_count(shot.cameras, shot.timing); ++frame) {
        std::vector<std::uint8_t> drawn(std::size_t{kWidth} * kHeight * 3, 0);
        graphics.draw_annotations(plan_mixed_frame(frame, shot.cameras, shot.timing, timeline),
                                  drawn, kWidth, kHeight);
        const bool is_potted = static_cast<double>(frame) / 24 >= potted;
        std::vector<std::uint8_t>& known = is_potted ? after : before;
        if (known.empty()) {
            known = drawn;
        }
        EXPECT_EQ(drawn, known) << "frame " << frame;
    }
    ASSERT_FALSE(before.empty());
    EXPECT_NE(before, after);
    EXPECT_TRUE(std::ranges::any_of(after, [](std::uint8_t value) { return value > 200; }));
}

}  // namespace
}  // namespace carom::pipeline
