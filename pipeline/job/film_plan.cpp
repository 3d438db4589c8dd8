#include "pipeline/job/film_plan.h"

#include "core/error.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/job/denoised_picture.h"
#include "pipeline/store/frame_key.h"

namespace carom::pipeline {

FilmSource::FilmSource(const Shot& shot, const sim::Timeline& timeline)
    : shot_(shot),
      timeline_(timeline),
      cameras_(with_fitted_paths(shot.cameras, timeline)),
      scene_hash_(hash_scene(shot.scene)) {}

std::vector<PlannedFrame> FilmSource::layers(std::int64_t frame) const {
    return plan_mixed_frame(frame, cameras_, shot_.timing, timeline_);
}

FrameInputs FilmSource::inputs(const PlannedFrame& layer) const {
    return frame_inputs(layer, shot_.timing.shutter, shot_.scene, timeline_, shot_.render.seed);
}

Hash128 FilmSource::key(const FrameInputs& inputs) const {
    const Hash128 noisy = noisy_key(inputs);
    return denoises(shot_) ? denoised_key(noisy, shot_.output.denoise.strength) : noisy;
}

Hash128 FilmSource::noisy_key(const FrameInputs& inputs) const {
    return key(inputs, shot_.render);
}

Hash128 FilmSource::key(const FrameInputs& inputs, const render::RenderSettings& settings) const {
    return frame_key(inputs, shot_.scene, scene_hash_, settings);
}

FilmPlan plan_film(const FilmSource& source, const std::vector<std::int64_t>& frames,
                   const std::stop_token& stop) {
    FilmPlan plan;
    plan.frames = frames;
    std::map<Hash128, std::size_t> known;
    for (const std::int64_t frame : frames) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        const std::vector<PlannedFrame> layers = source.layers(frame);
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const FrameInputs inputs = source.inputs(layers[i]);
            const Hash128 key = source.key(inputs);
            const auto [place, is_new] = known.emplace(key, plan.pictures.size());
            if (is_new) {
                plan.pictures.push_back({key, frame, i, {}, source.noisy_key(inputs)});
            }
            if (i == 0) {
                plan.pictures[place->second].frames.push_back(frame);
                plan.picture_of.push_back(place->second);
            } else {
                plan.blends[plan.picture_of.size() - 1] = {place->second, layers[i].weight};
            }
        }
    }
    return plan;
}

}  // namespace carom::pipeline
