// Reads the sound of a file.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "pipeline/video/sound_source.h"

namespace carom::pipeline {

/// The first stream of sound in a file that libav can read, as two channels at kSoundRate. One
/// channel is given on both sides. Other rates and more channels are converted by libswresample in
/// integers, whose results do not depend on the processor.
class SoundDecoder : public SoundSource {
  public:
    /// Throws Error that names `path` if the file cannot be read or has no sound.
    explicit SoundDecoder(const std::string& path);
    ~SoundDecoder() override;
    SoundDecoder(const SoundDecoder&) = delete;
    SoundDecoder& operator=(const SoundDecoder&) = delete;

    /// As of SoundSource; throws Error if the file is damaged.
    std::size_t read(std::span<double> left, std::span<double> right) override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::pipeline
