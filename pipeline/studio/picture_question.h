// What a question for a picture asks for: layers, sizes and samples.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/hash.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/studio/channel_picture.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// One of the pictures that are mixed: two in a cross-fade, otherwise one.
struct PictureLayer {
    pipeline::FrameInputs inputs;
    double weight = 1;
};

struct PictureSize {
    int width = 0;
    int height = 0;
};

/// Refers to the shot and the question that it was made from.
struct PictureQuestion {
    const pipeline::Shot& shot;
    const See& see;
    std::vector<PictureLayer> layers{};
    std::vector<pipeline::PlannedFrame> planned{};  // the same layers
    std::vector<PictureSize> levels{};              // growing
    std::vector<std::vector<Hash128>> keys{};       // by level, then by layer
    std::vector<Hash128> film_keys{};               // of the film's pictures, by layer
    int most = 0;                                   // samples
    bool is_films = false;                          // the film's frame at its own size, in colours
    std::optional<ViewChannel> channel{};           // shown instead of colours

    [[nodiscard]] std::size_t last() const { return levels.size() - 1; }

    /// The shot's, with the size of a level.
    [[nodiscard]] render::RenderSettings settings(std::size_t level) const;
};

/// `source`: of the shot. `most_samples`: 0: no limit. A channel has one layer, but the keys of
/// both. Throws Error if the question is not a valid one.
[[nodiscard]] PictureQuestion read_question(const See& see, const pipeline::FilmSource& source,
                                            int most_samples);

}  // namespace carom::studio
