#include "sound/mix/film_blocks.h"

#include <algorithm>
#include <array>
#include <utility>

namespace carom::sound {

FilmBlocks::FilmBlocks(const SoundScene& scene, std::optional<Group> only)
    : scene_(scene),
      only_(only),
      keeps_(scene.frames <= kMostKept),
      mix_(std::make_unique<FilmMix>(scene, only)) {}

void FilmBlocks::add(AddedSound sound, double pascals) {
    added_ = std::move(sound);
    pascals_ = pascals;
}

void FilmBlocks::rewind() {
    read_ = 0;
    if (!keeps_) {
        mix_ = std::make_unique<FilmMix>(scene_, only_);
    }
    reader_ = added_ ? added_() : SampleReader();
}

void FilmBlocks::next(std::span<double> left, std::span<double> right) {
    next_computed(left, right);
    if (reader_) {
        next_added(left, right);
    }
}

void FilmBlocks::next_computed(std::span<double> left, std::span<double> right) {
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

void FilmBlocks::next_added(std::span<double> left, std::span<double> right) {
    std::array<double, kBlock> added_left{};
    std::array<double, kBlock> added_right{};
    for (std::size_t done = 0; done < kBlock;) {
        const std::size_t count =
            reader_(std::span(added_left).subspan(done), std::span(added_right).subspan(done));
        if (count == 0) {
            reader_ = {};
            break;
        }
        done += count;
    }
    for (std::size_t n = 0; n < kBlock; ++n) {
        left[n] += pascals_ * added_left[n];
        right[n] += pascals_ * added_right[n];
    }
}

}  // namespace carom::sound
