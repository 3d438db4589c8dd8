#include "sound/mix/film_mix.h"

#include <algorithm>

namespace carom::sound {
namespace {

// Spheres are heard up to their diameter over the speed of sound before the sound of the contact;
// where the way takes no time, that is before the instant.
constexpr double kLeastLookAhead = 0.02;  // s, twice a ball's in slow motion

}  // namespace

FilmMix::FilmMix(const SoundScene& scene, std::optional<Group> only)
    : scene_(scene), only_(only), hearing_(scene), crossings_(scene) {
    const bool rolls = !only || *only == Group::rolling;
    for (std::size_t i = 0; i < scene.shots.size(); ++i) {
        shots_.emplace_back(scene.shots[i], rolls);
        look_ahead_ = std::max(look_ahead_, hearing_.longest_mirrored_ring(i));
    }
    look_ahead_ += kLeastLookAhead;
}

void FilmMix::start_voices() {
    const double block_end =
        static_cast<double>(block_ + static_cast<std::int64_t>(kBlock)) / kSampleRate;
    const double film_end = static_cast<double>(scene_.frames) / kSampleRate;
    const double until = std::min(block_end + look_ahead_, film_end);
    while (const std::optional<Crossing> crossing = crossings_.next_before(until)) {
        const std::optional<Heard> heard = hearing_.at(*crossing);
        if (heard && (!only_ || heard->row.group == *only_)) {
            shots_[crossing->shot].start(*heard);
        }
    }
}

void FilmMix::add_block(std::span<double> left, std::span<double> right) {
    start_voices();
    for (ShotMix& shot : shots_) {
        shot.add_block(block_, left, right);
    }
    block_ += static_cast<std::int64_t>(kBlock);
}

}  // namespace carom::sound
