#include "pipeline/job/forecast_sizes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>

#include "core/cpu_time.h"
#include "pipeline/job/denoised_picture.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/job/scratch_folder.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/encoded_size.h"
#include "pipeline/video/hdr_view.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/view_transform.h"
#include "render/film/packed_film.h"

namespace carom::pipeline {
namespace {

/// What a pixel of a picture costs.
struct PixelCost {
    double bytes = 0;
    double seconds = 0;  // CPU time
};

/// What a pixel of a picture costs in the store, where it may also be before it is denoised.
struct StorePixelCost {
    double bytes = 0;
    double seconds = 0;          // CPU time, of one thread: to write
    double denoise_seconds = 0;  // CPU time, of all threads
};

/// What a pixel of a film costs: in a key frame, and in a picture that is coded by its difference.
struct FilmPixelCost {
    double key_bytes = 0;
    double further_bytes = 0;
    double seconds = 0;
};

double pixels_of(const render::Film& film) {
    return static_cast<double>(film.width) * film.height;
}

std::size_t columns_for(std::size_t blocks) {
    return std::max<std::size_t>(
        2, static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(blocks)))));
}

/// The mean of a value over the pictures to render. Sites stand for their camera, and all sites for
/// a camera without any.
double mean_over_pictures(const FilmProbe& probe,
                          const std::vector<std::pair<std::size_t, double>>& by_camera) {
    double sum = 0;
    double pictures = 0;
    for (std::size_t camera = 0; camera < probe.cameras().size(); ++camera) {
        double here = 0;
        double count = 0;
        for (const auto& [of, value] : by_camera) {
            here += of == camera ? value : 0;
            count += of == camera ? 1 : 0;
        }
        if (count > 0) {
            const auto weight = static_cast<double>(probe.cameras()[camera].pictures.size());
            sum += weight * here / count;
            pictures += weight;
        }
    }
    return pictures > 0 ? sum / pictures : 0;
}

/// The mean over the pictures to render of what `measure` finds at each site, where NaN stands for
/// what is not known there.
template <class Cost>
Cost mean_cost(const FilmProbe& probe, const std::vector<double Cost::*>& members,
               const std::function<Cost(const SiteMeasurement&)>& measure) {
    std::vector<std::vector<std::pair<std::size_t, double>>> values(members.size());
    for (const SiteMeasurement& site : probe.sites()) {
        if (site.common_blocks() > 0) {
            const Cost cost = measure(site);
            for (std::size_t i = 0; i < members.size(); ++i) {
                if (!std::isnan(cost.*members[i])) {
                    values[i].emplace_back(site.site.camera, cost.*members[i]);
                }
            }
        }
    }
    Cost mean;
    for (std::size_t i = 0; i < members.size(); ++i) {
        mean.*members[i] = mean_over_pictures(probe, values[i]);
    }
    return mean;
}

/// The blocks of the site's first picture.
render::Film first_mosaic(const SiteMeasurement& site) {
    const std::vector<render::Film>& blocks = site.blocks.front();
    return mosaic_of(blocks, std::min<std::size_t>(blocks.size(), 20));
}

/// What is shown of a mosaic, which must have been rendered by the shot.
render::Film shown(render::Film mosaic, const Shot& shot) {
    return denoises(shot) ? denoised_picture(render::as_stored(std::move(mosaic), {}), shot)
                          : std::move(mosaic);
}

/// Measures a file that `write` makes of the mosaic.
PixelCost file_cost(const render::Film& mosaic, const std::string& path,
                    const std::function<void(const render::Film&)>& write) {
    const double begin = process_cpu_seconds();
    write(mosaic);
    const double seconds = process_cpu_seconds() - begin;
    return {static_cast<double>(std::filesystem::file_size(path)) / pixels_of(mosaic),
            seconds / pixels_of(mosaic)};
}

