#include "render/texture/noise.h"

#include <algorithm>
#include <cmath>

namespace carom::render {
namespace {

struct Cell {
    std::uint32_t index;
    float offset;  // [0, 1)
};

Cell cell_of(float x) {
    const float floor = std::floor(x);
    return {static_cast<std::uint32_t>(
                static_cast<std::int32_t>(std::clamp(floor, -1073741824.0f, 1073741824.0f))),
            x - floor};
}

float lerp(float a, float b, float t) {
    return a + (b - a) * t;
}

// The dot product of (x, y, z) with one of the twelve edge directions of a cube (four of them
// twice, so that four bits choose).
float gradient(std::uint32_t hash, float x, float y, float z) {
    const std::uint32_t h = hash >> 28;
    const float u = h < 8 ? x : y;
    const float v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
    return ((h & 1u) != 0 ? -u : u) + ((h & 2u) != 0 ? -v : v);
}

// Eight directions in the plane, of length sqrt(2) or 1.3 for evenness.
V2f gradient(std::uint32_t hash) {
    const std::uint32_t h = hash >> 29;
    const float sx = (h & 1u) != 0 ? -1.0f : 1.0f;
    const float sy = (h & 2u) != 0 ? -1.0f : 1.0f;
    if ((h & 4u) != 0) {
        return {sx, sy};
    }
    return (h & 1u) != 0 ? V2f(1.3f * sy, 0.0f) : V2f(0.0f, 1.3f * sy);
}

float gradient(std::uint32_t hash, float x, float y) {
    const V2f direction = gradient(hash);
    return direction.x * x + direction.y * y;
}

}  // namespace

float gradient_noise(const V3f& position, std::uint32_t seed) {
    const Cell x = cell_of(position.x);
    const Cell y = cell_of(position.y);
    const Cell z = cell_of(position.z);
    const float u = noise_fade(x.offset);
    const float v = noise_fade(y.offset);
    const float w = noise_fade(z.offset);
    float along_z[2];
    for (std::uint32_t k = 0; k < 2; ++k) {
        const std::uint32_t hz = mix_bits(z.index + k + seed);
        const float dz = z.offset - static_cast<float>(k);
        float along_y[2];
        for (std::uint32_t j = 0; j < 2; ++j) {
            const std::uint32_t hy = mix_bits(y.index + j + hz);
            const float dy = y.offset - static_cast<float>(j);
            const float a = gradient(mix_bits(x.index + hy), x.offset, dy, dz);
            const float b = gradient(mix_bits(x.index + 1 + hy), x.offset - 1.0f, dy, dz);
            along_y[j] = lerp(a, b, u);
        }
        along_z[k] = lerp(along_y[0], along_y[1], v);
    }
    return std::clamp(lerp(along_z[0], along_z[1], w), -1.0f, 1.0f);
}

namespace {

// `next` returns the following column or row; a repeating pattern closes there.
template <class NextColumn, class NextRow>
float plane_noise(const Cell& x, const Cell& y, std::uint32_t seed, const NextColumn& next_column,
                  const NextRow& next_row) {
    const float u = noise_fade(x.offset);
    float along_y[2];
    for (std::uint32_t j = 0; j < 2; ++j) {
        const std::uint32_t hy = mix_bits((j == 0 ? y.index : next_row(y.index)) + seed);
        const float dy = y.offset - static_cast<float>(j);
        const float a = gradient(mix_bits(x.index + hy), x.offset, dy);
        const float b = gradient(mix_bits(next_column(x.index) + hy), x.offset - 1.0f, dy);
        along_y[j] = lerp(a, b, u);
    }
    return std::clamp(lerp(along_y[0], along_y[1], noise_fade(y.offset)), -1.0f, 1.0f);
}

Cell wrapped_cell(float x, int period) {
    const Cell cell = cell_of(x);
    const int rest = static_cast<std::int32_t>(cell.index) % period;
    return {static_cast<std::uint32_t>(rest < 0 ? rest + period : rest), cell.offset};
}

}  // namespace

V2f lattice_gradient(std::uint32_t column, std::uint32_t row, std::uint32_t seed) {
    return gradient(mix_bits(column + mix_bits(row + seed)));
}

float gradient_noise(const V2f& position, std::uint32_t seed) {
    const auto next = [](std::uint32_t i) { return i + 1; };
    return plane_noise(cell_of(position.x), cell_of(position.y), seed, next, next);
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

namespace {

template <class Vector>
float sum_octaves(Vector position, int octaves, float footprint, std::uint32_t seed) {
    float sum = 0;
    float amplitude = 1;
    float period = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        const float weight = band_weight(footprint, period);
        if (weight <= 0) {
            break;
        }
        sum += weight * amplitude *
               gradient_noise(position, seed + static_cast<std::uint32_t>(octave) * 0x9e3779b9u);
        position *= 2.0f;
        amplitude *= 0.5f;
        period *= 0.5f;
    }
    return sum;
}

}  // namespace

float fractal_noise(const V3f& position, int octaves, float footprint, std::uint32_t seed) {
    return sum_octaves(position, octaves, footprint, seed);
}

float fractal_noise(const V2f& position, int octaves, float footprint, std::uint32_t seed) {
    return sum_octaves(position, octaves, footprint, seed);
}

float band_weight(float footprint, float period) {
    // 1 up to three footprints per period, 0 from one and a half on.
    const float t =
        std::clamp((period - 1.5f * footprint) / (1.5f * footprint + 1e-30f), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

float smooth_step(float x, float width) {
    const float t = std::clamp(x / width + 0.5f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

}  // namespace carom::render
