// What gives the sound of a film, from its first sample to its last.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sound/sound_scene.h"

namespace carom::pipeline {

inline constexpr int kSoundRate = sound::kSampleRate;  // samples of each channel per second

/// The number of samples that callers read at once, where nothing else decides.
inline constexpr std::size_t kSoundBlock = 1024;

/// Two channels at kSoundRate, in units of full scale: what exceeds [-1, 1] is cut off in the file.
/// For one thread at a time.
class SoundSource {
  public:
    SoundSource() = default;
    virtual ~SoundSource() = default;
    SoundSource(const SoundSource&) = delete;
    SoundSource& operator=(const SoundSource&) = delete;

    /// Fills the beginning of both spans, which have the same size of at least 1, with the next
    /// samples. Returns how many these are: at least one, except after the end of the sound, where
    /// it is always 0. Throws Error, Stopped.
    virtual std::size_t read(std::span<double> left, std::span<double> right) = 0;

    /// Passes over the next `samples` samples, or over all if there are fewer. Throws like read().
    virtual void skip(std::int64_t samples) {
        std::array<double, kSoundBlock> left{};
        std::array<double, kSoundBlock> right{};
        while (samples > 0) {
            const auto wanted = std::min(static_cast<std::size_t>(samples), kSoundBlock);
            const std::size_t got =
                read(std::span(left).first(wanted), std::span(right).first(wanted));
            if (got == 0) {
                return;
            }
            samples -= static_cast<std::int64_t>(got);
        }
    }
};

}  // namespace carom::pipeline
