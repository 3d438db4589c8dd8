#include "pipeline/picture/lit_annotations.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/picture/colours.h"
#include "pipeline/picture/track_line.h"
#include "tests/pipeline/picture/drawn_scene.h"

namespace carom::pipeline {
namespace {

using carom::testing::covered;
using carom::testing::drawn_shot;
using carom::testing::frame_at;
using carom::testing::kHeight;
using carom::testing::kRadius;
using carom::testing::kWidth;
using carom::testing::two_balls;

constexpr double kDiameter = 0.01;  // m

Shot shot_with(AnnotationKind kind) {
    Shot shot = drawn_shot();
    Annotation annotation;
    annotation.kind = std::move(kind);
    annotation.lit = kDiameter;
    annotation.dash = Dash::solid;
    shot.annotations = {annotation};
    return shot;
}

const render::MeshShape& mesh_of(const Shot& shot) {
    return std::get<render::MeshShape>(shot.scene.objects.back().shape);
}

double distance_to(const Vec3& point, const std::vector<LinePoint>& line) {
    double least = 1e300;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 way = line[i].position - line[i - 1].position;
        const Vec3 from = point - line[i - 1].position;
        const double u = std::clamp(from.dot(way) / std::max(way.dot(way), 1e-12), 0.0, 1.0);
        least = std::min(least, (from - u * way).length());
    }
    return least;
}

TEST(LitAnnotations, Path_IsATubeAlongTheWay) {
    Shot shot = shot_with(PathAnnotation{.of = "cue", .part = PathPart::whole});
    const sim::Timeline timeline = two_balls();
    add_lit_annotations(shot, timeline);
    ASSERT_EQ(shot.scene.objects.size(), 3U);
    EXPECT_EQ(shot.scene.objects.back().name, "annotations[0]");
    EXPECT_TRUE(shot.scene.objects.back().track.empty());
    const render::MeshShape& mesh = mesh_of(shot);
    ASSERT_EQ(mesh.vertices.size(), mesh.normals.size());
    const std::vector<LinePoint> way = track_line(*timeline.find("cue"), 0, 1);
    double farthest = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const double distance = distance_to(mesh.vertices[i], way);
        EXPECT_LE(distance, kDiameter / 2 + 1e-9) << i;
        EXPECT_NEAR(mesh.normals[i].length(), 1, 1e-12) << i;
        farthest = std::max(farthest, mesh.vertices[i].x);
    }
    // The ends are round, and the corner at the contact reaches beyond it.
    EXPECT_GT(farthest, 0.9 * kDiameter / 2);
    const render::MaterialDescription& material = shot.scene.materials.back();
    EXPECT_EQ(material.name, shot.scene.objects.back().material);
    EXPECT_EQ(std::get<Vec3>(material.surface.base), 0.85 * path_colour(0));
}

TEST(LitAnnotations, LineOnTheCloth_LiesOnIt) {
    Shot shot = shot_with(PathAnnotation{.of = "cue", .part = PathPart::whole, .on_cloth = true});
    add_lit_annotations(shot, two_balls());
    double lowest = 1;
    for (const Vec3& vertex : mesh_of(shot).vertices) {
        lowest = std::min(lowest, vertex.z);
    }
    EXPECT_NEAR(lowest, 0, 2e-4);
}

TEST(LitAnnotations, GhostBall_IsThreeCirclesOfItsSize) {
    Shot shot = shot_with(GhostAnnotation{"cue", "one"});
    add_lit_annotations(shot, two_balls());
    double highest = 0;
    for (const Vec3& vertex : mesh_of(shot).vertices) {
        const Vec3 from(vertex.x, vertex.y, vertex.z - kRadius);
        if (vertex.z > 2 * kDiameter) {  // what is lower is raised above the cloth
            EXPECT_NEAR(from.length(), kRadius, kDiameter / 2 + 1e-4);
        }
        highest = std::max(highest, vertex.z);
    }
    EXPECT_NEAR(highest, 2 * kRadius + kDiameter / 2, 2e-4);
}

TEST(LitAnnotations, Objects_AreAddedOnce) {
    Shot shot = shot_with(TangentAnnotation{"cue", "one", 0.5});
    shot.annotations.emplace_back().kind = LabelAnnotation{"cue", "not lit"};
    add_lit_annotations(shot, two_balls());
    add_lit_annotations(shot, two_balls());
    EXPECT_EQ(shot.scene.objects.size(), 3U);
    EXPECT_EQ(shot.scene.materials.size(), 2U);
}

TEST(LitAnnotations, BallsThatNeverTouch_AddNothing) {
    Shot shot = shot_with(GhostAnnotation{"one", "eight"});
    add_lit_annotations(shot, two_balls());
    EXPECT_EQ(shot.scene.objects.size(), 2U);
}

TEST(LitAnnotations, OnThePicture_OnlyTextsAreDrawn) {
    const sim::Timeline timeline = two_balls();
    const PlannedFrame frame = frame_at(0);
    const auto drawn = [&](AnnotationKind kind) {
        const Shot shot = shot_with(std::move(kind));
        return covered(AnnotationPainter(shot, timeline).draw({&frame, 1}, kWidth, kHeight));
    };
    EXPECT_EQ(drawn(PathAnnotation{.of = "cue", .part = PathPart::whole}), 0);
    EXPECT_GT(drawn(AngleAnnotation{.deflection = {"cue", "one"}}), 10);
}

}  // namespace
}  // namespace carom::pipeline