StorePixelCost store_cost(const SiteMeasurement& site, const Shot& shot, const std::string& path) {
    render::Film mosaic = first_mosaic(site);
    StorePixelCost cost;
    if (denoises(shot)) {
        const double pixels = pixels_of(mosaic);
        const render::Film noisy = render::as_stored(std::move(mosaic), {});
        const double begin = process_cpu_seconds();
        cost.bytes = static_cast<double>(render::pack_film(noisy, path).size()) / pixels;
        const double packed = process_cpu_seconds();
        mosaic = denoised_picture(noisy, shot);
        cost.denoise_seconds = (process_cpu_seconds() - packed) / pixels;
        cost.seconds = (packed - begin) / pixels;
    }
    const PixelCost file = file_cost(mosaic, path, [&](const render::Film& film) {
        render::write_exr(film, path, stored_frame_metadata(shot));
    });
    cost.bytes += file.bytes;
    cost.seconds += file.seconds;
    return cost;
}

FilmPixelCost sequence_cost(const SiteMeasurement& site, const Shot& shot, const DisplayView& view,
                            const std::string& output) {
    const std::size_t count = site.common_blocks();
    std::vector<render::Film> mosaics;
    for (const std::vector<render::Film>& blocks : site.blocks) {
        mosaics.push_back(
            shown(mosaic_of({blocks.begin(), blocks.begin() + static_cast<std::ptrdiff_t>(count)},
                            columns_for(count)),
                  shot));
    }
    const double begin = process_cpu_seconds();
    std::vector<std::vector<std::uint16_t>> pictures;
    VideoFormat format{0, 0, shot.timing.fps};
    for (const render::Film& mosaic : mosaics) {
        format.width = mosaic.width;
        format.height = mosaic.height;
        const auto frame = static_cast<std::int64_t>(pictures.size());
        pictures.push_back(shot.output.hdr10 ? to_hdr10(mosaic, shot.output, frame)
                                             : view.to_16(mosaic, frame));
    }
    const std::vector<std::uint64_t> sizes = encoded_sizes(pictures, format, shot.output, output);
    const double pixels = static_cast<double>(format.width) * format.height;
    const auto all = static_cast<double>(pictures.size());
    FilmPixelCost cost;
    cost.key_bytes = static_cast<double>(sizes.front()) / pixels;
    cost.further_bytes =  // NaN if there is only one picture
        static_cast<double>(std::accumulate(sizes.begin() + 1, sizes.end(), std::uint64_t{0})) /
        pixels / (all - 1);
    cost.seconds = (process_cpu_seconds() - begin) / pixels / all;
    return cost;
}

/// The frames that do not show the same picture as the one before.
double count_changes(const FilmPlan& plan) {
    double changes = 0;
    for (std::size_t i = 0; i < plan.picture_of.size(); ++i) {
        const bool is_same = i > 0 && plan.picture_of[i] == plan.picture_of[i - 1] &&
                             plan.blend_of(i) == nullptr && plan.blend_of(i - 1) == nullptr;
        changes += is_same ? 0 : 1;
    }
    return changes;
}

double film_bytes(const Shot& shot, const FilmPlan& plan, const std::string& output,
                  const FilmPixelCost& cost, int block_size) {
    const double pixels = static_cast<double>(shot.render.width) * shot.render.height;
    const auto frames = static_cast<double>(plan.frames.size());
    const double fps = shot.timing.fps.to_double();
    constexpr double kHeader = 2000;  // bytes, of an .mp4 with its metadata
    constexpr double kPerFrame = 16;  // bytes, of its table of frames
    if (shot.output.bit_rate) {
        return *shot.output.bit_rate / 8 * frames / fps + kHeader + kPerFrame * frames;
    }
    if (!has_sequences(shot, output)) {
        return frames * pixels * cost.key_bytes + kHeader + kPerFrame * frames;
    }
    constexpr double kSecondsBetweenKeyFrames = 2;  // as in encoder_options.cpp
    // At the edges of its blocks a mosaic has nothing to predict the next picture from, so the film
    // needs less: 0.76 to 1.05 times as much with blocks of 64 pixels in five films, 0.42 to 0.95
    // times with blocks of 32 (docs/developers/forecast.md). That of 16 is extrapolated.
    const double without_edges = block_size >= 64 ? 0.9 : block_size >= 32 ? 0.65 : 0.4;
    // If a film is too expensive to measure two pictures in a row.
    constexpr double kFurtherPerKey = 0.3;
    const double per_pixel = cost.further_bytes > 0 ? without_edges * cost.further_bytes
                                                    : kFurtherPerKey * cost.key_bytes;
    const double keys = std::ceil(frames / (kSecondsBetweenKeyFrames * fps));
    const double further = std::max(0.0, count_changes(plan) - keys);
    return pixels * (keys * cost.key_bytes + further * per_pixel) + kHeader + kPerFrame * frames;
}

