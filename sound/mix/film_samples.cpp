#include "sound/mix/film_samples.h"

#include <algorithm>

#include "core/assert.h"
#include "sound/level/decibels.h"

namespace carom::sound {
namespace {

constexpr double kEndFade = 240;  // samples, 5 ms

}  // namespace

FilmSamples::FilmSamples(std::int64_t frames, const FilmGain& gain, FilmBlocks& whole,
                         FilmBlocks* part)
    : frames_(frames), full_scale_(gain.full_scale), whole_(whole), part_(part) {
    if (gain.limits) {
        limiter_.emplace(factor_of(kHighestTruePeak));
        to_skip_ = Limiter::kDelay;
    }
    whole_.rewind();
    if (part_ != nullptr) {
        part_->rewind();
    }
}

double FilmSamples::limited() const {
    return limiter_ ? decibels_of(1 / limiter_->lowest_factor()) : 0;
}

double FilmSamples::fade_at(std::int64_t frame) const {
    return std::min(1.0, static_cast<double>(frames_ - 1 - frame) / kEndFade);
}

void FilmSamples::make_block() {
    const auto next_of = [this](FilmBlocks& blocks, Block& left, Block& right) {
        blocks.next(left, right);
        for (std::size_t n = 0; n < kBlock; ++n) {
            left[n] /= full_scale_;
            right[n] /= full_scale_;
        }
    };
    next_of(part_ == nullptr ? whole_ : *part_, left_, right_);
    next_ = 0;
    if (!limiter_) {
        return;
    }
    if (part_ == nullptr) {
        limiter_->run(left_, right_);
    } else {
        Block key_left{};
        Block key_right{};
        next_of(whole_, key_left, key_right);
        limiter_->run(key_left, key_right, left_, right_);
    }
    next_ = std::min(to_skip_, kBlock);
    to_skip_ -= next_;
}

std::size_t FilmSamples::read(std::span<double> left, std::span<double> right) {
    CAROM_ASSERT(left.size() == right.size());
    const auto count = static_cast<std::size_t>(
        std::min<std::int64_t>(static_cast<std::int64_t>(left.size()), frames_ - position_));
    for (std::size_t done = 0; done < count;) {
        if (next_ == kBlock) {
            make_block();
            continue;
        }
        const std::size_t part = std::min(count - done, kBlock - next_);
        for (std::size_t i = 0; i < part; ++i) {
            const double fade = fade_at(position_ + static_cast<std::int64_t>(i));
            left[done + i] = fade * left_[next_ + i];
            right[done + i] = fade * right_[next_ + i];
        }
        done += part;
        next_ += part;
        position_ += static_cast<std::int64_t>(part);
    }
    return count;
}

}  // namespace carom::sound
