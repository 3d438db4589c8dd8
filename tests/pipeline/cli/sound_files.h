// Reads what `carom sound` writes, and looks at it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace carom::testing {

inline constexpr double kSampleRate = 48000;  // Hz

/// The samples of a .wav file as whole numbers of 24 bits.
struct WavSamples {
    std::vector<std::int32_t> left, right;

    bool operator==(const WavSamples&) const = default;
};

/// Throws std::runtime_error if the file is not two channels of 24-bit PCM at 48 kHz whose header
/// says its length.
[[nodiscard]] WavSamples read_wav(const std::string& path);

/// Samples in units of full scale.
[[nodiscard]] std::vector<double> in_full_scale(const std::vector<std::int32_t>& samples);

/// A row of the table that --heard writes.
struct HeardRow {
    std::string kind, a, b, camera;
    double film_time = 0;  // s
    double scene_time = 0;
    double speed = 0;
    double time_factor = 0;
    double delay = 0;      // s
    double impulse = 0;    // N s
    double peak_time = 0;  // s
    double peak = 0;       // Pa
};

[[nodiscard]] std::vector<HeardRow> read_heard(const std::string& path);

/// The index of the highest absolute value in [from, to), which is cut to the samples that exist.
[[nodiscard]] std::size_t peak_index(const std::vector<std::int32_t>& samples, std::int64_t from,
                                     std::int64_t to);

/// The power of the samples at a frequency (Hz), without a window: their Fourier sum.
[[nodiscard]] double power_at(const std::vector<double>& samples, double frequency);

/// The frequency in [from, to] (Hz) at which the power is highest, among frequencies that differ by
/// a factor of 1.001.
[[nodiscard]] double spectral_peak(const std::vector<double>& samples, double from, double to);

}  // namespace carom::testing
