#include "render/frame/frame_work.h"

#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/check_settings.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/tile_loop.h"
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
                     const FrameInput& frame, const RenderSettings& settings)
    : prepared_(scene),
      settings_(settings),
      frame_(frame),
      frame_scene_(checked(scene, frame, settings).geometry, tracks, frame.scene_open,
                   frame.scene_close),
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
    if (!has_halves(settings_)) {
        return {{samples, 0, 1}};
    }
    return {{samples / 2, 0, 0.5F}, {samples / 2, 1, 0.5F}};
}

std::vector<Film> FrameWork::reflections(double samples, RenderStatistics& statistics,
                                         SplatMoments& moments, const WorkContext& context) const {
    std::vector<Film> pictures;
    for (const Half& half : halves(samples)) {
        pictures.push_back(empty_film());
        for (const std::vector<Splat>& image : trace_reflections(half, statistics, context)) {
            tiles_.add(image, pictures.back());
            if (!moments.empty()) {
                tiles_.add(image, half.weight, moments);
            }
        }
    }
    return pictures;
}

namespace {

void add(const std::vector<Film>& pictures, Film& film) {
    const float weight = 1.0F / static_cast<float>(pictures.size());
    for (const Film& picture : pictures) {
        for (std::size_t i = 0; i < film.rgba.size(); ++i) {
            film.rgba[i] += weight * picture.rgba[i];
        }
    }
}

}  // namespace

void FrameWork::add_reflections(Film& film, DenoiserPlanes& planes, AovPlanes& aovs,
                                const WorkContext& context) const {
    const double samples =
        static_cast<double>(film.statistics.camera_rays) / static_cast<double>(pixel_count());
    SplatMoments moments = aovs.has_variance() ? SplatMoments(pixel_count()) : SplatMoments();
    const std::vector<Film> pictures = reflections(samples, film.statistics, moments, context);
    add(pictures, film);
    if (!planes.empty()) {
        planes.add_to_colours(pictures[0], pictures[1]);
    }
    aovs.finish_variance(moments.variance());
}

void FrameWork::add_reflections(AovPlanes& aovs, double samples, const WorkContext& context) const {
    if (aovs.has_variance()) {
        aovs.finish_variance(measured(samples, context).variance());
    }
}

namespace {

double mean_samples(const std::vector<PixelSums>& sums) {
    double samples = 0;
    for (const PixelSums& pixel : sums) {
        samples += pixel.samples;
    }
    return samples / static_cast<double>(sums.size());
}

MeasuredError noisy_error(const std::vector<PixelSums>& sums, const std::vector<Film>& pictures,
                          int width, int height) {
    std::vector<V3f> means;
    std::vector<V3f> differences;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        V3f half[2];
        for (int h = 0; h < 2; ++h) {
            const float* added = &pictures[static_cast<std::size_t>(h)].rgba[4 * i];
            half[h] = sums[i].mean_of_half(h) + V3f(added[0], added[1], added[2]);
        }
        means.push_back(0.5F * (half[0] + half[1]));
        differences.push_back(0.5F * (half[0] - half[1]));
    }
    return error_of_halves(means, differences, width, height);
}

}  // namespace

MeasuredError FrameWork::measured_error(std::vector<PixelSums>& sums,
                                        const std::vector<TracedFeatures>& features,
                                        const WorkContext& context) const {
    RenderStatistics ignored;
    SplatMoments no_moments;
    const std::vector<Film> pictures =
        reflections(mean_samples(sums), ignored, no_moments, context);
    if (!settings_.for_denoiser) {
        return noisy_error(sums, pictures, settings_.width, settings_.height);
    }
    Film film = empty_film();
    DenoiserPlanes planes = make_denoiser_planes();
    for_all_tiles(
        tiles_.tile_count(), {{}, context.stop}, ignored,
        [&](int tile) {
            const TileSums own = tiles_.sums_of(tile, sums);
            tiles_.write(tile, own, film);
            tiles_.write(tile, own, planes, features);
            return RenderStatistics{};
        },
        [](int) {});
    add(pictures, film);
    planes.add_to_colours(pictures[0], pictures[1]);
    planes.append_to(film);
    return render::measured_error(error_after_denoising(film, {{}, context.stop}));
}

std::vector<TracedFeatures> FrameWork::trace_features(std::vector<PixelSums>& sums,
                                                      const WorkContext& context) const {
    if (!settings_.for_denoiser) {
        return {};
    }
    std::vector<TracedFeatures> features(pixel_count());
    RenderStatistics none;
    for_all_tiles(
        tiles_.tile_count(), {{}, context.stop}, none,
        [&](int tile) {
            for (const FeaturePixel& pixel :
                 tiles_.trace_features(tile, tiles_.sums_of(tile, sums))) {
                features[index(pixel.x, pixel.y)] = pixel.traced;
            }
            return RenderStatistics{};
        },
        [](int) {});
    return features;
}

SampleRound FrameWork::next_round(std::vector<PixelSums>& sums,
                                  const std::vector<TracedFeatures>& features,
                                  const std::vector<int>& plan, const WorkContext& context) const {
    return render::next_round(plan, measured_error(sums, features, context), settings_);
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
