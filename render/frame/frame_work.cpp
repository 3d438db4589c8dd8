#include "render/frame/frame_work.h"

#include <array>

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/check_settings.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/sample_plan.h"
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

std::vector<FrameWork::Half> FrameWork::halves(double samples) const {
    if (!settings_.for_denoiser) {
        return {{samples, 0, 1}};
    }
    return {{samples / 2, 0, 0.5F}, {samples / 2, 1, 0.5F}};
}

void FrameWork::add_reflections(Film& film, DenoiserPlanes& planes, AovPlanes& aovs,
                                const WorkContext& context) const {
    const double samples = static_cast<double>(film.statistics.camera_rays) /
                           (static_cast<double>(settings_.width) * settings_.height);
    SplatMoments moments = aovs.has_variance() ? SplatMoments(pixel_count()) : SplatMoments();
    const auto trace = [&](const Half& half, Film& picture) {
        const Images images = trace_reflections(half, film.statistics, context);
        for (const std::vector<Splat>& image : images) {
            tiles_.add(image, picture);
            if (!moments.empty()) {
                tiles_.add(image, half.weight, moments);
            }
        }
    };
    const std::vector<Half> parts = halves(samples);
    if (parts.size() == 1) {
        trace(parts[0], film);
    } else {
        std::array<Film, 2> pictures{empty_film(), empty_film()};
        trace(parts[0], pictures[0]);
        trace(parts[1], pictures[1]);
        for (std::size_t i = 0; i < film.rgba.size(); ++i) {
            film.rgba[i] += 0.5F * (pictures[0].rgba[i] + pictures[1].rgba[i]);
        }
        planes.add_to_colours(pictures[0], pictures[1]);
    }
    aovs.add_variance(moments.variance());
}

void FrameWork::add_reflections(AovPlanes& aovs, double samples, const WorkContext& context) const {
    if (aovs.has_variance()) {
        aovs.add_variance(measured(samples, context).variance());
    }
}

std::vector<int> FrameWork::plan(const std::vector<PixelSums>& pilot,
                                 const WorkContext& context) const {
    return plan_samples(pilot, settings_, measured(settings_.samples, context));
}

SplatMoments FrameWork::measured(double samples, const WorkContext& context) const {
    SplatMoments moments(pixel_count());
    RenderStatistics ignored;
    for (const Half& half : halves(samples)) {
        for (const std::vector<Splat>& image : trace_reflections(half, ignored, context)) {
            tiles_.add(image, half.weight, moments);
        }
    }
    return moments;
}

FrameWork::Images FrameWork::trace_reflections(const Half& half, RenderStatistics& statistics,
                                               const WorkContext& context) const {
    const std::size_t number = tiles_.reflection_count();
    Images images(number);
    std::vector<RenderStatistics> counts(number);
    parallel_for(number, [&](std::size_t i) {
        if (!context.stop.stop_requested()) {
            const FlushDenormals flush;
            images[i] = tiles_.reflection(i, half.samples, half.index, counts[i]);
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (const RenderStatistics& count : counts) {
        statistics += count;
    }
    return images;
}

}  // namespace carom::render
