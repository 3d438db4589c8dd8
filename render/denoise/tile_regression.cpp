#include "render/denoise/tile_regression.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace carom::render {
namespace {

/// The neighbours of the pixels in a row: those in rows of the picture.
struct NeighbourRows {
    int first;  // the smallest difference of rows, and the largest
    int last;

    NeighbourRows(int y, int height)
        : first(std::max(-kWindow, -y)), last(std::min(kWindow, height - 1 - y)) {}

    [[nodiscard]] bool contains(int dy) const { return dy >= first && dy <= last; }
    [[nodiscard]] int index(int dx, int dy) const {
        return (dy - first) * kWindowSide + dx + kWindow;
    }
    [[nodiscard]] int count() const { return (last - first + 1) * kWindowSide; }
};

/// Predicts from one half, with weights from the other one.
class HalfTile {
  public:
    HalfTile(const DenoiseTile& tile, int half, const DenoiseKernels& kernels, BandPlanes& planes)
        : tile_(tile),
          kernels_(kernels),
          planes_(planes),
          half_(half),
          distances_(std::make_unique_for_overwrite<float[]>(
              static_cast<std::size_t>(kDistanceRow) * (DenoiseTile::kHeight + 2 * kPatch))),
          weights_(std::make_unique_for_overwrite<float[]>(
              static_cast<std::size_t>(DenoiseTile::kWidth) * DenoiseTile::kHeight * kNeighbours)) {
    }

    void predict() {
        for (int dy = -kWindow; dy <= kWindow; ++dy) {
            for (int dx = -kWindow; dx <= kWindow; ++dx) {
                weigh(dx, dy);
            }
        }
        for (int chunk = 0; chunk < tile_.chunks; ++chunk) {
            predict_chunk(chunk);
        }
    }

  private:
    static constexpr int kDistanceRow = DenoiseTile::kWidth + 2 * kChunk;

    [[nodiscard]] float* distance_row(int y) {
        return distances_.get() + std::ptrdiff_t{y - tile_.rows.first + kPatch} * kDistanceRow;
    }
    [[nodiscard]] float* weights_of(int y, int chunk) {
        return weights_.get() +
               (std::ptrdiff_t{y - tile_.rows.first} * tile_.chunks + chunk) * kNeighbours * kChunk;
    }

    void weigh(int dx, int dy) {
        for (int y = tile_.rows.first - kPatch; y < tile_.rows.end + kPatch; ++y) {
            measure_row(y, dx, dy);
        }
        for (int y = tile_.rows.first; y < tile_.rows.end; ++y) {
            const NeighbourRows neighbours(y, planes_.height);
            if (neighbours.contains(dy)) {
                kernels_.weigh(
                    {{distance_row(y - 1), distance_row(y), distance_row(y + 1)},
                     weights_of(y, 0) + std::ptrdiff_t{neighbours.index(dx, dy)} * kChunk,
                     tile_.chunks,
                     tile_.x + dx,
                     planes_.width});
            }
        }
    }

    /// The distances begin one column before the tile.
    void measure_row(int y, int dx, int dy) {
        const int own = std::clamp(y, 0, planes_.height - 1);
        const int other = std::clamp(y + dy, 0, planes_.height - 1);
        const ColourPlane& colour = planes_.half[1 - half_];
        const int x = tile_.x - kPatch;
        DistanceRow row{};
        for (int c = 0; c < kChannels; ++c) {
            row.colour[c] = colour[c].row(own) + x;
            row.other_colour[c] = colour[c].row(other) + x + dx;
            row.variance[c] = planes_.variance[c].row(own) + x;
            row.other_variance[c] = planes_.variance[c].row(other) + x + dx;
        }
        row.bandwidth2 = planes_.bandwidth2.row(own) + x;
        row.distance = distance_row(y);
        row.chunks = tile_.chunks + 1;
        kernels_.measure_distances(row);
    }

    /// By row of the tile, a bit for each three features.
    using Varying = std::array<unsigned, DenoiseTile::kHeight>;

