#include "pipeline/studio/film_thumbnails.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "core/error.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/mixed_film.h"
#include "pipeline/job/viewed_frame.h"
#include "pipeline/picture/lit_annotations.h"
#include "pipeline/store/claim_note.h"
#include "pipeline/store/file_descriptor.h"
#include "render/film/image_file.h"

namespace carom::studio {
namespace {

/// The shot's moments get their times, and its lit annotations become things, as in the film.
sim::Timeline timeline_of(pipeline::Shot& shot, std::shared_ptr<const pipeline::ShotSource> source,
                          const sim::Bake* known, const std::string& cache_folder) {
    std::optional<sim::Bake> bake = known != nullptr
                                        ? std::optional(*known)
                                        : pipeline::find_cached_bake(shot, cache_folder, {});
    if (!bake) {
        throw Error("the cache has no bake of the film");
    }
    if (pipeline::has_errors(pipeline::resolve_moments(shot, source, bake->timeline))) {
        throw Error("a moment of the film never comes");
    }
    if (known != nullptr) {
        pipeline::add_keyed_motions(*bake, shot);
    }
    pipeline::add_lit_annotations(shot, bake->timeline);
    return std::move(bake->timeline);
}

}  // namespace

std::string jpeg_of(const SmallPicture& picture, const std::string& folder) {
    const std::string path = folder + "/thumbnail_" + pipeline::new_claim_process() + ".jpg";
    render::write_display_image(picture.rgb, picture.width, picture.height, path);
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return bytes;
}

int thumbnail_factor(int width) {
    return std::max(1, (width + kThumbnailWidth - 1) / kThumbnailWidth);
}

FilmThumbnails::FilmThumbnails(pipeline::Shot shot,
                               std::shared_ptr<const pipeline::ShotSource> source,
                               const sim::Bake* bake, const std::string& cache_folder)
    : folder_(cache_folder + "/studio"),
      shot_(std::move(shot)),
      timeline_(timeline_of(shot_, std::move(source), bake, cache_folder)),
      source_(shot_, timeline_),
      store_(cache_folder + "/frames"),
      view_(shot_.output),
      graphics_(shot_, timeline_, 1) {
    pipeline::create_folder(folder_);
}

std::optional<SmallPicture> FilmThumbnails::small(std::int64_t frame) {
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
    std::vector<std::uint8_t> rgb = view_.to_8(*film, pipeline::viewed_frame(layers));
    graphics_.draw_annotations(layers, rgb, film->width, film->height);
    return SmallPicture{std::move(rgb), film->width, film->height};
}

std::optional<std::string> FilmThumbnails::jpeg(std::int64_t frame) {
    const std::optional<SmallPicture> picture = small(frame);
    return picture ? std::optional(jpeg_of(*picture, folder_)) : std::nullopt;
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
