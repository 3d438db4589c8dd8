// Every structure gives the same pixels of the golden scenes.
#include <gtest/gtest.h>

#include "lab/structures/make_structure.h"
#include "tests/render/frame/golden_scenes.h"

namespace carom::render {
namespace {

class GoldenPicture : public testing::TestWithParam<test::GoldenScene> {};

// The scenes have no mesh; meshes are tested elsewhere.
TEST_P(GoldenPicture, EveryStructure_GivesTheSamePixels) {
    const test::GoldenScene& golden = GetParam();
    const auto pixels_by = [&](AccelerationKind kind) {
        const PreparedScene prepared(golden.scene, golden.settings, structure_maker(kind));
        return render_frame(prepared, golden.tracks, golden.frame, golden.settings).rgba;
    };
    const std::vector<float> expected = pixels_by(AccelerationKind::brute_force);
    for (const AccelerationName& known : kAccelerationNames) {
        EXPECT_TRUE(pixels_by(known.kind) == expected) << known.name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPicture, testing::ValuesIn(test::golden_scenes()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace carom::render
