// Frames of the distributed integrator.
#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/frame/check_settings.h"
#include "render/threads/thread_arena.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

using test::SceneBuilder;
using testing::HasSubstr;

/// Balls of every kind, one of them moving, under lamps; the floor is a layered surface.
SceneBuilder scene() {
    PhongMaterial amber;
    amber.diffuse = Vec3(0.6, 0.3, 0.02);
    amber.specular = Vec3(0.6, 0.6, 0.6);
    amber.reflectance = Vec3(0.2, 0.2, 0.2);
    amber.reflectance_spread = 0.2;
    PhongMaterial glass;
    glass.diffuse = Vec3(0, 0, 0);
    glass.reflectance = Vec3(0.1, 0.1, 0.1);
    glass.transmittance = Vec3(0.9, 0.9, 0.9);
    glass.transmittance_spread = 0.05;
    StandardMaterial wood;
    wood.base = WoodTexture{};
    wood.coat.weight = 1;
    SceneBuilder builder;
    builder.phong("amber", amber).phong("glass", glass).material("wood", wood);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "wood");
    builder.sphere("a", 0.03, Vec3(0, 0, 0), "amber", "a");
    builder.sphere("b", 0.03, Vec3(0.07, 0.06, 0.03), "glass");
    builder.lamp(Vec3(0, 0, 1), 0.4, 0.2, 20).bulb(Vec3(0.5, 0.5, 0.6), 0.05, 30).environment(0.1);
    return builder;
}

FrameInput frame(double lens_radius) {
    CameraState state = test::camera(Vec3(-0.1, -0.4, 0.2), Vec3(0.02, 0, 0.02), 0.6);
    state.lens_radius = lens_radius;
    FrameInput frame = test::static_frame(state);
    frame.scene_close = 0.02;
    frame.switch_ratio = 0.2;
    return frame;
}

Film rendered(const RenderSettings& settings, const FrameInput& input, int threads = 2) {
    const PreparedScene prepared(scene().scene, settings);
    const std::vector<sim::Track> tracks{
        test::straight_track("a", Vec3(-0.05, 0, 0.03), Vec3(0.02, 0, 0.03), 0, 0.02)};
    ThreadArena arena(threads);
    Film film;
    arena.execute([&] { film = render_frame(prepared, tracks, input, settings); });
    return film;
}

RenderSettings distributed(int width, int height) {
    RenderSettings settings = test::small_settings(width, height, 1);
    settings.integrator = IntegratorKind::distributed;
    settings.filter = PixelFilter::gaussian;
    settings.filter_width = 2;
    settings.distributed.pixel_samples = 2;
    settings.distributed.blur_samples = 2;
    settings.distributed.lens_samples = 2;
    settings.distributed.shadow_samples = 2;
    settings.distributed.reflection_samples = 2;
    settings.distributed.refraction_samples = 2;
    return settings;
}

RenderSettings whitted(int width, int height) {
    RenderSettings settings = distributed(width, height);
    settings.distributed.pixel_samples = settings.distributed.blur_samples = 1;
    settings.distributed.lens_samples = settings.distributed.shadow_samples = 1;
    settings.distributed.reflection_samples = settings.distributed.refraction_samples = 1;
    return settings;
}

TEST(DistributedFrame, OneThreadAndTwo_GiveTheSameBitsAndCounts) {
    const RenderSettings settings = distributed(50, 35);
    const Film one = rendered(settings, frame(0.004), 1);
    const Film two = rendered(settings, frame(0.004), 2);
    EXPECT_EQ(one.rgba, two.rgba);
    EXPECT_EQ(one.statistics.camera_rays, 50u * 35u * 8u);
    EXPECT_GT(one.statistics.refraction_rays, 0u);
    EXPECT_EQ(one.statistics.scattered_rays,
              one.statistics.reflection_rays + one.statistics.refraction_rays);
    EXPECT_EQ(one.statistics.scattered_rays, two.statistics.scattered_rays);
    EXPECT_EQ(one.statistics.shadow_rays, two.statistics.shadow_rays);
    for (const float value : one.rgba) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0);
    }
}

TEST(DistributedFrame, AllCountsAtOne_IsOnePictureWhateverSeedAndThreads) {
    const RenderSettings settings = whitted(50, 35);
    FrameInput input = frame(0);
    const Film first = rendered(settings, input, 1);
    EXPECT_EQ(first.statistics.camera_rays, 50u * 35u);
    input.seed = 99;
    EXPECT_EQ(rendered(settings, input, 2).rgba, first.rgba);
    // A count above one does change the picture.
    RenderSettings soft = settings;
    soft.distributed.shadow_samples = 2;
    FrameInput other = input;
    other.seed = 1;
    EXPECT_NE(rendered(soft, input).rgba, rendered(soft, other).rgba);
}

TEST(DistributedFrame, ACountOfOne_SwitchesItsEffectOff) {
    const RenderSettings settings = whitted(40, 30);
    const Film sharp = rendered(settings, frame(0));
    EXPECT_EQ(rendered(settings, frame(0.01)).rgba, sharp.rgba);  // no lens
    FrameInput instant = frame(0);
    instant.scene_open = instant.scene_close = 0.01;
    const Film frozen = rendered(settings, instant);  // no blur: the shutter's middle
    for (std::size_t i = 0; i < sharp.rgba.size(); ++i) {
        ASSERT_NEAR(frozen.rgba[i], sharp.rgba[i], 1e-3f + 0.01f * sharp.rgba[i]) << i;
    }
    RenderSettings with_lens = settings;
    with_lens.distributed.lens_samples = 4;
    EXPECT_NE(rendered(with_lens, frame(0.01)).rgba, sharp.rgba);
    RenderSettings with_blur = settings;
    with_blur.distributed.blur_samples = 4;
    EXPECT_NE(rendered(with_blur, frame(0)).rgba, sharp.rgba);
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(DistributedSettings, OutOfRange_AreSentences) {
    RenderSettings settings = distributed(8, 8);
    settings.distributed.shadow_samples = 0;
    settings.distributed.recursion_limit = 33;
    settings.distributed.ambient_coefficient = -1;
    settings.distributed.pixel_samples = 1024;
    settings.distributed.lens_samples = 1024;
    EXPECT_EQ(find_problems(settings, RayBranches{}).size(), 4u);
    settings.integrator = IntegratorKind::path;  // which ignores them
    EXPECT_EQ(find_problems(settings, RayBranches{}).size(), 0u);
}

TEST(DistributedSettings, TreesWithoutEnd_AreRefused) {
    RenderSettings settings = whitted(8, 8);
    settings.distributed.recursion_limit = 30;
    EXPECT_THAT(message_of([&] { rendered(settings, frame(0)); }),
                HasSubstr("lower 'recursion_limit'"));
}

TEST(PhongMaterial, WithThePathIntegrator_IsTaken) {
    EXPECT_EQ(message_of([&] { rendered(test::small_settings(8, 8, 1), frame(0)); }), "no error");
}

}  // namespace
}  // namespace carom::render
