// One scene with any strategy: pictures by the integrator alone.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/frame/prepared_scene.h"
#include "render/integrator/path_integrator.h"
#include "tests/render/scene_builder.h"

namespace carom::test {

/// A mean over independent runs, and its standard error.
struct Estimate {
    double mean = 0;
    double error = 0;
};

inline Estimate estimate_of(const std::vector<double>& values) {
    double sum = 0;
    double squares = 0;
    for (const double v : values) {
        sum += v;
        squares += v * v;
    }
    const double n = static_cast<double>(values.size());
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1))};
}

/// How objects move while the shutter is open.
struct Motion {
    std::vector<sim::Track> tracks;
    double shutter = 0;  // s
};

/// Mean luminance of a picture over `runs` runs with different seeds, with `samples` per pixel
/// each.
inline Estimate picture_luminance(const render::SceneDescription& scene,
                                  const render::CameraState& camera,
                                  const render::PathSettings& path, int runs, int samples,
                                  const Motion& motion = {}) {
    const render::RenderSettings settings = small_settings(16, 16, samples);
    const render::PreparedScene prepared(scene, settings);
    const auto& data = prepared.data();
    const render::FrameScene frame(data.geometry, motion.tracks, 0, motion.shutter);
    const render::LightSet lights = data.lights.in_frame(frame.motions());
    const render::PathIntegrator integrator({frame, data.materials, lights, data.object_count},
                                            path);
    const render::ThinLensCamera lens(camera, camera, 16, 16, 0, render::PixelFilter::box, 1);
    std::vector<double> means;
    for (int run = 0; run < runs; ++run) {
        double sum = 0;
        render::RenderStatistics count;
        for (int i = 0; i < 16 * 16 * samples; ++i) {
            const int x = i % 16;
            const int y = i / 16 % 16;
            const int sample = i / 256;
            const render::SampleStream stream(
                static_cast<std::uint64_t>(run), static_cast<std::uint32_t>(x),
                static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(sample));
            const auto result =
                integrator.sample(lens.ray(x, y, stream.camera_sample()),
                                  lens.frame_at(0).pixel_size, stream, {x, y, sample}, count);
            sum += static_cast<double>(carom::luminance(result.radiance));
        }
        means.push_back(sum / (16 * 16 * samples));
    }
    return estimate_of(means);
}

}  // namespace carom::test
