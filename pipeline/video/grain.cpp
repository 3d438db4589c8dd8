#include "pipeline/video/grain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::pipeline {

namespace {

constexpr double kRadius = 2.4e-5;  // of the picture's height, at strength 1

/// Spreads the bits of a number over all of them (the finaliser of MurmurHash3, A. Appleby).
constexpr std::uint32_t spread(std::uint32_t bits) {
    bits = (bits ^ bits >> 16U) * 0x85ebca6bU;
    bits = (bits ^ bits >> 13U) * 0xc2b2ae35U;
    return bits ^ bits >> 16U;
}

/// A number with the mean 0 and the variance 1 that is nearly normal: the sum of four of [0, 255].
float normal_of(std::uint32_t bits) {
    const std::uint32_t pairs = (bits & 0xff00ffU) + (bits >> 8U & 0xff00ffU);
    const std::uint32_t sum = (pairs & 0xffffU) + (pairs >> 16U);
    // Each has the variance (256^2 - 1) / 12.
    constexpr float kScale = 0.0067659F;
    return (static_cast<float>(sum) - 510.0F) * kScale;
}

/// The deviation that grains with a radius of one pixel give to a 16-bit signal, by 1/256 of the
/// signal.
std::array<float, 257> make_deviations() {
    std::array<float, 257> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double k = grain_variance(static_cast<double>(i) / 256);
        table[i] = static_cast<float>(65535 * std::sqrt(std::numbers::pi * k));
    }
    return table;
}

}  // namespace

double grain_variance(double u) {
    if (!(u > 0 && u < 1)) {
        return 0;
    }
    // Places at the distance d, in radii, are both bare with the probability (1 - u)^(2 - overlap),
    // where `overlap` is the part that two grains around them share.
    constexpr int kSteps = 256;
    constexpr double kStep = 2.0 / kSteps;
    const double bare = 1 - u;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double d = (i + 0.5) * kStep;
        const double overlap =
            (2 * arccosine(d / 2) - d * std::sqrt(4 - d * d) / 2) * std::numbers::inv_pi;
        sum += (power(bare, 2 - overlap) - bare * bare) * 2 * d * kStep;
    }
    return sum;
}

void add_grain(std::span<std::uint16_t> signal, const GrainPlace& place, double strength) {
    CAROM_ASSERT(place.width > 0 &&
                 signal.size() % (3 * static_cast<std::size_t>(place.width)) == 0);
    static const std::array<float, 257> deviation = make_deviations();
    const auto radius = static_cast<float>(kRadius * strength * place.height);  // pixels
    const auto frame = static_cast<std::uint64_t>(place.frame);
    const std::uint32_t of_frame = spread(static_cast<std::uint32_t>(frame) ^
                                          spread(static_cast<std::uint32_t>(frame >> 32U)));
    const std::size_t row_length = 3 * static_cast<std::size_t>(place.width);
    const std::size_t rows = signal.size() / row_length;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::uint32_t of_row = spread(of_frame + static_cast<std::uint32_t>(place.first_row) +
                                            static_cast<std::uint32_t>(row));
        for (std::size_t i = 0; i < row_length; ++i) {
            std::uint16_t& value = signal[row * row_length + i];
            const std::uint32_t bits = spread(of_row ^ static_cast<std::uint32_t>(i) * 0x9e3779b9U);
            const float at = static_cast<float>(value) * (256.0F / 65535.0F);
            const std::size_t cell = std::min(static_cast<std::size_t>(at), std::size_t{255});
            const float fraction = at - static_cast<float>(cell);
            const float sigma =
                deviation[cell] + (deviation[cell + 1] - deviation[cell]) * fraction;
            const float grainy = static_cast<float>(value) + radius * sigma * normal_of(bits);
            value = static_cast<std::uint16_t>(std::clamp(grainy, 0.0F, 65535.0F) + 0.5F);
        }
    }
}

}  // namespace carom::pipeline
