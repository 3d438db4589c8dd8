#include "render/frame/denoiser_planes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <Imath/half.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/denoise/denoise.h"
#include "tests/render/frame/table_scene.h"
#include "tests/render/frame/ways_to_sample.h"

namespace carom::render {
namespace {

using test::table;
using test::table_frame;
using test::table_tracks;

std::vector<float> channel(const Film& film, const std::string& name) {
    std::vector<float> values;
    for (const HalfChannel& known : film.half_aovs) {
        if (known.name == name) {
            std::ranges::transform(known.bits, std::back_inserter(values), imath_half_to_float);
            return values;
        }
    }
    return test::plane(film, name);
}

RenderSettings settings_of(int samples, bool for_denoiser) {
    RenderSettings settings = test::small_settings(64, 48, samples);
    settings.filter = PixelFilter::blackman_harris;
    settings.filter_width = 1.5;
    settings.for_denoiser = for_denoiser;
    return settings;
}

Film rendered(const RenderSettings& settings) {
    const PreparedScene scene(table().scene, settings);
    return render_frame(scene, table_tracks(), table_frame(), settings);
}

/// The mean of (x - r)^2 / (r^2 + 0.01) over pixels and colours.
double relative_error(const Film& film, const Film& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < film.rgba.size(); ++i) {
        if (i % 4 != 3) {
            const auto r = static_cast<double>(reference.rgba[i]);
            const double d = static_cast<double>(film.rgba[i]) - r;
            sum += d * d / (r * r + 0.01);
        }
    }
    return sum / (0.75 * static_cast<double>(film.rgba.size()));
}

// The first half of the samples is that of a frame of half as many, with the same seed.
TEST(DenoiserPlanes, FirstHalf_IsFrameOfHalfTheSamples) {
    RenderSettings settings = settings_of(8, false);
    settings.aovs = {"albedo", "normal"};
    const Film first = rendered(settings);
    const Film both = rendered(settings_of(16, true));
    const std::string letters = "RGB";
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float> half = channel(both, std::string("half.") + letters[c]);
        double differences = 0;
        for (std::size_t i = 0; i < half.size(); ++i) {
            const float a = both.rgba[4 * i + c] + half[i];
            ASSERT_NEAR(a, first.rgba[4 * i + c], 1e-5f + std::abs(half[i]) / 7) << i;
            differences += std::abs(static_cast<double>(half[i]));
        }
        EXPECT_GT(differences / static_cast<double>(half.size()), 1e-3);
    }
    const std::vector<float> upright = channel(first, "N.Z");
    for (const std::string name : {"albedo.R", "albedo.B", "normal.Y", "normal.Z"}) {
        const std::string stored = name.starts_with("normal") ? "N" + name.substr(6) : name;
        const std::vector<float> expected = channel(first, stored);
        const std::vector<float> exact = channel(both, "exact_" + name);
        const std::vector<float> error = channel(both, "error_" + name);
        const std::vector<float> half = channel(both, "half_" + name);
        int mirroring = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const float bound = 3e-3f + (std::abs(half[i]) + std::abs(error[i])) / 16;
            const float found = exact[i] + error[i] + half[i];
            // Coats, which only the balls have, add what is seen in them.
            if (name.starts_with("albedo") && upright[i] < 0.9999f) {
                ASSERT_GE(found, expected[i] - bound) << name << " " << i;
                mirroring += found > expected[i] + bound ? 1 : 0;
            } else {
                ASSERT_NEAR(found, expected[i], bound) << name << " " << i;
            }
        }
        EXPECT_EQ(mirroring > 10, name.starts_with("albedo")) << name << " " << mirroring;
    }
}

TEST(DenoiserPlanes, ExactFeatures_AreCloserToTheTruthThanTheSamples) {
    RenderSettings many = settings_of(1024, false);
    many.aovs = {"albedo", "normal"};
    many.max_bounces = 0;
    const Film reference = rendered(many);
    const Film film = rendered(settings_of(8, true));
    for (const std::string name : {"albedo.G", "normal.X", "normal.Z"}) {
        const std::string stored = name.starts_with("normal") ? "N" + name.substr(6) : name;
        const std::vector<float> truth = channel(reference, stored);
        const std::vector<float> exact = channel(film, "exact_" + name);
        const std::vector<float> error = channel(film, "error_" + name);
        double of_exact = 0;
        double of_samples = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const auto d = static_cast<double>(exact[i] - truth[i]);
            const auto e = static_cast<double>(exact[i] + error[i] - truth[i]);
            of_exact += d * d;
            of_samples += e * e;
        }
        EXPECT_LT(6 * of_exact, of_samples) << name;
    }
}

