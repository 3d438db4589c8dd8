#include "tests/pipeline/job/example_frames.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/far_light.h"
#include "pipeline/job/film_job.h"
#include "render/frame/frame.h"
#include "tests/folders.h"
#include "tests/pipeline/film_of_shots.h"

namespace carom::testing {

std::vector<std::string> example_files() {
    std::vector<std::string> files;
    const std::string folder = std::string(CAROM_SOURCE_DIR) + "/examples";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".yaml" && !is_film_of_shots(entry.path())) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

ExampleFilm::ExampleFilm(const std::string& path, const std::string& bakes) {
    pipeline::LoadResult loaded = pipeline::load_shot(path);
    if (!loaded.shot) {
        throw Error("the example " + path + " has errors");
    }
    shot = std::move(*loaded.shot);
    shot.render.width = 160;
    shot.render.height = 90;
    shot.render.samples = 4;
    shot.render.noise = 0;
    // Some scenes of texts have thousands of rays in a pixel.
    render::DistributedSettings& rays = shot.render.distributed;
    for (int* count : {&rays.pixel_samples, &rays.blur_samples, &rays.lens_samples,
                       &rays.shadow_samples, &rays.reflection_samples, &rays.refraction_samples}) {
        *count = std::min(*count, 2);
    }
    shot.render.aovs.clear();
    timeline_ = pipeline::bake_or_reuse(shot, bakes, {}, {}).bake.timeline;
    if (pipeline::has_errors(pipeline::resolve_moments(shot, loaded.source, timeline_))) {
        throw Error("a moment of the example " + path + " never comes");
    }
}

std::int64_t ExampleFilm::frame_count() const {
    return pipeline::frame_count(shot.cameras, shot.timing);
}

pipeline::FrameInputs ExampleFilm::inputs(std::int64_t frame) const {
    return pipeline::FilmSource(shot, timeline_).inputs(frame);
}

render::Film ExampleFilm::render(std::int64_t frame) const {
    const pipeline::FrameInputs all = inputs(frame);
    return render::render_frame(
        render::PreparedScene(shot.scene, shot.render, {},
                              pipeline::known_far_light(shot.scene, nullptr)),
        all.tracks, all.frame, shot.render);
}

}  // namespace carom::testing
