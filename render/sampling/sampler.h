// The random numbers of one sample of a pixel: Owen-scrambled Sobol points (Sobol 1967; Owen 1995;
// hash-based scrambling after Laine and Karras 2011 and Burley 2020), a pure function of (seed,
// pixel, sample, dimension). kernels/sampler.h has the formulas. Any aligned run of 2^k samples of
// a pixel is stratified.
#pragma once

#include <array>
#include <cstdint>

#include "render/geometry/ray.h"

namespace carom::render {

/// Pixel, lens and time of a camera ray: one five-dimensional Sobol point. All in [0, 1).
struct CameraSample {
    V2f pixel;
    V2f lens;
    float time = 0;
};

/// Returns the dimensions of one sample of one pixel, in order. Cheap to copy; no shared state.
class SampleStream {
  public:
    SampleStream(std::uint64_t seed, std::uint32_t pixel_x, std::uint32_t pixel_y,
                 std::uint32_t sample);

    /// Does not advance the stream.
    [[nodiscard]] CameraSample camera_sample() const;
    /// The stream with this state.
    [[nodiscard]] static SampleStream of_state(std::uint32_t pixel_hash,
                                               std::uint32_t reversed_sample) {
        SampleStream stream;
        stream.pixel_hash_ = pixel_hash;
        stream.reversed_sample_ = reversed_sample;
        return stream;
    }
    /// The stream of another sample of the same pixel.
    [[nodiscard]] SampleStream of_sample(std::uint32_t sample) const;

    /// The next four dimensions: one shuffled, scrambled four-dimensional Sobol point.
    [[nodiscard]] std::array<float, 4> next_4d();

    /// One number of a set, independent from sample to sample. It is for choices of very small
    /// probability, which gain nothing from stratification.
    [[nodiscard]] float get_1d(std::uint32_t set) const;

    /// Continues at the given set of four dimensions. A path whose branches end at different depths
    /// gives every vertex sets of its own, so that samples stay comparable.
    void seek(std::uint32_t set) { set_ = set; }

    // The state apart from the set, for code that computes the numbers of many samples at once.
    [[nodiscard]] std::uint32_t pixel_hash() const { return pixel_hash_; }
    [[nodiscard]] std::uint32_t reversed_sample() const { return reversed_sample_; }

  private:
    SampleStream() = default;

    std::uint32_t pixel_hash_ = 0;
    std::uint32_t reversed_sample_ = 0;  // the sample's number with its bits reversed
    std::uint32_t set_ = 0;              // index of the next four dimensions
};

}  // namespace carom::render
