// Settings that sample in different ways, for tests of frames that are not rendered in one go.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "render/film/film.h"
#include "render/scene/render_settings.h"
#include "tests/render/frame/table_scene.h"

namespace carom::test {

using render::Film;
using render::IntegratorKind;
using render::PixelFilter;
using render::RenderSettings;

inline RenderSettings settings_with_channels() {
    RenderSettings settings = small_settings(50, 37, 8);
    settings.filter = PixelFilter::blackman_harris;
    settings.filter_width = 1.5;
    settings.aovs = {"depth", "cryptomatte_object", "normal", "variance", "object_id"};
    return settings;
}

inline RenderSettings adaptive_settings() {
    RenderSettings settings = settings_with_channels();
    settings.noise = 0.02;
    settings.max_samples = 40;
    return settings;
}

inline RenderSettings distributed_settings() {
    RenderSettings settings = small_settings(40, 30, 1);
    settings.integrator = IntegratorKind::distributed;
    settings.distributed.pixel_samples = 3;
    settings.distributed.blur_samples = 2;
    settings.distributed.shadow_samples = 2;
    return settings;
}

inline RenderSettings denoiser_settings() {
    RenderSettings settings = settings_with_channels();
    settings.for_denoiser = true;
    return settings;
}

inline RenderSettings adaptive_denoiser_settings() {
    RenderSettings settings = adaptive_settings();
    settings.samples = 12;  // halves are no powers of four
    settings.for_denoiser = true;
    return settings;
}

inline void expect_same(const Film& film, const Film& expected) {
    EXPECT_EQ(film.width, expected.width);
    EXPECT_EQ(film.height, expected.height);
    EXPECT_EQ(film.rgba, expected.rgba);
    ASSERT_EQ(film.aovs.size(), expected.aovs.size());
    for (std::size_t i = 0; i < film.aovs.size(); ++i) {
        EXPECT_EQ(film.aovs[i].name, expected.aovs[i].name);
        EXPECT_EQ(film.aovs[i].values, expected.aovs[i].values) << film.aovs[i].name;
    }
    ASSERT_EQ(film.half_aovs.size(), expected.half_aovs.size());
    for (std::size_t i = 0; i < film.half_aovs.size(); ++i) {
        EXPECT_EQ(film.half_aovs[i].name, expected.half_aovs[i].name);
        EXPECT_EQ(film.half_aovs[i].bits, expected.half_aovs[i].bits) << film.half_aovs[i].name;
    }
    EXPECT_EQ(film.notes, expected.notes);
    EXPECT_EQ(film.statistics.camera_rays, expected.statistics.camera_rays);
    EXPECT_EQ(film.statistics.scattered_rays, expected.statistics.scattered_rays);
    EXPECT_EQ(film.statistics.shadow_rays, expected.statistics.shadow_rays);
}

inline std::vector<RenderSettings> ways_to_sample() {
    return {settings_with_channels(), adaptive_settings(), distributed_settings(),
            denoiser_settings(), adaptive_denoiser_settings()};
}

inline std::string name_of_way(const testing::TestParamInfo<RenderSettings>& tested) {
    return std::array{"Even", "Adaptive", "Distributed", "ForDenoiser", "AdaptiveForDenoiser"}.at(
        tested.index);
}

}  // namespace carom::test
