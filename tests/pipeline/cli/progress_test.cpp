#include <gtest/gtest.h>

#include "pipeline/cli/terminal/progress_meter.h"
#include "pipeline/cli/terminal/progress_text.h"

namespace carom::cli {
namespace {

ProgressSnapshot rendering() {
    ProgressSnapshot snapshot;
    snapshot.stage = "render";
    snapshot.fraction = 0.3;
    snapshot.frames_total = 240;
    snapshot.frames_done = 72;
    snapshot.elapsed = 34;
    snapshot.left = 80;
    snapshot.rays_rate = 8.123e6;
    return snapshot;
}

TEST(ProgressBar, WideTerminal_ShowsEverything) {
    EXPECT_EQ(progress_bar(rendering(), 100),
              "render [============>                           ]   72/240   30 %  1 min 20 s left  "
              "8.12 Mrays/s");
}

TEST(ProgressBar, NarrowTerminal_OmitsTheLeastImportantTexts) {
    const std::string bar = progress_bar(rendering(), 60);
    EXPECT_EQ(bar, "render [=====>            ]   72/240   30 %  1 min 20 s left");
    for (int columns = 1; columns < 120; ++columns) {
        EXPECT_LE(progress_bar(rendering(), columns).size(), static_cast<std::size_t>(columns));
    }
}

TEST(ProgressBar, Ends_AreEmptyAndFull) {
    ProgressSnapshot snapshot;
    snapshot.stage = "bake";
    EXPECT_EQ(progress_bar(snapshot, 30), "bake [>               ]    0 %");
    snapshot.fraction = 1;
    EXPECT_EQ(progress_bar(snapshot, 30), "bake [================]  100 %");
}

TEST(ProgressLine, Snapshot_IsFormattedAsALine) {
    ProgressSnapshot snapshot = rendering();
    EXPECT_EQ(progress_line(snapshot),
              "render: 72 of 240 frames (30 %), 1 min 20 s left, 8.12 Mrays/s");
    snapshot.frames_found = 12;
    snapshot.left.reset();
    snapshot.rays_rate.reset();
    EXPECT_EQ(progress_line(snapshot), "render: 72 of 240 frames (30 %, 12 stored or shown again)");
    snapshot = {};
    snapshot.stage = "bake";
    snapshot.fraction = 0.999;
    EXPECT_EQ(progress_line(snapshot), "bake: 99 %");
}

TEST(ProgressJson, Snapshot_HasAllNumbers) {
    EXPECT_EQ(progress_json(rendering()).object(),
              R"({"stage":"render","fraction":0.3,"frames_total":240,"frames_done":72,)"
              R"("frames_found":0,"seconds_elapsed":34,"seconds_left":80,)"
              R"("rays_per_second":8123000})");
}

TEST(ProgressMeter, FoundFrames_DoNotShortenTheEstimate) {
    ProgressMeter meter;
    meter.expect_frames(10);
    meter.on_progress("bake", 1, 100);
    for (int i = 0; i < 4; ++i) {
        meter.on_frame(true, 0, 200);
    }
    EXPECT_FALSE(meter.snapshot(200).left.has_value());
    meter.on_frame(false, 1000, 202);
    meter.on_frame(false, 3000, 204);
    const ProgressSnapshot snapshot = meter.snapshot(204);
    EXPECT_EQ(snapshot.stage, "render");
    EXPECT_EQ(snapshot.frames_done, 6);
    EXPECT_EQ(snapshot.frames_found, 4);
    EXPECT_DOUBLE_EQ(snapshot.fraction, 0.6);
    EXPECT_DOUBLE_EQ(snapshot.left.value(), 8);  // 2 s each for the 4 that are missing
    EXPECT_DOUBLE_EQ(snapshot.rays_rate.value(), 1000);
    EXPECT_DOUBLE_EQ(meter.snapshot(205).rays_rate.value(), 1000);  // until the next frame
}

TEST(ProgressMeter, FrameInProgress_CountsByItsFraction) {
    ProgressMeter meter;
    meter.expect_frames(10);
    meter.on_progress("render", 0, 100);
    meter.on_progress("render", 0.05, 101);  // half a frame
    EXPECT_DOUBLE_EQ(meter.snapshot(101).left.value(), 19);
    meter.on_frame(false, 1, 102);
    EXPECT_DOUBLE_EQ(meter.snapshot(102).left.value(), 18);
}

TEST(ProgressMeter, FractionWithoutFrames_GivesAnEstimate) {
    ProgressMeter meter;
    meter.on_progress("bake", 0, 10);
    EXPECT_FALSE(meter.snapshot(11).left.has_value());
    meter.on_progress("bake", 0.25, 12);
    EXPECT_DOUBLE_EQ(meter.snapshot(12).left.value(), 6);
    meter.on_progress("bake", 0.2, 13);  // the fraction never decreases
    EXPECT_DOUBLE_EQ(meter.snapshot(13).fraction, 0.25);
    meter.on_progress("encode", 0, 20);  // a new stage starts at 0
    EXPECT_DOUBLE_EQ(meter.snapshot(20).fraction, 0);
    EXPECT_EQ(meter.snapshot(20).frames_total, 0);
}

}  // namespace
}  // namespace carom::cli
