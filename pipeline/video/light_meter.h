// Measures the light levels that an HDR10 file states (MaxCLL and MaxFALL).
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Measures the pictures of a film, one after the other. The luminance of a pixel is that of its
/// highest channel (CTA-861.3, annex P).
class LightMeter {
  public:
    /// Adds a picture: 16-bit RGB, PQ-encoded.
    void add(std::span<const std::uint16_t> signal);

    /// The levels of all pictures added so far. Each is at least 1, because 0 would mean "not
    /// known".
    [[nodiscard]] LightLevels levels() const;

  private:
    double brightest_ = 0;       // cd/m^2
    double brightest_mean_ = 0;  // of a picture
};

}  // namespace carom::pipeline
