#include "pipeline/studio/picture_question.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "core/error.h"
#include "pipeline/studio/view_frame.h"

namespace carom::studio {
namespace {

constexpr int kFirstPixels = 36000;  // of the first, small picture: at most about 250 x 140
// Of a picture with all its layers: the sums take up to 190 bytes a pixel. A cross-fade at 1920 x
// 1080 fits.
constexpr int kMostPixels = 2 * 1920 * 1080;
constexpr int kMostSide = 16384;  // pixels

/// The exposure is that of the film at speed 1, around the time.
pipeline::PlannedFrame planned(const FreeView& view, const pipeline::Shutter& shutter) {
    const double half = 0.5 * shutter.exposure.to_double();
    pipeline::PlannedFrame frame = frame_of(view);
    frame.scene_open -= half;
    frame.scene_close += half;
    return frame;
}

void add_layers_of_frame(std::int64_t number, const pipeline::FilmSource& source,
                         PictureQuestion& question) {
    const pipeline::Shot& shot = question.shot;
    const std::int64_t count = pipeline::frame_count(shot.cameras, shot.timing);
    if (number < 0 || number >= count) {
        throw Error("the film has no frame " + std::to_string(number));
    }
    const std::vector<pipeline::PlannedFrame> layers = source.layers(number);
    for (const pipeline::PlannedFrame& layer : layers) {
        question.layers.push_back({source.inputs(layer), layer.weight});
    }
    question.planned = layers;
}

void add_layers(const pipeline::FilmSource& source, PictureQuestion& question) {
    const See& see = question.see;
    if (see.frame) {
        add_layers_of_frame(*see.frame, source, question);
    } else if (see.view) {
        const pipeline::Shutter& shutter = question.shot.timing.shutter;
        question.planned.push_back(planned(*see.view, shutter));
        question.layers.push_back({source.inputs(question.planned.front()), 1});
    } else {
        throw Error("a question for a picture needs a frame or a view");
    }
}

/// The size of the last picture: as asked for, but all layers fit into the memory.
PictureSize full_size(const PictureQuestion& question) {
    const See& see = question.see;
    const render::RenderSettings& film = question.shot.render;
    const int width = std::min(see.width > 0 ? see.width : film.width, kMostSide);
    const int height = std::min(see.height > 0 ? see.height : film.height, kMostSide);
    const double area =
        static_cast<double>(width) * height * static_cast<double>(question.layers.size());
    const double shrink = std::min(1.0, std::sqrt(kMostPixels / area));
    return {std::max(1, static_cast<int>(width * shrink)),
            std::max(1, static_cast<int>(height * shrink))};
}

/// Sizes that double up to `size`.
std::vector<PictureSize> growing_sizes(PictureSize size) {
    std::vector<PictureSize> levels{size};
    while (size.width > 1 && size.height > 1 && size.width * size.height > kFirstPixels) {
        size = {size.width / 2, size.height / 2};
        levels.push_back(size);
    }
    std::ranges::reverse(levels);
    return levels;
}

void add_keys(const pipeline::FilmSource& source, PictureQuestion& question) {
    for (std::size_t level = 0; level < question.levels.size(); ++level) {
        question.keys.emplace_back();
        for (const PictureLayer& layer : question.layers) {
            question.keys.back().push_back(source.key(layer.inputs, question.settings(level)));
        }
    }
    for (const PictureLayer& layer : question.layers) {
        question.film_keys.push_back(source.key(layer.inputs));
    }
}

int most_of(const PictureQuestion& question, int most_samples) {
    int most = most_samples > 0 ? most_samples : std::numeric_limits<int>::max();
    if (question.see.samples > 0) {
        most = std::min(most, question.see.samples);
    }
    if (question.channel && question.channel->samples > 0) {
        most = std::min(most, question.channel->samples);
    }
    return most;
}

}  // namespace

render::RenderSettings PictureQuestion::settings(std::size_t level) const {
    render::RenderSettings result = shot.render;
    result.width = levels[level].width;
    result.height = levels[level].height;
    return result;
}

PictureQuestion read_question(const See& see, const pipeline::FilmSource& source,
                              int most_samples) {
    PictureQuestion question{source.shot(), see};
    if (!see.channel.empty() && see.channel != "colour") {
        question.channel = view_channel(see.channel);
    }
    add_layers(source, question);
    const PictureSize size = full_size(question);
    question.is_films = see.frame && !question.channel &&
                        size.width == question.shot.render.width &&
                        size.height == question.shot.render.height;
    question.levels = growing_sizes(size);
    add_keys(source, question);
    question.most = most_of(question, most_samples);
    if (question.channel) {
        question.layers.resize(1);
    }
    return question;
}

}  // namespace carom::studio
