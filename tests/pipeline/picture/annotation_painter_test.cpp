#include "pipeline/picture/annotation_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/picture/shown_annotations.h"
#include "render/threads/thread_arena.h"
#include "tests/pipeline/picture/drawn_scene.h"

namespace carom::pipeline {
namespace {

using carom::testing::alpha_at;
using carom::testing::covered;
using carom::testing::drawn_shot;
using carom::testing::frame_at;
using carom::testing::kFov;
using carom::testing::kHeight;
using carom::testing::kRadius;
using carom::testing::kWidth;
using carom::testing::two_balls;

constexpr double kHit = 0.5;  // s; "cue" is then at the origin

/// Pixels per unit of the tangent.
const double kScale = kHeight / (2 * std::tan(kFov / 2));

DrawnPicture drawn(const Shot& shot, const PlannedFrame& frame, int threads = 1) {
    const sim::Timeline timeline = two_balls();
    AnnotationPainter painter(shot, timeline);
    render::ThreadArena arena(threads);
    return arena.execute([&] { return painter.draw({&frame, 1}, kWidth, kHeight); });
}

/// A white bar through the balls' height, `y` behind the origin, drawn as an aim line of "one".
Annotation bar(double y) {
    Annotation line;
    // "one" is at x = 0.042 when the balls touch; the line begins there and runs to the left.
    line.kind = AimAnnotation{"one", ScenePoint{{}, {-2, y, kRadius}}, {}, 1.0};
    line.width = 0.2;
    line.dash = Dash::solid;
    return line;
}

TEST(AnnotationPainter, WithoutAnnotations_DrawsNothing) {
    EXPECT_TRUE(drawn(drawn_shot(), frame_at(0)).pixels.empty());
}

TEST(AnnotationPainter, LineBehindABall_EndsAtItsEdgeWithoutHalo) {
    Shot shot = drawn_shot();
    // The line of "one" runs at y = 0.042, behind "cue", whose centre is in the middle of the
    // picture.
    shot.annotations = {bar(kRadius * std::sqrt(2.0))};
    const DrawnPicture picture = drawn(shot, frame_at(kHit));
    const int row = kHeight / 2;
    // The silhouette of a ball at distance 1: the tangent of asin(radius).
    const double edge = kScale * kRadius / std::sqrt(1 - kRadius * kRadius);
    const double left = kWidth / 2.0 - edge;
    for (int x = 2; x < kWidth / 2; ++x) {
        const double visible = std::clamp(left - x, 0.0, 1.0);
        // Samples are a quarter of a pixel apart, and the silhouette is a little bent.
        EXPECT_NEAR(alpha_at(picture, x, row), 255 * visible, 255 * 0.2) << x;
        if (x + 1 < left - 0.5) {
            EXPECT_EQ(alpha_at(picture, x, row), 255) << x << ": no halo beside the ball";
        }
        if (x > left + 0.5) {
            EXPECT_EQ(alpha_at(picture, x, row), 0) << x << ": hidden";
        }
    }
}

TEST(AnnotationPainter, HalfHiddenLine_HasTheCoverageOfItsVisibleHalf) {
    Shot shot = drawn_shot();
    shot.annotations = {bar(kRadius * std::sqrt(2.0))};
    const double hidden = covered(drawn(shot, frame_at(kHit)));
    shot.scene.objects.erase(shot.scene.objects.begin());  // without "cue", only "one" hides
    const double free = covered(drawn(shot, frame_at(kHit)));
    // The bar is 0.2 heights high with an edge of 0.0026 (at least 0.7 pixels) on both sides,
    // higher than the ball, so that the ball's disc is missing less what "one" hides anyway.
    const double radius = kScale * kRadius / std::sqrt(1 - kRadius * kRadius);
    EXPECT_LT(hidden, free);
    EXPECT_LT(free - hidden, 3.15 * radius * radius);
    EXPECT_GT(free - hidden, 0.5 * radius * radius);
}

TEST(AnnotationPainter, LineInFrontOfABall_IsWhole) {
    Shot shot = drawn_shot();
    Annotation line;
    line.kind = AimAnnotation{"cue", ScenePoint{{}, {-0.02, -0.9, kRadius}}, {}, 0.5};
    line.width = 0.05;
    line.dash = Dash::solid;
    shot.annotations = {line};
    const DrawnPicture picture = drawn(shot, frame_at(kHit));
    // Towards the camera, and a little to the left: it leaves the ball at its nearest point.
    EXPECT_GT(covered(picture), 20);
    bool is_over_ball = false;
    for (int x = kWidth / 2 - 8; x < kWidth / 2; ++x) {
        is_over_ball = is_over_ball || alpha_at(picture, x, kHeight / 2) == 255;
    }
    EXPECT_TRUE(is_over_ball);
}

TEST(AnnotationPainter, Pixels_DoNotDependOnThreadsOrEarlierFrames) {
    Shot shot = drawn_shot();
    Annotation path;
    path.kind = PathAnnotation{.of = "cue", .part = PathPart::whole, .marks = 0.05};
    Annotation label;
    label.kind = LabelAnnotation{"one", "{one.speed:.1f} m/s"};
    Annotation text;
    text.kind = TextAnnotation{"{scene_time}"};
    Annotation zone;
    zone.kind = ZoneAnnotation{{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}}, {}, {}};
    shot.annotations = {zone, path, label, text};
    PlannedFrame frame = frame_at(0.6);
    frame.camera_open.position = frame.camera_close.position = {0.3, -1, 0.4};
    const DrawnPicture one = drawn(shot, frame, 1);
    EXPECT_GT(covered(one), 100);
    EXPECT_EQ(drawn(shot, frame, 3).pixels, one.pixels);
    const sim::Timeline timeline = two_balls();
    AnnotationPainter painter(shot, timeline);
    const PlannedFrame other = frame_at(0.9);
    (void)painter.draw({&other, 1}, kWidth, kHeight);
    EXPECT_EQ(painter.draw({&frame, 1}, kWidth, kHeight).pixels, one.pixels);
}

TEST(AnnotationPainter, WidePictures_AreDrawnInParts) {
    Shot shot = drawn_shot();
    Annotation zone;
    zone.kind = ZoneAnnotation{{{-99, -99}, {99, -99}, {99, 99}, {-99, 99}}, {}, {}};
    shot.annotations = {zone};
    PlannedFrame above = frame_at(0.2);
    above.camera_open.position = above.camera_close.position = {0, -0.1, 2};
    const sim::Timeline timeline = two_balls();
    AnnotationPainter painter(shot, timeline);
    constexpr int kWide = 9000;  // more than Cairo can draw with four samples per pixel
    const DrawnPicture picture = painter.draw({&above, 1}, kWide, 40);
    const int alpha = alpha_at(picture, 4500, 20);
    EXPECT_GT(alpha, 60);
    for (const int x : {2047, 2048, 4095, 4096, 5000}) {
        EXPECT_EQ(alpha_at(picture, x, 30), alpha_at(picture, 4000, 30)) << x;
    }
}

TEST(AnnotationPainter, MissingPicture_IsFoundBeforeTheFirstFrame) {
    Shot shot = drawn_shot();
    Annotation image;
    image.kind = ImageAnnotation{"/nowhere/logo.png"};
    shot.annotations = {image};
    const sim::Timeline timeline = two_balls();
    AnnotationPainter painter(shot, timeline);
    EXPECT_THROW(painter.prepare(), Error);
}

TEST(AnnotationPainter, CrossFade_MixesBothViews) {
    Shot shot = drawn_shot();
    Annotation zone;
    zone.kind = ZoneAnnotation{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {}, {}};
    shot.annotations = {zone};
    PlannedFrame above = frame_at(0.2);
    above.camera_open.position = above.camera_close.position = {0, -1, 1};
    PlannedFrame away = frame_at(0.2);  // looks up, so that it sees no cloth
    away.camera_open.target = away.camera_close.target = {0, -1, 5};
    away.camera_open.up = away.camera_close.up = {0, 1, 0};
    const int alone = alpha_at(drawn(shot, above), 5, 5);
    EXPECT_GT(alone, 60);
    above.weight = 0.75;
    away.weight = 0.25;
    const sim::Timeline timeline = two_balls();
    AnnotationPainter painter(shot, timeline);
    const std::vector<PlannedFrame> layers{above, away};
    EXPECT_NEAR(alpha_at(painter.draw(layers, kWidth, kHeight), 5, 5), 0.75 * alone, 1.5);
}

TEST(AnnotationPainter, InSceneOnly_LeavesOutTheRest) {
    Shot shot = drawn_shot();
    Annotation text;
    text.kind = TextAnnotation{"text"};
    shot.annotations = {text};
    const sim::Timeline timeline = two_balls();
    AnnotationPainter painter(shot, timeline);
    const PlannedFrame frame = frame_at(0);
    EXPECT_TRUE(
        painter.draw({&frame, 1}, kWidth, kHeight, DrawnAnnotations::in_scene).pixels.empty());
    EXPECT_FALSE(painter.draw({&frame, 1}, kWidth, kHeight).pixels.empty());
}

TEST(OpacityAt, Fades_AreInsideTheInterval) {
    Annotation annotation;
    EXPECT_EQ(opacity_at(annotation, {}, 1e9), 1);
    annotation.opacity = 0.8;
    annotation.from = AnnotationTime{1};
    annotation.to = AnnotationTime{3};
    annotation.fade = 0.5;
    const ShownTimes times = shown_times(annotation, {});
    EXPECT_EQ(opacity_at(annotation, times, 0.99), 0);
    EXPECT_NEAR(opacity_at(annotation, times, 1.25), 0.4, 1e-12);
    EXPECT_NEAR(opacity_at(annotation, times, 2), 0.8, 1e-12);
    EXPECT_NEAR(opacity_at(annotation, times, 2.875), 0.2, 1e-12);
    EXPECT_EQ(opacity_at(annotation, times, 3.01), 0);
}

/// A camera that shows [scene_start, scene_end] during [start, end] of the film.
CameraRig showing(const Rational& start, const Rational& end, const Rational& scene_start,
                  const Rational& scene_end) {
    CameraRig rig;
    rig.video_start = start;
    rig.video_end = end;
    rig.time_map = {scene_start, scene_end};
    return rig;
}

Annotation text_from_moment(double scene_time) {
    Annotation text;
    text.kind = TextAnnotation{"text"};
    text.from = AnnotationTime{scene_time, true};
    return text;
}

// A ball is potted at 1 s of the scene. The film shows it, then twice as a replay, once of them
// backwards, and goes on.
TEST(ShownTimes, Replays_DoNotUndoWhatTheFilmHasShown) {
    const std::vector<CameraRig> rigs{showing(0, 2, 0, 2), showing(2, 6, {1, 2}, {3, 2}),
                                      showing(6, 7, {3, 2}, {1, 2}), showing(7, 9, 2, 4)};
    Annotation after = text_from_moment(1);
    EXPECT_NEAR(shown_times(after, rigs).from.value(), 1, 1e-8);
    Annotation before = after;
    std::swap(before.from, before.to);
    for (int frame = 0; frame < 9 * 24; ++frame) {
        const double time = frame / 24.0;
        const bool is_potted = frame >= 24;
        EXPECT_EQ(opacity_at(after, shown_times(after, rigs), time), is_potted ? 1 : 0) << frame;
        EXPECT_EQ(opacity_at(before, shown_times(before, rigs), time), is_potted ? 0 : 1) << frame;
    }
    // In the scene, an annotation belongs to the scene's clock and is seen in each replay.
    Annotation label = after;
    label.kind = LabelAnnotation{"cue", "text"};
    EXPECT_EQ(shown_times(label, rigs).from, 1);
}

TEST(ShownTimes, MomentThatIsLeftOut_ComesWithTheCut) {
    const std::vector<CameraRig> rigs{showing(0, 1, 0, 1), showing(1, 2, 3, 4)};
    EXPECT_NEAR(shown_times(text_from_moment(2), rigs).from.value(), 1, 1e-8);
    EXPECT_NEAR(shown_times(text_from_moment(3), rigs).from.value(), 1, 1e-8);
    EXPECT_EQ(shown_times(text_from_moment(5), rigs).from, std::numeric_limits<double>::infinity());
}

TEST(ShownTimes, SpecialTimeMaps_ReachTheMomentWhereTheyShowIt) {
    // A film that starts at the end has shown everything before.
    EXPECT_EQ(shown_times(text_from_moment(1), std::vector{showing(0, 2, 2, 0)}).from, 0);
    // A camera that begins at a moment shows it in its first frame.
    EXPECT_EQ(shown_times(text_from_moment(1), std::vector{showing(0, 2, 1, 2)}).from, 0);
    CameraRig ramp = showing(0, 4, 0, 0);
    ramp.time_map.speeds = {{Rational(0), Rational(1)}, {Rational(4), Rational(-1)}};
    // The scene time is t - t^2 / 4, at most 1 s.
    EXPECT_NEAR(shown_times(text_from_moment(0.75), std::vector{ramp}).from.value(), 1, 1e-6);
    EXPECT_EQ(shown_times(text_from_moment(1.01), std::vector{ramp}).from,
              std::numeric_limits<double>::infinity());
    // In a cross-fade the camera counts that is the stronger one.
    std::vector<CameraRig> faded{showing(0, 3, 0, 0), showing(2, 4, 2, 4)};
    faded[1].fade = 1;
    EXPECT_NEAR(shown_times(text_from_moment(2), faded).from.value(), 2.5, 1e-8);
}

/// The letters' columns that are seen, first and last; none: {0, -1}.
std::pair<int, int> columns_of(const DrawnPicture& picture) {
    int first = kWidth;
    int last = -1;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (alpha_at(picture, x, y) > 0) {
                first = std::min(first, x);
                last = std::max(last, x);
            }
        }
    }
    return {last < 0 ? 0 : first, last};
}

