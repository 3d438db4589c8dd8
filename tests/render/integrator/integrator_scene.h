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

/// The samples of a picture.
struct PictureSamples {
    int width = 0, height = 0, samples = 0;  // per pixel
    std::uint64_t seed = 0;
};

/// Traces all samples and calls `visit` with the index and the result of each.
template <class Visit>
void for_each_sample(const render::Integrator& integrator, const render::ThinLensCamera& lens,
                     const PictureSamples& picture, render::Integrator::Workspace* workspace,
                     const Visit& visit) {
    const int count = picture.width * picture.height * picture.samples;
    render::RenderStatistics rays;
    std::vector<render::RadianceSample> results(render::CameraBatch::kUsual);
    for (int i = 0; i < count;) {
        render::CameraBatch batch;
        for (; i < count && batch.count < render::CameraBatch::kUsual; ++i) {
            const int x = i % picture.width;
            const int y = i / picture.width % picture.height;
            const int sample = i / (picture.width * picture.height);
            batch.add({picture.seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                       static_cast<std::uint32_t>(sample)},
                      {x, y, sample});
        }
        render::make_rays(lens, {}, batch);
        const auto run = render::CameraRun::all(batch);
        integrator.samples(run, lens.frame_at(0).pixel_size, results.data(), workspace, rays);
        for (int k = 0; k < run.count; ++k) {
            results[static_cast<std::size_t>(k)].weigh(batch.weight[k]);
            visit(run.index(k), results[static_cast<std::size_t>(k)]);
        }
    }
}

/// Mean luminance of a picture over `runs` runs with different seeds, with `samples` per pixel
/// each.
inline Estimate picture_luminance(const render::SceneDescription& scene,
                                  const render::CameraState& camera,
                                  const render::PathSettings& path, int runs, int samples,
                                  const Motion& motion = {}) {
    const render::RenderSettings settings = small_settings(16, 16, samples);
    const render::PreparedScene prepared(scene, settings);
    const auto& data = prepared.data();
    const render::FrameScene frame(data.geometry, motion.tracks, 0, motion.shutter,
                                   data.cut_outs ? &*data.cut_outs : nullptr,
                                   data.near ? &*data.near : nullptr);
    const render::LightSet lights = data.lights.in_frame(frame.motions());
    const render::PathIntegrator integrator(
        {frame, data.materials, lights, data.object_count, data.far.get()}, path);
    const render::ThinLensCamera lens(camera, camera, 16, 16, 0, render::PixelFilter::box, 1);
    std::vector<double> means;
    const auto workspace = integrator.make_workspace();
    for (int run = 0; run < runs; ++run) {
        double sum = 0;
        for_each_sample(integrator, lens, {16, 16, samples, static_cast<std::uint64_t>(run)},
                        workspace.get(),
                        [&](const render::SampleIndex&, const render::RadianceSample& result) {
                            sum += static_cast<double>(carom::luminance(result.radiance));
                        });
        means.push_back(sum / (16 * 16 * samples));
    }
    return estimate_of(means);
}

}  // namespace carom::test
