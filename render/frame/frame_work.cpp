#include "render/frame/frame_work.h"

#include <array>

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/check_settings.h"
#include "render/frame/prepared_scene.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

const PreparedScene::Data& checked(const PreparedScene& scene, const FrameInput& frame,
                                   const RenderSettings& settings) {
    check(settings, frame, scene.data().branches);
    return scene.data();
}

}  // namespace

FrameWork::FrameWork(const PreparedScene& scene, std::span<const sim::Track> tracks,
                     const FrameInput& frame, const RenderSettings& settings,
                     const StructureOptions& options)
    : prepared_(scene),
      settings_(settings),
      frame_(frame),
      frame_scene_(checked(scene, frame, settings).geometry, tracks, frame.scene_open,
                   frame.scene_close, options),
      lights_(scene.data().lights.in_frame(frame_scene_.motions())),
      transport_{frame_scene_, scene.data().materials, lights_, scene.data().object_count},
      tiles_(settings, frame, transport_) {}

Film FrameWork::empty_film() const {
    Film film;
    film.width = settings_.width;
    film.height = settings_.height;
    film.rgba.resize(4 * pixel_count());
    return film;
}

AovPlanes FrameWork::make_aovs(const std::vector<std::string>& names) const {
    RenderSettings settings = settings_;
    settings.aovs = names;
    return {settings, frame_, frame_scene_, prepared_.data().names};
}

DenoiserPlanes FrameWork::make_denoiser_planes() const {
    return settings_.for_denoiser ? DenoiserPlanes(settings_.width, settings_.height)
                                  : DenoiserPlanes();
}

void FrameWork::add_reflections(Film& film, DenoiserPlanes& planes,
                                const WorkContext& context) const {
    const double samples = static_cast<double>(film.statistics.camera_rays) /
                           (static_cast<double>(settings_.width) * settings_.height);
    if (planes.empty()) {
        add_reflections(film, samples, 0, film.statistics, context);
        return;
    }
    std::array<Film, 2> halves{empty_film(), empty_film()};
    for (int half = 0; half < 2; ++half) {
        add_reflections(halves[static_cast<std::size_t>(half)], samples / 2, half, film.statistics,
                        context);
    }
    for (std::size_t i = 0; i < film.rgba.size(); ++i) {
        film.rgba[i] += 0.5F * (halves[0].rgba[i] + halves[1].rgba[i]);
    }
    planes.add_to_colours(halves[0], halves[1]);
}

void FrameWork::add_reflections(Film& film, double samples, int half, RenderStatistics& statistics,
                                const WorkContext& context) const {
    const std::size_t number = tiles_.reflection_count();
    std::vector<std::vector<Splat>> splats(number);
    std::vector<RenderStatistics> counts(number);
    parallel_for(number, [&](std::size_t i) {
        if (!context.stop.stop_requested()) {
            const FlushDenormals flush;
            splats[i] = tiles_.reflection(i, samples, half, counts[i]);
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (std::size_t i = 0; i < number; ++i) {
        tiles_.add(splats[i], film);
        statistics += counts[i];
    }
}

}  // namespace carom::render