TEST(AnnotationPainter, LabelAtTheEdge_StaysInsideUntilItsBallLeaves) {
    Shot shot = drawn_shot();
    Annotation label;
    label.kind = LabelAnnotation{"cue", "label"};
    label.size = 0.1;
    shot.annotations = {label};
    const auto [first, last] = columns_of(drawn(shot, frame_at(0.49)));
    const int width = last - first + 1;
    // The ball's centre is 4 pixels from the left edge of the picture.
    const double half = std::tan(kFov / 2) * kWidth / kHeight;
    const auto at_left_edge = [&](double pixels) {
        return frame_at(0.5 - (half - pixels * 2 * half / kWidth) / 2);
    };
    const auto [left, right] = columns_of(drawn(shot, at_left_edge(4)));
    EXPECT_NEAR(right - left + 1, width, 1);
    EXPECT_LE(left, 1);
    const auto [cut_left, cut_right] = columns_of(drawn(shot, at_left_edge(-10)));
    EXPECT_NEAR(cut_right - cut_left + 1, width - 10, 2) << "leaves with the ball";
    EXPECT_EQ(columns_of(drawn(shot, at_left_edge(-kWidth))).second, -1);
}

TEST(AnnotationPainter, Times_AreSceneTimeInTheSceneAndVideoTimeOnThePicture) {
    Shot shot = drawn_shot();
    Annotation label;
    label.kind = LabelAnnotation{"cue", "cue"};
    label.from = AnnotationTime{0.4};
    label.to = AnnotationTime{0.6};
    Annotation text;
    text.kind = TextAnnotation{"text"};
    text.from = AnnotationTime{1.9};
    text.to = AnnotationTime{2.1};
    PlannedFrame frame = frame_at(0.5);
    frame.video_time = 0;
    shot.annotations = {label};
    EXPECT_GT(covered(drawn(shot, frame)), 0);
    shot.annotations = {text};
    EXPECT_EQ(covered(drawn(shot, frame)), 0);
    frame = frame_at(0);
    shot.annotations = {label};
    EXPECT_EQ(covered(drawn(shot, frame)), 0);
    shot.annotations = {text};
    EXPECT_GT(covered(drawn(shot, frame)), 0);
}

}  // namespace
}  // namespace carom::pipeline
