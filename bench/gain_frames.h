// The frames on which the gain of denoising is measured.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/frame/frame.h"

namespace carom::bench {

/// How a frame is sampled.
struct Sampling {
    int samples = 8;   // of each pixel; the first ones with adaptive sampling
    double noise = 0;  // the error at which adaptive sampling ends; 0: all samples are even
    bool for_denoiser = false;
};

/// A frame that can be rendered any number of times, with any seed.
class GainFrame {
  public:
    virtual ~GainFrame() = default;

    /// Renders on the calling thread's arena. `seed`: of the noise.
    [[nodiscard]] virtual render::Film render(const Sampling& sampling, int seed) const = 0;

  protected:
    GainFrame() = default;
    GainFrame(const GainFrame&) = default;
    GainFrame& operator=(const GainFrame&) = default;
};

struct GainOptions {
    int width = 320;  // pixels
    int height = 180;
    int max_bounces = 3;
};

/// The name of a film in examples/ and a second of it, as in "park@3"; the frame after that one, as
/// in "park@3+1"; or "benchmark", the scene for comparisons between renderers. Throws
/// std::exception.
[[nodiscard]] std::unique_ptr<const GainFrame> open_gain_frame(const std::string& name,
                                                               const GainOptions& options);

/// Those of which the gain is measured.
[[nodiscard]] const std::vector<std::string>& gain_frames();

/// Those whose change to the next frame is measured.
[[nodiscard]] const std::vector<std::string>& flicker_frames();

}  // namespace carom::bench
