#include "pipeline/sequence/sequence_writer.h"

#include <array>
#include <cmath>
#include <utility>

#include "pipeline/job/frame_graphics.h"
#include "pipeline/picture/colours.h"

namespace carom::pipeline {

namespace {

std::uint16_t mixed(double a, double b, double weight) {
    return static_cast<std::uint16_t>(std::lround(a + (b - a) * weight));
}

}  // namespace

SequenceMixer::SequenceMixer(const Sequence& sequence, Take take)
    : sequence_(sequence), take_(std::move(take)), starts_(sequence.starts()) {}

void SequenceMixer::add(std::size_t part, std::int64_t own, std::span<const std::uint16_t> rgb) {
    const std::int64_t frame = starts_[part] + own;
    const std::vector<SequenceLayer> layers = layers_of(sequence_, frame);
    if (layers.back().part != part) {  // the next part fades in
        waiting_[frame].assign(rgb.begin(), rgb.end());
        return;
    }
    const double weight = layers.back().weight;
    if (weight >= 1) {
        take_(frame, rgb);
        return;
    }
    std::vector<std::uint16_t> picture(rgb.begin(), rgb.end());
    const auto before = waiting_.find(frame);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double other = before != waiting_.end() ? before->second[i] : 0;
        picture[i] = mixed(other, picture[i], weight);
    }
    if (before != waiting_.end()) {
        waiting_.erase(before);
    }
    take_(frame, picture);
}

std::vector<std::uint16_t> drawn_card(const TitleCard& card, int width, int height) {
    constexpr double kLargest = 65535;
    const Vec3 encoded = encoded_srgb(card.background);
    const std::array<std::uint16_t, 3> pixel{mixed(0, kLargest * encoded.x, 1),
                                             mixed(0, kLargest * encoded.y, 1),
                                             mixed(0, kLargest * encoded.z, 1)};
    std::vector<std::uint16_t> rgb;
    rgb.reserve(std::size_t{3} * static_cast<std::size_t>(width) *
                static_cast<std::size_t>(height));
    for (int i = 0; i < width * height; ++i) {
        rgb.insert(rgb.end(), pixel.begin(), pixel.end());
    }
    Shot shot;
    shot.render.width = width;
    shot.render.height = height;
    Annotation title;
    title.kind = TitleAnnotation{card.text, card.subtitle};
    title.colour = card.colour;
    title.place = PicturePlace{{0.5, 0.5}, false};
    shot.annotations = {title};
    const sim::Timeline timeline;
    FrameGraphics graphics(shot, timeline, 1);
    const PlannedFrame frame;
    graphics.draw({&frame, 1}, std::span(rgb), width, height);
    return rgb;
}

}  // namespace carom::pipeline
