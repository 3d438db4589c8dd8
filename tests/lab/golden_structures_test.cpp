// Every structure gives the same pixels of the golden scenes.
#include <gtest/gtest.h>

#include "lab/structures/make_structure.h"
#include "tests/render/frame/golden_scenes.h"

namespace carom::render {
namespace {

class GoldenPicture : public testing::TestWithParam<test::GoldenScene> {};

// The scenes have no mesh; meshes are tested elsewhere.
TEST_P(GoldenPicture, EveryStructure_GivesTheSamePixels) {
    using Kind = AccelerationKind;
    const test::GoldenScene& golden = GetParam();
    const auto pixels_by = [&](Kind kind) {
        RenderSettings settings = golden.settings;
        settings.acceleration = kind;
        const PreparedScene prepared(golden.scene, settings, make_structure);
        return render_frame(prepared, golden.tracks, golden.frame, settings).rgba;
    };
    const std::vector<float> expected = pixels_by(Kind::brute_force);
    for (const Kind kind : {Kind::hybrid, Kind::embree, Kind::grid, Kind::octree, Kind::kd_tree,
                            Kind::kd_tree_median, Kind::bsp_tree, Kind::r_tree,
                            Kind::r_tree_hilbert, Kind::slabs, Kind::bvh, Kind::wide_bvh}) {
        EXPECT_TRUE(pixels_by(kind) == expected) << static_cast<int>(kind);
    }
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPicture, testing::ValuesIn(test::golden_scenes()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace carom::render
