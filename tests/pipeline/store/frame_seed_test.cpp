#include "pipeline/store/frame_seed.h"

#include <set>

#include <gmock/gmock.h>

#include "render/frame/frame_fields.h"
#include "tests/core/field_changes.h"

namespace carom::pipeline {
namespace {

/// A frame with a moving camera and a moving scene.
render::FrameInput sample_frame() {
    render::FrameInput frame;
    frame.scene_open = 0.4;
    frame.scene_close = 0.42;
    frame.camera_close.position.x = 0.01;
    return frame;
}

TEST(FrameSeed, RenderSeed_ChangesIt) {
    EXPECT_NE(frame_seed(0, sample_frame()), frame_seed(1, sample_frame()));
}

// The shutter's switch ratio and the previous seed do not belong to what the frame shows.
TEST(FrameSeed, EveryFieldOfTimeAndCamera_ChangesIt) {
    render::FrameInput frame = sample_frame();
    std::set<std::uint64_t> seen{frame_seed(5, frame)};
    carom::test::FieldChanges([&](const std::string& place, bool) {
        EXPECT_EQ(seen.insert(frame_seed(5, frame)).second,
                  place != ".switch_ratio" && place != ".seed")
            << place;
    }).of(frame);
    EXPECT_EQ(seen.size(), 1U + 2 + 2 * (3 * 3 + 6 + 1 + 4));
}

}  // namespace
}  // namespace carom::pipeline