void add_film(const FilmSource& source, const FilmPlan& plan, const FilmProbe& probe,
              const std::string& output, FilmForecast& forecast) {
    const Shot& shot = source.shot();
    const DisplayView view(shot.output);
    const double pixels = static_cast<double>(shot.render.width) * shot.render.height;
    const auto frames = static_cast<double>(plan.frames.size());
    if (is_image_sequence(output)) {
        const ScratchFolder folder;
        const std::string path = folder.path("picture" + extension_of(output));
        const PixelCost cost = mean_cost<PixelCost>(
            probe, {&PixelCost::bytes, &PixelCost::seconds}, [&](const SiteMeasurement& site) {
                return file_cost(
                    shown(first_mosaic(site), shot), path,
                    [&](const render::Film& mosaic) { write_picture(mosaic, view, 0, path, {}); });
            });
        forecast.film_bytes = static_cast<std::uint64_t>(frames * pixels * cost.bytes);
        forecast.encoding_seconds = frames * pixels * cost.seconds;
        return;
    }
    const FilmPixelCost cost = mean_cost<FilmPixelCost>(
        probe, {&FilmPixelCost::key_bytes, &FilmPixelCost::further_bytes, &FilmPixelCost::seconds},
        [&](const SiteMeasurement& site) { return sequence_cost(site, shot, view, output); });
    forecast.film_bytes =
        static_cast<std::uint64_t>(film_bytes(shot, plan, output, cost, probe.block_size()));
    forecast.encoding_seconds = frames * pixels * cost.seconds;
}

}  // namespace

bool has_sequences(const Shot& shot, const std::string& output) {
    if (output.empty() || is_image_sequence(output) || shot.output.bit_rate) {
        return false;
    }
    const Codec codec = codec_for(shot.output, output);
    return !info(codec).is_intra_only;
}

double usual_store_bytes_per_pixel(const Shot& shot) {
    constexpr double kUsual = 3.5;
    constexpr double kNoisy = 13;  // with halves and features
    const double aovs = sizeof(float) * static_cast<double>(shot.render.aovs.size());
    return denoises(shot) ? kUsual + kNoisy + 2 * aovs : kUsual + aovs;
}

void add_sizes(const FilmSource& source, const FilmPlan& plan, const FilmProbe& probe,
               const std::string& output, FilmForecast& forecast) {
    const Shot& shot = source.shot();
    const ScratchFolder folder;
    const std::string path = folder.path("picture.exr");
    const StorePixelCost cost = mean_cost<StorePixelCost>(
        probe, {&StorePixelCost::bytes, &StorePixelCost::seconds, &StorePixelCost::denoise_seconds},
        [&](const SiteMeasurement& site) { return store_cost(site, shot, path); });
    const double pixels = static_cast<double>(shot.render.width) * shot.render.height;
    // It may be that not one block could be measured in time.
    const double bytes = cost.bytes > 0 ? cost.bytes : usual_store_bytes_per_pixel(shot);
    forecast.store_bytes =
        static_cast<std::uint64_t>(static_cast<double>(forecast.pictures) * pixels * bytes);
    forecast.seconds_per_picture += pixels * (cost.seconds + cost.denoise_seconds);
    forecast.serial_per_picture += pixels * cost.seconds;
    if (!output.empty()) {
        add_film(source, plan, probe, output, forecast);
    }
}

}  // namespace carom::pipeline
