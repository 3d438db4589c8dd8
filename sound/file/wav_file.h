// Writes sound as a WAV file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/atomic_file.h"

namespace carom::sound {

/// Two channels of 24-bit PCM at kSampleRate, without dither: samples of 1 and more become the
/// highest number, 0 stays 0. A file of 4 GB and more is written as RF64 (EBU Tech 3306), which has
/// the same layout with 64-bit sizes. The file gets its name when it is complete.
class WavFile {
  public:
    /// For `frames` samples of each channel. Throws Error, as all functions do, if the file cannot
    /// be written.
    WavFile(const std::string& path, std::int64_t frames);

    /// Appends samples in units of full scale; both channels have the same size.
    void write(std::span<const double> left, std::span<const double> right);

    /// Requires that all frames have been written.
    void finish();

  private:
    AtomicWriter file_;
    std::int64_t missing_;  // frames
    std::vector<std::byte> bytes_;
};

/// The header of such a file: 44 bytes, or 80 for RF64.
[[nodiscard]] std::vector<std::byte> wav_header(std::int64_t frames);

/// A sample as a 24-bit number: 2^23 times the sample, rounded to the nearest (halves to even) and
/// limited to [-2^23, 2^23 - 1].
[[nodiscard]] std::int32_t pcm24(double sample);

}  // namespace carom::sound
