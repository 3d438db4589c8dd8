// The planes of a band, which is some rows of a picture while they are denoised. Internal to this
// folder.
#pragma once

#include <array>
#include <vector>

#include "render/denoise/plane.h"

namespace carom::render {

inline constexpr int kChannels = 3;
inline constexpr int kHalves = 2;

using ColourPlane = std::array<Plane, kChannels>;

struct BandPlanes {
    int width = 0;  // pixels of the whole picture
    int height = 0;
    int chunks = 0;  // of a row

    RowRange rows;       // of the result
    RowRange predicted;  // with those that the estimates of the error look at
    RowRange weighed;    // with those that predictions look at
    RowRange known;      // with those that the variance is estimated from

    ColourPlane mean, difference, squares;             // squares of the differences
    std::array<ColourPlane, kHalves> half;             // A and B
    Plane bandwidth2, ridge;                           // NoiseRow
    ColourPlane variance;                              // of a half
    Plane shape;                                       // the known variance
    std::vector<Plane> exact;                          // features
    std::array<std::vector<Plane>, kHalves> features;  // of the halves' samples
    Plane share;                                       // of the samples in the exact features
    /// 1 where all samples and camera rays saw the same, so that no feature has an error or a
    /// difference; else 0. And `squares` times that.
    Plane plain;
    ColourPlane plain_squares;
    std::array<ColourPlane, kHalves> prediction;        // from A and from B
    std::array<ColourPlane, kHalves> checked;           // the same, knowing nothing of B and A
    Plane noisy_error, filtered_error, squared_excess;  // of pixels
    Plane shift, squared_shift;  // by the filter, without the noise that explains it
    Plane mean_noisy_error, mean_filtered_error, mask;
};

}  // namespace carom::render
