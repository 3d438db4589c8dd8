// The content of FrameSums. Internal to this folder.
#pragma once

#include <vector>

#include "render/film/film.h"
#include "render/frame/feature_tracer.h"
#include "render/frame/frame_sums.h"
#include "render/frame/pixel_sums.h"

namespace carom::render {

struct FrameSums::Data {
    std::vector<PixelSums> pixels;  // row by row
    // With adaptive sampling, once the first samples are taken:
    std::vector<int> plan;                 // samples after the current round (sample_plan.h)
    std::vector<TracedFeatures> features;  // for the denoiser
    std::vector<float> seconds;   // that the first samples of each tile took, with such sampling
    RenderStatistics statistics;  // of all rays
};

}  // namespace carom::render
