// Pictures of many samples, against which errors are measured.
#pragma once

#include <string>
#include <vector>

#include "bench/gain_frames.h"
#include "bench/picture.h"

namespace carom::bench {

/// Two pictures with independent noise, whose mean is the reference.
struct Reference {
    Picture mean;
    /// Half of the difference of the two: its square is the expected variance of `mean`.
    Picture difference;
    int samples = 0;  // of both together
};

/// The file of a frame's reference in a folder.
[[nodiscard]] std::string reference_path(const std::string& folder, const std::string& frame,
                                         const GainOptions& options);

/// Renders what the file lacks, `kReferenceNet` samples at a time, and writes it after each of
/// them, so that an interrupted run is resumed. Throws std::runtime_error.
inline constexpr int kReferenceNet = 256;
void make_reference(const std::string& path, const GainFrame& frame, int samples);

/// Throws std::runtime_error if it is missing or has another size.
[[nodiscard]] Reference read_reference(const std::string& path, const GainOptions& options);

/// The expected relMSE of `x`, from a reference whose own noise is taken off.
[[nodiscard]] double error_of(const Picture& x, const Reference& reference);

/// Colours without alpha.
[[nodiscard]] Picture colours_of(const render::Film& film);

}  // namespace carom::bench
