// How bright a film of high dynamic range is, as its file states it.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Of a film's pictures, one after the other. A pixel's light is that of its highest channel
/// (CTA-861.3, annex P).
class LightMeter {
  public:
    /// 16-bit RGB, PQ-encoded.
    void add(std::span<const std::uint16_t> signal);

    /// So far. At least 1 each: 0 would mean that it is not known.
    [[nodiscard]] LightLevels levels() const;

  private:
    double brightest_ = 0;       // cd/m^2
    double brightest_mean_ = 0;  // of a picture
};

}  // namespace carom::pipeline
