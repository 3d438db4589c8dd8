// Annotations follow the distortion of the lens.
#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include "pipeline/picture/placed_shapes.h"
#include "render/camera/thin_lens_camera.h"
#include "tests/pipeline/picture/drawn_scene.h"

namespace carom::pipeline {
namespace {

constexpr int kWide = 1600;
constexpr int kHigh = 900;

PlannedFrame bent_frame(double distortion) {
    PlannedFrame frame = carom::testing::frame_at(0);
    frame.camera_open.lens = render::LensShape{.distortion = distortion};
    frame.camera_close = frame.camera_open;
    return frame;
}

/// Where the renderer's camera has a point.
Vec2 rendered(const PlannedFrame& frame, const Vec3& point) {
    const render::ThinLensCamera camera(frame.camera_open, frame.camera_close, kWide, kHigh, 0,
                                        render::PixelFilter::box, 1);
    return Vec2(*camera.project(Imath::V3f(point), 0.5F));
}

TEST(BentPinhole, ProjectsAsTheRendererDoesAndBack) {
    for (const double distortion : {-0.1, 0.1}) {
        const PlannedFrame frame = bent_frame(distortion);
        const Pinhole view(frame, kWide, kHigh);
        for (const Vec3& point :
             {Vec3(-0.2, -0.1, 0.1), Vec3(0.1, 0.5, -0.05), Vec3(0, 0, 0), Vec3(0.05, 1, 0.3)}) {
            const Vec2 place = view.project(point).place;
            EXPECT_NEAR((place - rendered(frame, point)).length(), 0, 2e-2);
            const Vec3 along = view.direction(place);
            EXPECT_NEAR((view.position() + view.depth(point) * along - point).length(), 0, 1e-9);
        }
    }
}

std::vector<PlacedShape> placed(const SceneShape& shape, const Pinhole& view) {
    Fonts fonts;
    return placed_shapes({shape}, view, fonts);
}

TEST(BentShapes, StraightLine_IsWhereTheRendererHasItsPoints) {
    const PlannedFrame frame = bent_frame(-0.1);
    const Pinhole view(frame, kWide, kHigh);
    SceneLine line;
    line.points = {Vec3(-0.3, 0.2, 0.14), Vec3(0.3, 0.4, 0.12)};
    const auto shapes = placed(line, view);
    const auto& points = std::get<PlacedLine>(shapes.at(0)).points;
    ASSERT_GT(points.size(), 40U);
    EXPECT_NEAR((points.front().place - rendered(frame, line.points[0])).length(), 0, 2e-2);
    EXPECT_NEAR((points.back().place - rendered(frame, line.points[1])).length(), 0, 2e-2);
    for (const PlacedPoint& point : points) {
        const Vec3 there = view.position() + view.direction(point.place) / point.inverse_depth;
        const Vec3 way = (line.points[1] - line.points[0]).normalized();
        EXPECT_NEAR((there - line.points[0]).cross(way).length(), 0, 1e-9);
    }
}

TEST(BentShapes, StraightLineWithoutDistortion_HasTwoPoints) {
    const Pinhole view(bent_frame(0), kWide, kHigh);
    SceneLine line;
    line.points = {Vec3(-0.3, 0.2, 0.14), Vec3(0.3, 0.4, 0.12)};
    const auto shapes = placed(line, view);
    EXPECT_EQ(std::get<PlacedLine>(shapes.at(0)).points.size(), 2U);
}

TEST(BentShapes, ClosedLine_IsBentOnItsLastSide) {
    const Pinhole view(bent_frame(-0.1), kWide, kHigh);
    SceneLine line;
    line.points = {Vec3(-0.2, 0, 0.1), Vec3(0.2, 0, 0.1), Vec3(0, 0, -0.1)};
    line.is_closed = true;
    const auto shapes = placed(line, view);
    const auto& points = std::get<PlacedLine>(shapes.at(0)).points;
    double longest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 way = points[(i + 1) % points.size()].place - points[i].place;
        longest = std::max(longest, way.length());
    }
    EXPECT_LT(longest, 1.2 * kHigh / 40);
}

TEST(BentShapes, Area_HasTheDepthOfItsPlaneEverywhere) {
    const Pinhole view(bent_frame(-0.1), kWide, kHigh);
    SceneArea area;
    area.corners = {Vec3(-0.3, 0, 0), Vec3(0.3, 0, 0), Vec3(0.3, 1, 0), Vec3(-0.3, 1, 0)};
    const auto shapes = placed(area, view);
    const auto& flat = std::get<PlacedArea>(shapes.at(0));
    for (const Vec3& point : {Vec3(-0.25, 0.9, 0), Vec3(0.2, 0.1, 0), Vec3(0, 0.5, 0)}) {
        const SeenPoint seen = view.project(point);
        EXPECT_NEAR(flat.constant + flat.slope.dot(flat.bend.straight(seen.place)),
                    seen.inverse_depth, 1e-9);
    }
}

}  // namespace
}  // namespace carom::pipeline
