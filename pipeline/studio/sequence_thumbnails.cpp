#include "pipeline/studio/sequence_thumbnails.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/sequence/sequence_writer.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::studio {

namespace {

SmallPicture picture_of_card(const pipeline::TitleCard& card, int width, int height) {
    const int factor = thumbnail_factor(width);
    SmallPicture small;
    small.width = std::max(1, width / factor);
    small.height = std::max(1, height / factor);
    for (const std::uint16_t value : pipeline::drawn_card(card, small.width, small.height)) {
        small.rgb.push_back(static_cast<std::uint8_t>((value + 128U) / 257U));
    }
    return small;
}

/// Mixes display values, as the film does.
void mix_in(const SmallPicture& picture, double weight, SmallPicture& film) {
    for (std::size_t i = 0; i < film.rgb.size() && i < picture.rgb.size(); ++i) {
        film.rgb[i] = static_cast<std::uint8_t>(
            std::lround((1 - weight) * film.rgb[i] + weight * picture.rgb[i]));
    }
}

}  // namespace

SequenceThumbnails::SequenceThumbnails(const pipeline::Sequence& sequence, std::string cache_folder)
    : sequence_(sequence), cache_folder_(std::move(cache_folder)) {
    pipeline::create_folder(cache_folder_ + "/studio");
}

std::optional<SmallPicture> SequenceThumbnails::layer(const pipeline::SequenceLayer& layer) {
    const auto& content = sequence_.parts[layer.part].content;
    if (const auto* card = std::get_if<pipeline::TitleCard>(&content)) {
        return picture_of_card(*card, sequence_.width, sequence_.height);
    }
    const auto& shot = std::get<pipeline::ShotPart>(content);
    std::unique_ptr<FilmThumbnails>& thumbnails = shots_[layer.part];
    if (!thumbnails) {
        thumbnails = std::make_unique<FilmThumbnails>(shot.shot, shot.source, shot.bake.get(),
                                                      cache_folder_);
    }
    return thumbnails->small(shot.first + layer.frame);
}

std::optional<std::string> SequenceThumbnails::jpeg(std::int64_t frame) {
    std::optional<SmallPicture> film;
    const std::vector<pipeline::SequenceLayer> layers = pipeline::layers_of(sequence_, frame);
    for (const pipeline::SequenceLayer& one : layers) {
        const std::optional<SmallPicture> picture = layer(one);
        if (!picture) {
            return std::nullopt;
        }
        if (!film) {
            film = SmallPicture{std::vector<std::uint8_t>(picture->rgb.size(), 0), picture->width,
                                picture->height};
            // The weights of a fade that is not the film's first one add up to 1.
            mix_in(*picture, layers.size() > 1 ? 1 : one.weight, *film);
        } else {
            mix_in(*picture, one.weight, *film);
        }
    }
    return film ? std::optional(jpeg_of(*film, cache_folder_ + "/studio")) : std::nullopt;
}

}  // namespace carom::studio
