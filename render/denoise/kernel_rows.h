// What the denoiser's kernels read and write: plain data, which devices understand, too. Internal
// to this folder.
#pragma once

#include <cstddef>

namespace carom::render {

/// Pixels of a row that are worked on together: as many as a vector has lanes, or more.
inline constexpr int kChunk = 16;

// Radii were chosen on four frames of billiards and dominoes at 480x270, with two halves of 16
// samples each: windows of 7x7 pixels with patches of 3x3 were better and ten times cheaper than
// the 19x19 and 7x7 of the paper.
inline constexpr int kWindow = 3;  // radius, pixels
inline constexpr int kPatch = 1;   // radius, pixels
inline constexpr int kWindowSide = 2 * kWindow + 1;
inline constexpr int kNeighbours = kWindowSide * kWindowSide;
inline constexpr int kMostRegressors = 9;

/// Distances between the pixels of a row and their neighbours at one offset.
struct DistanceRow {
    const float* colour[3];  // of the pixels
    const float* other_colour[3];
    const float* variance[3];
    const float* other_variance[3];
    const float* bandwidth2;  // of the weights, squared (NoiseRow)
    float* distance;          // result
    int chunks = 0;
};

/// Weights of the neighbours at one offset, from the distances of three rows that begin one column
/// before the pixels.
struct WeightRow {
    const float* distance[3];
    float* weight;  // result: those of chunk i begin at weight[i * kNeighbours * kChunk]
    int chunks = 0;
    int neighbour = 0;  // the column of the first pixel's neighbour
    int width = 0;      // of the picture; neighbours outside get the weight 0
};

/// A chunk of pixels whose colours are predicted. Pointers are those of the first pixel.
struct RegressionChunk {
    const float* colour[3];
    const float* feature[kMostRegressors];        // of the same samples
    const float* other_feature[kMostRegressors];  // of the other half's samples
    const float* exact[kMostRegressors];          // where the prediction is evaluated
    const float* share;                           // of the samples in the exact features
    const float* ridge;                           // of the fit (NoiseRow)
    const float* weight;                          // kChunk numbers for each neighbour
    const std::ptrdiff_t* neighbours;             // offsets from a pixel to its neighbours
    int neighbour_count = 0;
    float* result[3];
    float* checked[3];  // the same, evaluated where nothing is known of the other half
};

struct SquareRow {
    const float* values;
    float* squares;  // result
    int chunks = 0;
};

/// Means over squares of pixels, in one row.
struct BoxRow {
    const float* const* rows;  // 2 radius + 1 of them
    int radius = 0;
    float* mean;  // result
    float* sums;  // of columns: room for as many, and for a chunk on either side
    int chunks = 0;
};

/// What the errors of a row of pixels are estimated from.
struct ErrorRow {
    const float* mean[3];        // of the halves
    const float* difference[3];  // half of that between them
    const float* from_a[3];      // predicted from half A
    const float* from_b[3];
    const float* checked_a[3];  // the same, knowing nothing of B
    const float* checked_b[3];  // and of A
    float* noisy;               // result: the relative squared error of the halves' mean
    float* filtered;            // result: that of the predictions' mean
    float* shift;  // result: the relative squared difference of both means, minus `noisy`
    int chunks = 0;
};

/// How the level of the variance is joined with its shape.
struct VarianceRow {
    const float* level;        // mean of squared differences over a large square
    const float* near_level;   // over a small square
    const float* most_level;   // over a smaller one
    const float* shape;        // of the known variance over a small square, or null
    const float* large_shape;  // over a large square
    float* variance;           // result, of one half
    int chunks = 0;
};

/// What the weights and the regression need to know of the noise of a row of pixels.
struct NoiseRow {
    const float* mean[3];      // of both halves, over a small square
    const float* variance[3];  // of one half
    float* bandwidth2;         // result
    float* ridge;              // result
    int chunks = 0;
};

/// A channel of filtered pixels in a row.
struct LimitRow {
    const float* from_a;  // predicted from half A
    const float* from_b;
    const float* mean;           // of the halves
    const float* squared;        // half of the difference between them
    const float* near_squared;   // its mean over a small square
    const float* plain;          // 1 where all samples and rays saw the same, else 0
    const float* plain_share;    // its mean over the small square
    const float* plain_squared;  // the mean of `squared` times `plain`
    float* limited;              // result: at least 0
    int chunks = 0;
};

}  // namespace carom::render
