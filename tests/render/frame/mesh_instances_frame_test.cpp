// Pictures of objects that share a mesh, compared with those of copies.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/render/frame_scene/mesh_copies.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

/// Three rows of turned and stretched bodies on a floor; the last row moves. Some shine.
test::SceneBuilder bodies(const ColourSource& colour) {
    test::SceneBuilder builder;
    StandardMaterial patterned;
    patterned.base = colour;
    patterned.coat.weight = 1;
    StandardMaterial shining;
    shining.emission = Vec3(2, 1, 0.5);
    builder.material("patterned", patterned).material("shining", shining).diffuse("grey", 0.5);
    builder.object("floor", PlaneShape{}, Vec3(0), "grey");
    const MeshShape mesh = test::bumpy_mesh(50, 0.1);
    for (int i = 0; i < 18; ++i) {
        const double angle = 0.4 * i;
        Mat44 map;
        map.setScale(Vec3(1, i % 2 == 0 ? -0.8 : 0.7, 1.2));
        map = map *
              Quat(std::cos(angle), 0, 0.6 * std::sin(angle), 0.8 * std::sin(angle)).toMatrix44();
        const int row = i / 6;
        if (row < 2) {
            map = map * test::moved_to(Vec3(0.3 * (i % 6) - 0.75, 0.4 * row, 0.15));
        }
        builder.scene.objects.push_back({"body" + std::to_string(i), mesh, map,
                                         row < 2 ? "" : "track" + std::to_string(i),
                                         i % 5 == 1 ? "shining" : "patterned"});
    }
    builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.3, 12).environment(0.2);
    return builder;
}

std::vector<sim::Track> tracks() {
    std::vector<sim::Track> tracks;
    for (int i = 12; i < 18; ++i) {
        const double x = 0.3 * (i % 6) - 0.75;
        tracks.push_back(test::straight_track("track" + std::to_string(i), Vec3(x, -0.4, 0.15),
                                              Vec3(x + 0.05, -0.4, 0.18), 0, 0.02));
    }
    return tracks;
}

void expect_picture_of_copies(const ColourSource& colour) {
    RenderSettings settings = test::small_settings(96, 64, 16);
    settings.aovs = {"depth", "normal", "albedo", "object_id"};
    const test::SceneBuilder builder = bodies(colour);
    FrameInput frame = test::static_frame(test::camera(Vec3(0, -1.6, 1), Vec3(0, 0, 0.1), 0.8));
    frame.scene_close = 0.02;
    const auto render_with = [&](const StructureMaker& maker) {
        return render_frame(PreparedScene(builder.scene, settings, maker), tracks(), frame,
                            settings);
    };
    const Film shared = render_with({});
    const Film copied = render_with(test::copying_maker());
    // The same paths, except for those that rounding sends past an edge.
    double sum = 0;
    double difference = 0;
    ASSERT_EQ(shared.rgba.size(), copied.rgba.size());
    for (std::size_t i = 0; i < shared.rgba.size(); ++i) {
        sum += static_cast<double>(copied.rgba[i]);
        difference += static_cast<double>(std::abs(shared.rgba[i] - copied.rgba[i]));
    }
    EXPECT_LT(difference / sum, 5e-3);
    for (std::size_t k = 0; k < shared.aovs.size(); ++k) {
        int unlike = 0;
        for (std::size_t i = 0; i < shared.aovs[k].values.size(); ++i) {
            const float a = shared.aovs[k].values[i];
            const float b = copied.aovs[k].values[i];
            unlike += a == b || std::abs(a - b) <= 1e-3f * (1 + std::abs(b)) ? 0 : 1;
        }
        EXPECT_LE(unlike, 30) << shared.aovs[k].name;
    }
}

TEST(MeshInstances, PatternInTheirOwnAxes_PictureOfCopies) {
    expect_picture_of_copies(CheckerTexture{});
}

TEST(MeshInstances, PlainColour_PictureOfCopies) {
    expect_picture_of_copies(Vec3(0.7, 0.3, 0.2));
}

}  // namespace
}  // namespace carom::render
