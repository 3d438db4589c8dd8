// Low-poly meshes whose normals make them look round, and normals of any quality.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

constexpr int kAround = 12;
constexpr int kRings = 8;

/// A ball of 168 triangles. `inside_out`: the normals point inwards.
MeshShape low_ball(bool inside_out = false) {
    MeshShape mesh;
    for (int i = 0; i <= kRings; ++i) {
        for (int j = 0; j < kAround; ++j) {
            const double theta = std::numbers::pi * i / kRings;
            const double phi = 2 * std::numbers::pi * j / kAround;
            const Vec3 up(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          std::cos(theta));
            mesh.vertices.push_back(0.5 * up);
            mesh.normals.push_back(inside_out ? -up : up);
        }
    }
    const auto at = [](int i, int j) {
        return static_cast<std::uint32_t>(i * kAround + j % kAround);
    };
    for (int i = 0; i < kRings; ++i) {
        for (int j = 0; j < kAround; ++j) {
            if (i > 0) {
                mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            }
            if (i + 1 < kRings) {
                mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
            }
        }
    }
    return mesh;
}

const Vec3 kToLight = Vec3(1, -0.3, 0.4).normalized();
constexpr double kAlbedo = 0.6;

Film picture_of(const Shape& shape) {
    RenderSettings settings = test::small_settings(120, 120, 4);
    settings.aovs = {"normal", "object_id"};
    settings.max_bounces = 0;
    test::SceneBuilder builder;
    builder.diffuse("clay", kAlbedo).object("ball", shape, Vec3(0, 0, 0), "clay");
    builder.scene.lights.push_back({"sun", DirectionalLight{-kToLight, Vec3(3, 3, 3)}});
    return render_frame(PreparedScene(builder.scene, settings), {},
                        test::static_frame(test::camera(Vec3(0, -3, 0), Vec3(0, 0, 0), 0.4)),
                        settings);
}

/// Pixels inside the ball that are unlike the light that its round surface would get there.
struct Unlike {
    int too_dark = 0;   // although the surface sees the light
    int too_light = 0;  // although it does not
    int pixels = 0;
};
Unlike unlike_round(const Film& film) {
    Unlike unlike;
    const auto& x = test::plane(film, "N.X");
    const auto& y = test::plane(film, "N.Y");
    const auto& z = test::plane(film, "N.Z");
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 normal(Imath::V3f(x[i], y[i], z[i]));
        // Pixels at an edge mix normals.
        if (normal.length() < 0.97 || normal.y > -0.3) {
            continue;
        }
        const double cosine = normal.dot(kToLight) / normal.length();
        const double light = kAlbedo / std::numbers::pi * 3 * std::max(cosine, 0.0);
        const auto seen = static_cast<double>(film.rgba[4 * i]);
        unlike.pixels += 1;
        unlike.too_dark += seen < 0.85 * light - 0.02 ? 1 : 0;
        unlike.too_light += seen > 1.15 * light + 0.02 ? 1 : 0;
    }
    return unlike;
}

// Without the rise of rays' starts, triangles that face away from the light are dark where the
// round surface is lit: a saw-tooth edge.
TEST(SmoothMesh, ShadowEdge_IsThatOfTheRoundSurface) {
    const Unlike unlike = unlike_round(picture_of(low_ball()));
    EXPECT_GT(unlike.pixels, 2'000);
    EXPECT_LE(unlike.too_dark, unlike.pixels / 500);
    EXPECT_LE(unlike.too_light, unlike.pixels / 500);
}

TEST(SmoothMesh, NormalsThatPointInwards_SamePicture) {
    const Film round = picture_of(low_ball());
    const Film inside_out = picture_of(low_ball(true));
    EXPECT_EQ(round.rgba, inside_out.rgba);
}

TEST(SmoothMesh, BadNormals_PictureOfARoundBall) {
    MeshShape mesh = low_ball();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Vec3 good = mesh.normals[i];
        const Vec3 bad[] = {Vec3(0, 0, 0), -good, 1e-3 * good,      1e6 * good,
                            good,          good,  Vec3(kNan, 0, 1), good};
        mesh.normals[i] = bad[i % 8];
    }
    const Film film = picture_of(mesh);
    for (const float value : film.rgba) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0);
    }
    const Film good = picture_of(low_ball());
    double difference = 0;
    double sum = 0;
    for (std::size_t i = 0; i < film.rgba.size(); ++i) {
        difference += static_cast<double>(std::abs(film.rgba[i] - good.rgba[i]));
        sum += static_cast<double>(good.rgba[i]);
    }
    EXPECT_LT(difference / sum, 0.03);
}

}  // namespace
}  // namespace carom::render