    /// Sets the bit in the rows around whose pixels of the chunk the feature has different values.
    void add_varying(const Plane& feature, int x, unsigned bit, Varying& varying) const {
        const RowRange rows = tile_.rows.widened(kWindow, planes_.height);
        std::array<int, DenoiseTile::kHeight + 2 * kWindow> equal{};  // rows that end with this one
        float value = 0;
        for (int y = rows.first; y < rows.end; ++y) {
            const float* row = feature.row(y) + x;
            const auto i = static_cast<std::size_t>(y - rows.first);
            if (kernels_.is_constant(row - kWindow)) {
                equal[i] = 1 + (i > 0 && row[0] == value ? equal[i - 1] : 0);
            }
            value = row[0];
        }
        for (int y = tile_.rows.first; y < tile_.rows.end; ++y) {
            const NeighbourRows window(y, planes_.height);
            if (equal[static_cast<std::size_t>(y + window.last - rows.first)] <
                window.last - window.first + 1) {
                varying[static_cast<std::size_t>(y - tile_.rows.first)] |= bit;
            }
        }
    }

    /// The features that vary, in threes as they are; the others explain nothing, and leaving them
    /// out changes no bit.
    [[nodiscard]] Varying varying_features(int x) const {
        Varying varying{};
        const std::vector<Plane>& features = planes_.features[half_];
        for (std::size_t f = 0; f < features.size(); ++f) {
            add_varying(features[f], x, 1U << f / 3, varying);
        }
        return varying;
    }

    void predict_chunk(int number) {
        const int x = tile_.x + number * kChunk;
        const Varying varying = varying_features(x);
        for (int y = tile_.rows.first; y < tile_.rows.end; ++y) {
            const NeighbourRows neighbours(y, planes_.height);
            const std::vector<std::ptrdiff_t> offsets = offsets_of(neighbours);
            RegressionChunk chunk{};
            for (int c = 0; c < kChannels; ++c) {
                chunk.colour[c] = planes_.half[half_][c].row(y) + x;
                chunk.result[c] = planes_.prediction[half_][c].row(y) + x;
                chunk.checked[c] = planes_.checked[half_][c].row(y) + x;
            }
            std::size_t count = 0;
            for (std::size_t f = 0; f < planes_.exact.size(); ++f) {
                if ((varying[static_cast<std::size_t>(y - tile_.rows.first)] >> f / 3 & 1) != 0) {
                    chunk.feature[count] = planes_.features[half_][f].row(y) + x;
                    chunk.other_feature[count] = planes_.features[1 - half_][f].row(y) + x;
                    chunk.exact[count] = planes_.exact[f].row(y) + x;
                    ++count;
                }
            }
            chunk.share = planes_.share.row(y) + x;
            chunk.ridge = planes_.ridge.row(y) + x;
            chunk.weight = weights_of(y, number);
            chunk.neighbours = offsets.data();
            chunk.neighbour_count = neighbours.count();
            kernels_.regress[count / 3](chunk);
        }
    }

    [[nodiscard]] std::vector<std::ptrdiff_t> offsets_of(const NeighbourRows& neighbours) const {
        std::vector<std::ptrdiff_t> result;
        for (int dy = neighbours.first; dy <= neighbours.last; ++dy) {
            for (int dx = -kWindow; dx <= kWindow; ++dx) {
                result.push_back(dy * planes_.mean[0].stride() + dx);
            }
        }
        return result;
    }

    const DenoiseTile& tile_;
    const DenoiseKernels& kernels_;
    BandPlanes& planes_;
    int half_;
    std::unique_ptr<float[]> distances_;
    std::unique_ptr<float[]> weights_;
};

}  // namespace

std::vector<DenoiseTile> tiles_of(const BandPlanes& planes) {
    std::vector<DenoiseTile> result;
    const RowRange& rows = planes.predicted;
    for (int y = rows.first; y < rows.end; y += DenoiseTile::kHeight) {
        for (int x = 0; x < planes.width; x += DenoiseTile::kWidth) {
            const int width = std::min(DenoiseTile::kWidth, rounded_up(planes.width) - x);
            result.push_back(
                {x, width / kChunk, {y, std::min(y + DenoiseTile::kHeight, rows.end)}});
        }
    }
    return result;
}

void predict_tile(const DenoiseTile& tile, const DenoiseKernels& kernels, BandPlanes& planes) {
    for (int half = 0; half < kHalves; ++half) {
        HalfTile(tile, half, kernels, planes).predict();
    }
}

}  // namespace carom::render
