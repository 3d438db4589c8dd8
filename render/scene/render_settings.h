// The settings of a frame. Every field can change the pixels and is part of a frame's key.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/scene/distributed_settings.h"

namespace carom::render {

enum class IntegratorKind { path, distributed };
enum class PixelFilter { box, gaussian, blackman_harris };

struct RenderSettings {
    int width = 1280;  // pixels, [16, 16384]
    int height = 720;
    IntegratorKind integrator = IntegratorKind::path;
    int samples = 64;  // per pixel, [1, 65536]; powers of two converge best (path)
    /// Adaptive sampling (path): `samples`, which is then even, is the minimum, and pixels get more
    /// where that takes away most of the error, until the frame's relative error is this value
    /// (sample_plan.h); 0: off. If it is for the denoiser, this is the error after denoising.
    double noise = 0;
    int max_samples = 1024;           // of one pixel, [1, 65536]
    int max_bounces = 4;              // [0, 64] (path)
    DistributedSettings distributed;  // replaces both with that integrator
    double clamp =
        0;  // radiance of one sample's indirect light is clamped to this; 0: off (biased otherwise)
    PixelFilter filter = PixelFilter::blackman_harris;
    double filter_width = 1.5;            // full width in pixels, [0.5, 8]; box: 1
    std::string acceleration = "hybrid";  // another one needs a maker (structure_maker.h)
    std::uint64_t seed = 0;               // chooses the noise only
    std::vector<std::string> aovs;        // by the names in render/frame/aov_planes.h
    /// Samples are taken in two halves, and the frame has the channels that the denoiser needs
    /// (render/frame/denoiser_planes.h). Not with the distributed integrator.
    bool for_denoiser = false;

    bool operator==(const RenderSettings&) const = default;
};

/// Whether the samples of a pixel depend on the noise of its first ones.
[[nodiscard]] inline bool is_adaptive(const RenderSettings& settings) {
    return settings.integrator == IntegratorKind::path && settings.noise > 0;
}

/// Whether a pixel's samples are two sets, each with random numbers of its own, whose difference
/// shows the error of their mean.
[[nodiscard]] inline bool has_halves(const RenderSettings& settings) {
    return settings.for_denoiser || is_adaptive(settings);
}

}  // namespace carom::render
