#include "render/texture/noise.h"

#include "render/texture/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;
using Cell = scalar::NoiseCellOf<One>;

// Eight directions in the plane, of length sqrt(2) or 1.3 for evenness.
V2f plane_gradient(std::uint32_t hash) {
    const std::uint32_t h = hash >> 29;
    const float sx = (h & 1u) != 0 ? -1.0f : 1.0f;
    const float sy = (h & 2u) != 0 ? -1.0f : 1.0f;
    if ((h & 4u) != 0) {
        return {sx, sy};
    }
    return (h & 1u) != 0 ? V2f(1.3f * sy, 0.0f) : V2f(0.0f, 1.3f * sy);
}

float plane_gradient(std::uint32_t hash, float x, float y) {
    const V2f direction = plane_gradient(hash);
    return direction.x * x + direction.y * y;
}

// `next` returns the following column or row; a repeating pattern closes there.
template <class NextColumn, class NextRow>
float plane_noise(const Cell& x, const Cell& y, std::uint32_t seed, const NextColumn& next_column,
                  const NextRow& next_row) {
    const float u = scalar::noise_fade<One>(x.offset);
    float along_y[2];
    for (std::uint32_t j = 0; j < 2; ++j) {
        const std::uint32_t hy =
            scalar::mix_bits<One>((j == 0 ? y.index : next_row(y.index)) + seed);
        const float dy = y.offset - static_cast<float>(j);
        const float a = plane_gradient(scalar::mix_bits<One>(x.index + hy), x.offset, dy);
        const float b =
            plane_gradient(scalar::mix_bits<One>(next_column(x.index) + hy), x.offset - 1.0f, dy);
        along_y[j] = scalar::between<One>(a, b, u);
    }
    return scalar::limited<One>(
        scalar::between<One>(along_y[0], along_y[1], scalar::noise_fade<One>(y.offset)), -1, 1);
}

Cell wrapped_cell(float x, int period) {
    const Cell cell = scalar::noise_cell<One>(x);
    const int rest = static_cast<std::int32_t>(cell.index) % period;
    return {static_cast<std::uint32_t>(rest < 0 ? rest + period : rest), cell.offset};
}

}  // namespace

std::uint32_t mix_bits(std::uint32_t x) {
    return scalar::mix_bits<One>(x);
}

float unit_float(std::uint32_t bits) {
    return scalar::unit_float<One>(bits);
}

float gradient_noise(const V3f& position, std::uint32_t seed) {
    return scalar::gradient_noise<One>(scalar::three(position), seed);
}

V2f lattice_gradient(std::uint32_t column, std::uint32_t row, std::uint32_t seed) {
    return plane_gradient(mix_bits(column + mix_bits(row + seed)));
}

float noise_fade(float t) {
    return scalar::noise_fade<One>(t);
}

float gradient_noise(const V2f& position, std::uint32_t seed) {
    const auto next = [](std::uint32_t i) { return i + 1; };
    return plane_noise(scalar::noise_cell<One>(position.x), scalar::noise_cell<One>(position.y),
                       seed, next, next);
}

float periodic_noise(const V2f& position, int period_x, int period_y, std::uint32_t seed) {
    const auto next_of = [](int period) {
        return [period](std::uint32_t i) {
            return i + 1 == static_cast<std::uint32_t>(period) ? 0 : i + 1;
        };
    };
    return plane_noise(wrapped_cell(position.x, period_x), wrapped_cell(position.y, period_y), seed,
                       next_of(period_x), next_of(period_y));
}

float fractal_noise(const V3f& position, int octaves, float footprint, std::uint32_t seed) {
    return scalar::fractal_noise<One>(scalar::three(position), octaves, footprint, seed);
}

float fractal_noise(const V2f& position, int octaves, float footprint, std::uint32_t seed) {
    return scalar::sum_octaves<One>(
        position, octaves, footprint, seed,
        [](const V2f& at, std::uint32_t salt) { return gradient_noise(at, salt); });
}

float band_weight(float footprint, float period) {
    return scalar::band_weight<One>(footprint, period);
}

float smooth_step(float x, float width) {
    return scalar::smooth_step<One>(x, width);
}

}  // namespace carom::render
