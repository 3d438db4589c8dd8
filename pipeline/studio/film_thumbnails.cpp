#include "pipeline/studio/film_thumbnails.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include <unistd.h>

#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/mixed_film.h"
#include "render/film/image_file.h"

namespace carom::studio {
namespace {

sim::Timeline cached_timeline(const pipeline::Shot& shot, const std::string& cache_folder) {
    std::optional<sim::Bake> bake = pipeline::find_cached_bake(shot, cache_folder, {});
    if (!bake) {
        throw Error("the cache has no bake of the film");
    }
    return std::move(bake->timeline);
}

/// Writes a JPEG and returns its bytes. The file is removed.
std::string jpeg_of(const std::vector<std::uint8_t>& rgb, int width, int height,
                    const std::string& path) {
    render::write_display_image(rgb, width, height, path);
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return bytes;
}

}  // namespace

FilmThumbnails::FilmThumbnails(pipeline::Shot shot, const std::string& cache_folder)
    : folder_(cache_folder + "/studio"),
      shot_(std::move(shot)),
      timeline_(cached_timeline(shot_, cache_folder)),
      source_(shot_, timeline_),
      store_(cache_folder + "/frames"),
      view_(shot_.output),
      graphics_(shot_, timeline_, 1) {
    std::filesystem::create_directories(folder_);
}

std::optional<std::string> FilmThumbnails::jpeg(std::int64_t frame) {
    std::optional<render::Film> film;
    const std::vector<pipeline::PlannedFrame> layers = source_.layers(frame);
    for (const pipeline::PlannedFrame& layer : layers) {
        const std::optional<render::Film> part = store_.read(source_.key(source_.inputs(layer)));
        if (!part) {
            return std::nullopt;
        }
        render::Film small = reduced(*part, kThumbnailWidth);
        if (film) {
            pipeline::mix_in(small, layer.weight, *film);
        } else {
            film = std::move(small);
        }
    }
    const std::string path = folder_ + "/thumbnail_" + std::to_string(::getpid()) + ".jpg";
    std::vector<std::uint8_t> rgb = view_.to_8(*film);
    graphics_.draw_annotations(layers, rgb, film->width, film->height);
    return jpeg_of(rgb, film->width, film->height, path);
}

render::Film reduced(const render::Film& film, int width) {
    const int factor = std::max(1, (film.width + width - 1) / width);
    render::Film small;
    small.width = std::max(1, film.width / factor);
    small.height = std::max(1, film.height / factor);
    small.rgba.resize(4 * static_cast<std::size_t>(small.width) *
                      static_cast<std::size_t>(small.height));
    const auto pixel = [](const render::Film& of, int x, int y) {
        return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(of.width) +
                    static_cast<std::size_t>(x));
    };
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            const int right = std::min(film.width, (x + 1) * factor);
            const int below = std::min(film.height, (y + 1) * factor);
            const int count = (right - x * factor) * (below - y * factor);
            for (int row = y * factor; row < below; ++row) {
                for (int column = x * factor; column < right; ++column) {
                    for (std::size_t channel = 0; channel < 4; ++channel) {
                        small.rgba[pixel(small, x, y) + channel] +=
                            film.rgba[pixel(film, column, row) + channel] /
                            static_cast<float>(count);
                    }
                }
            }
        }
    }
    return small;
}

}  // namespace carom::studio
