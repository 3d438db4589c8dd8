// From the pressures of a film to its samples.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "sound/level/limiter.h"
#include "sound/mix/film_blocks.h"
#include "sound/mix/film_gain.h"

namespace carom::sound {

/// Samples of a film in units of full scale, with its gain, limited and faded at the end. They come
/// in order, in blocks of any size: their bits do not depend on it.
class FilmSamples {
  public:
    /// Rewinds the blocks, which are borrowed. `part`: of the film, whose samples are wanted
    /// instead of all, turned down as the whole is; null: all.
    FilmSamples(std::int64_t frames, const FilmGain& gain, FilmBlocks& whole,
                FilmBlocks* part = nullptr);

    /// As of FilmSound.
    std::size_t read(std::span<double> left, std::span<double> right);

    [[nodiscard]] std::int64_t position() const { return position_; }

    /// The most that the limiter has taken away, dB, >= 0.
    [[nodiscard]] double limited() const;

  private:
    using Block = std::array<double, kBlock>;

    void make_block();
    [[nodiscard]] double fade_at(std::int64_t frame) const;

    std::int64_t frames_;
    double full_scale_;
    FilmBlocks& whole_;
    FilmBlocks* part_;
    std::optional<Limiter> limiter_;
    Block left_{}, right_{};  // samples that are ready
    std::size_t next_ = kBlock;
    std::size_t to_skip_ = 0;  // samples by which the limiter is late
    std::int64_t position_ = 0;
};

}  // namespace carom::sound
