#include "pipeline/video/peak_limit.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace carom::pipeline {

namespace {

// BT.2020-2, table 4: weights of red and blue in luma, and the divisors of the colour differences.
constexpr double kRed = 0.2627, kGreen = 0.678, kBlue = 0.0593;
constexpr double kRedDifference = 1.4746, kBlueDifference = 1.8814;
// Codes of 10 bits in limited range.
constexpr double kBlackLuma = 64, kLumaRange = 876;
constexpr double kNoColour = 512, kColourRange = 896;

/// The two colour differences at one position, as fractions of their range.
struct Colour {
    double blue = 0, red = 0;

    /// The amount by which the highest channel exceeds luma.
    [[nodiscard]] double above_luma() const {
        const double r = kRedDifference * red;
        const double b = kBlueDifference * blue;
        return std::max({0.0, r, b, -(kRed * r + kBlue * b) / kGreen});
    }
};

/// Reads the colour planes in the ways that decoders do.
class ColourReader {
  public:
    ColourReader(const YuvPlanes<std::uint16_t>& planes, int width, int height)
        : planes_(planes), columns_(width / 2), rows_(height / 2) {}

    /// The largest value of above_luma in the picture. Interpolated colours cannot exceed it.
    [[nodiscard]] double most_above_luma() const {
        double most = 0;
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column) {
                most = std::max(most, sample(column, row).above_luma());
            }
        }
        return most;
    }

    [[nodiscard]] Colour repeated(int x, int y) const { return sample(x / 2, y / 2); }

    /// Colour samples are sited at the even columns, halfway between two rows.
    [[nodiscard]] Colour interpolated(int x, int y) const {
        const int row = y / 2;
        const Colour near = level(x, row);
        const Colour far = level(x, y % 2 == 0 ? row - 1 : row + 1);
        return {0.75 * near.blue + 0.25 * far.blue, 0.75 * near.red + 0.25 * far.red};
    }

  private:
    [[nodiscard]] Colour level(int x, int row) const {
        const Colour left = sample(x / 2, row);
        if (x % 2 == 0) {
            return left;
        }
        const Colour right = sample(x / 2 + 1, row);
        return {0.5 * (left.blue + right.blue), 0.5 * (left.red + right.red)};
    }

    /// Positions beyond the picture use the nearest edge sample.
    [[nodiscard]] Colour sample(int column, int row) const {
        column = std::clamp(column, 0, columns_ - 1);
        row = std::clamp(row, 0, rows_ - 1);
        const auto at = [&](const PlaneView<std::uint16_t>& plane) {
            return (plane.data[row * plane.stride + column] - kNoColour) / kColourRange;
        };
        return {at(planes_.blue_difference), at(planes_.red_difference)};
    }

    const YuvPlanes<std::uint16_t>& planes_;
    int columns_, rows_;
};

}  // namespace

void limit_to_peak(const YuvPlanes<std::uint16_t>& planes, int width, int height, double peak) {
    CAROM_ASSERT(width % 2 == 0 && height % 2 == 0);
    const ColourReader colour(planes, width, height);
    const auto limit = [&](double above) {
        const double code = kBlackLuma + kLumaRange * std::max(0.0, peak - above);
        return static_cast<std::uint16_t>(code);
    };
    const std::uint16_t safe = limit(colour.most_above_luma());  // whatever the colour
    for (int y = 0; y < height; ++y) {
        std::uint16_t* luma = planes.luma.data + y * planes.luma.stride;
        for (int x = 0; x < width; ++x) {
            if (luma[x] <= safe) {
                continue;
            }
            const double above = std::max(colour.repeated(x, y).above_luma(),
                                          colour.interpolated(x, y).above_luma());
            luma[x] = std::min(luma[x], limit(above));
        }
    }
}

}  // namespace carom::pipeline