TEST(DenoiserPlanes, CameraRays_AreTracedWhereSamplesSawDifferentThings) {
    const int samples = 8;
    const Film film = rendered(settings_of(samples, true));
    const std::vector<float> share = channel(film, "exact_share.X");
    int untraced = 0;
    int most_rays = 0;
    std::vector<float> differences(share.size());  // of the halves
    for (const char* feature : {"albedo.R", "albedo.G", "albedo.B", "normal.X", "normal.Z"}) {
        const std::vector<float> half = channel(film, std::string("half_") + feature);
        for (std::size_t i = 0; i < half.size(); ++i) {
            differences[i] = std::max(differences[i], std::abs(half[i]));
        }
    }
    const std::vector<float> error = channel(film, "error_albedo.G");
    for (std::size_t i = 0; i < share.size(); ++i) {
        const float largest = differences[i];
        untraced += share[i] == 1 ? 1 : 0;
        // Half the weight of 8 samples, against 64 rays.
        most_rays += std::abs(share[i] - 4.0f / 68) < 1e-3f ? 1 : 0;
        if (share[i] == 1) {
            EXPECT_LT(largest, 0.1f) << i;
            EXPECT_EQ(error[i], 0) << i;
        } else if (largest > 0.5f) {
            EXPECT_LT(share[i], 0.25f) << i;
        }
    }
    EXPECT_GT(untraced, 600);
    EXPECT_GT(most_rays, 60);
    EXPECT_LT(most_rays, 1500);
}

TEST(DenoiserPlanes, LightThatIsSeen_IsThatOfRoomAndLamps) {
    RenderSettings settings = settings_of(8, true);
    const PreparedScene scene(table().scene, settings);
    FrameInput frame = table_frame();
    // Up along the table, to the lamp and the sky.
    frame.camera_open = frame.camera_close = test::camera(Vec3(0, -1.5, 0.2), Vec3(0, 0, 0.9), 0.8);
    const Film film = render_frame(scene, table_tracks(), frame, settings);
    const std::vector<float> light = channel(film, "exact_light.G");
    int sky = 0;
    int lamp = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        sky += std::abs(light[i] - 0.1f) < 1e-4f ? 1 : 0;
        lamp += std::abs(light[i] - 20) < 0.02f ? 1 : 0;
    }
    EXPECT_GT(sky, 1000);
    EXPECT_GT(lamp, 20);
}

TEST(DenoiserPlanes, DenoisedFrame_HasLessNoise) {
    const Film reference = rendered(settings_of(2048, false));
    RenderSettings settings = settings_of(8, true);
    settings.aovs = {"normal"};
    const Film noisy = rendered(settings);
    const Film film = denoised(noisy);
    EXPECT_LT(2 * relative_error(film, reference), relative_error(noisy, reference));
    ASSERT_EQ(film.aovs.size(), 3u) << "the channels of the settings stay";
    EXPECT_EQ(film.aovs[2].values, noisy.aovs[2].values);
    EXPECT_TRUE(film.half_aovs.empty());
    EXPECT_EQ(film.statistics.camera_rays, noisy.statistics.camera_rays);
    for (std::size_t i = 3; i < film.rgba.size(); i += 4) {
        ASSERT_EQ(film.rgba[i], noisy.rgba[i]);
    }
    EXPECT_THROW(static_cast<void>(denoised(film)), Error);
}

TEST(DenoiserPlanes, SettingsThatCannotBeDenoised_AreAnError) {
    EXPECT_THROW(static_cast<void>(rendered(settings_of(7, true))), Error);
    RenderSettings settings = test::distributed_settings();
    settings.for_denoiser = true;
    EXPECT_THROW(static_cast<void>(rendered(settings)), Error);
}

}  // namespace
}  // namespace carom::render
