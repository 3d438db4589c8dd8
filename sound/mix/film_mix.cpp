#include "sound/mix/film_mix.h"

#include <algorithm>
#include <array>
#include <utility>

namespace carom::sound {
namespace {

// Spheres are heard up to their diameter over the speed of sound before the sound of the contact;
// without a delay to the listener that is before the instant.
constexpr double kMinLookAhead = 0.02;  // s, twice a ball's in slow motion

}  // namespace

FilmMix::FilmMix(SoundScene scene, std::optional<Group> only)
    : scene_(std::move(scene)),
      only_(only),
      keeps_(scene_.frames <= kMaxKept),
      auralisation_(scene_),
      onsets_(onsets_of(scene_)),
      look_ahead_(kMinLookAhead) {
    for (std::size_t i = 0; i < scene_.shots.size(); ++i) {
        look_ahead_ = std::max(look_ahead_, kMinLookAhead + auralisation_.longest_mirrored_ring(i));
    }
    begin();
}

void FilmMix::add(AddedSound sound, double pascals) {
    added_ = std::move(sound);
    pascals_ = pascals;
}

void FilmMix::begin() {
    shots_.clear();
    for (const SoundShot& shot : scene_.shots) {
        shots_.emplace_back(shot, !only_ || *only_ == Group::rolling);
    }
    next_onset_ = 0;
    block_ = 0;
}

void FilmMix::rewind() {
    read_ = 0;
    if (!keeps_) {
        begin();
    }
    reader_ = added_ ? added_() : SampleReader();
}

void FilmMix::next(std::span<double> left, std::span<double> right) {
    if (read_ < kept_.size()) {
        const std::span<const double> block = std::span(kept_).subspan(read_, 2 * kBlock);
        std::ranges::copy(block.first(kBlock), left.begin());
        std::ranges::copy(block.last(kBlock), right.begin());
    } else {
        mix(left, right);
        if (keeps_) {
            kept_.insert(kept_.end(), left.begin(), left.end());
            kept_.insert(kept_.end(), right.begin(), right.end());
        }
    }
    read_ += keeps_ ? 2 * kBlock : 0;
    if (reader_) {
        add_next(left, right);
    }
}

void FilmMix::start_voices() {
    const double block_end = time_of_sample(block_ + static_cast<std::int64_t>(kBlock));
    const double until = std::min(block_end + look_ahead_, time_of_sample(scene_.frames));
    for (; next_onset_ < onsets_.size() && onsets_[next_onset_].film_time < until; ++next_onset_) {
        const Onset& onset = onsets_[next_onset_];
        const std::optional<AuralisedImpact> heard = auralisation_.at(onset);
        if (heard && (!only_ || heard->row.group == *only_)) {
            shots_[onset.shot].start(*heard);
        }
    }
}

/// Mixes the next block that is not kept.
void FilmMix::mix(std::span<double> left, std::span<double> right) {
    std::ranges::fill(left, 0.0);
    std::ranges::fill(right, 0.0);
    start_voices();
    for (ShotMix& shot : shots_) {
        shot.add_block(block_, left, right);
    }
    block_ += static_cast<std::int64_t>(kBlock);
}

/// Adds the next block of the added sound.
void FilmMix::add_next(std::span<double> left, std::span<double> right) {
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
