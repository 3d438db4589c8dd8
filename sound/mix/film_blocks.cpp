#include "sound/mix/film_blocks.h"

#include <algorithm>

namespace carom::sound {

FilmBlocks::FilmBlocks(const SoundScene& scene, std::optional<Group> only)
    : scene_(scene),
      only_(only),
      keeps_(scene.frames <= kMostKept),
      mix_(std::make_unique<FilmMix>(scene, only)) {}

void FilmBlocks::rewind() {
    read_ = 0;
    if (!keeps_) {
        mix_ = std::make_unique<FilmMix>(scene_, only_);
    }
}

void FilmBlocks::next(std::span<double> left, std::span<double> right) {
    if (read_ < kept_.size()) {
        const std::span<const double> block = std::span(kept_).subspan(read_, 2 * kBlock);
        std::ranges::copy(block.first(kBlock), left.begin());
        std::ranges::copy(block.last(kBlock), right.begin());
    } else {
        std::ranges::fill(left, 0.0);
        std::ranges::fill(right, 0.0);
        mix_->add_block(left, right);
        if (keeps_) {
            kept_.insert(kept_.end(), left.begin(), left.end());
            kept_.insert(kept_.end(), right.begin(), right.end());
        }
    }
    read_ += keeps_ ? 2 * kBlock : 0;
}

}  // namespace carom::sound
