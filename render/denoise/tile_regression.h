// Predicts the colours of a tile. Internal to this folder.
#pragma once

#include <vector>

#include "render/denoise/band_planes.h"
#include "render/denoise/denoise_kernels.h"

namespace carom::render {

struct DenoiseTile {
    static constexpr int kWidth = 7 * kChunk;  // so that the distances of 8 chunks suffice
    static constexpr int kHeight = 16;

    int x = 0;
    int chunks = 0;
    RowRange rows;
};

/// The tiles of the rows that a band predicts.
[[nodiscard]] std::vector<DenoiseTile> tiles_of(const BandPlanes& planes);

/// Sets the tile's pixels of `planes.prediction`, from the colours, variances and features.
void predict_tile(const DenoiseTile& tile, const DenoiseKernels& kernels, BandPlanes& planes);

}  // namespace carom::render
