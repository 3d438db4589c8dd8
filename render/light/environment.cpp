#include "render/light/environment.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/elementary_float.h"
#include "render/geometry/trigonometry.h"
#include "render/light/sky.h"
#include "render/sampling/warp.h"

namespace carom::render {
namespace {

constexpr float kTurn = 2.0f * kPi;
constexpr int kMostColumns = 256;
constexpr float kCellWeight[3] = {0.125f, 0.75f, 0.125f};

}  // namespace

Environment::Environment(const EnvironmentLight& light)
    : scale_(light.radiance), turns_(static_cast<float>(light.rotation) / kTurn) {
    mean_luminance_ = luminance(scale_);
    if (light.image.empty() && !light.sky) {
        return;
    }
    pad(light.sky ? sky_picture(*light.sky) : read_linear_image(light.image, false));
    // A table of at most 256 columns stays in the processor's cache; a finer table costs more time
    // than its better fit saves.
    const int block = (width_ + kMostColumns - 1) / kMostColumns;
    const int columns = (width_ + block - 1) / block;
    const int rows = (height_ + block - 1) / block;
    std::vector<float> weights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    double sum = 0;
    double area = 0;
    for (int y = 0; y < height_; ++y) {
        const float latitude = (static_cast<float>(y) + 0.5f) / static_cast<float>(height_);
        const float sine = sin_cos(kPi * latitude).sine;
        for (int x = 0; x < width_; ++x) {
            const float weight = cell_brightness(x, y) * sine;
            // The cell of the table that contains the pixel's centre.
            const int column = (2 * x + 1) * columns / (2 * width_);
            const int row = (2 * y + 1) * rows / (2 * height_);
            weights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)] += weight;
            sum += weight;
            area += sine;
        }
    }
    distribution_ = Distribution2D(weights, columns, rows);
    mean_luminance_ = static_cast<float>(sum / area) * luminance(scale_);
}

// (u, v) in the picture, v = 0 at the top. The middle column is the direction +x; columns to its
// right turn towards -y, as seen from the middle of the scene.
V2f Environment::picture_from_direction(const V3f& direction) const {
    const float u = 0.5f + turns_ - angle_of(direction.x, direction.y) / kTurn;
    return {u - std::floor(u), arccosine(std::clamp(direction.z, -1.0f, 1.0f)) / kPi};
}

V3f Environment::pixel(int x, int y) const {
    return padded_[static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(width_ + 2) +
                   static_cast<std::size_t>(x + 1)]
        .value();
}

void Environment::pad(const LinearImage& image) {
    width_ = image.width;
    height_ = image.height;
    float largest = 0;
    for (const V3f& c : image.pixels) {
        largest = std::max({largest, c.x, c.y, c.z});
    }
    while (largest > unit_ * SharedExponent::kLargest) {
        unit_ *= 2;
    }
    padded_.reserve(static_cast<std::size_t>(width_ + 2) * static_cast<std::size_t>(height_ + 2));
    for (int y = -1; y <= height_; ++y) {
        for (int x = -1; x <= width_; ++x) {
            const int column = (x + width_) % width_;
            const int row = std::clamp(y, 0, height_ - 1);
            const V3f& colour =
                image.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                             static_cast<std::size_t>(column)];
            padded_.emplace_back(colour / unit_);
        }
    }
}

V3f Environment::picture_radiance(const V2f& uv) const {
    const float x = uv.x * static_cast<float>(width_) - 0.5f;
    const float y = uv.y * static_cast<float>(height_) - 0.5f;
    // uv may be 1 for a direction straight down or by rounding at the seam.
    const int x0 = std::min(static_cast<int>(std::floor(x)), width_ - 1);
    const int y0 = std::min(static_cast<int>(std::floor(y)), height_ - 1);
    const float fx = x - static_cast<float>(x0);
    const float fy = y - static_cast<float>(y0);
    const V3f top = pixel(x0, y0) * (1.0f - fx) + pixel(x0 + 1, y0) * fx;
    const V3f bottom = pixel(x0, y0 + 1) * (1.0f - fx) + pixel(x0 + 1, y0 + 1) * fx;
    return (top * (1.0f - fy) + bottom * fy) * (scale_ * unit_);
}

// Mean of the bilinear picture over one pixel's square: weights (1, 6, 1) / 8 in both directions.
// It is positive wherever the interpolated picture is.
float Environment::cell_brightness(int x, int y) const {
    float sum = 0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            sum += kCellWeight[i + 1] * kCellWeight[j + 1] * luminance(pixel(x + i, y + j)) * unit_;
        }
    }
    return sum;
}

V3f Environment::radiance(const V3f& direction) const {
    return is_sampled() ? picture_radiance(picture_from_direction(direction)) : scale_;
}

std::optional<LightSample> Environment::sample(const V2f& u) const {
    const Distribution2D::Sample place = distribution_.sample(u);
    const SinCos polar = sin_cos_turn(0.5f * place.uv.y);
    if (place.pdf <= 0 || polar.sine <= 0) {
        return std::nullopt;
    }
    const SinCos azimuth = sin_cos_turn(0.5f + turns_ - place.uv.x);
    return LightSample{
        V3f(polar.sine * azimuth.cosine, polar.sine * azimuth.sine, polar.cosine).normalized(),
        kInfinity, place.pdf / (kTurn * kPi * polar.sine), place.uv};
}

float Environment::pdf(const V3f& direction) const {
    return is_sampled() ? pdf_at(direction, picture_from_direction(direction)) : 0;
}

float Environment::pdf_at(const V3f& direction, const V2f& uv) const {
    const float sine = std::sqrt(direction.x * direction.x + direction.y * direction.y);
    return sine > 0 ? distribution_.pdf(uv) / (kTurn * kPi * sine) : 0;
}

Environment::Value Environment::evaluate(const V3f& direction) const {
    if (!is_sampled()) {
        return {scale_, 0};
    }
    const V2f uv = picture_from_direction(direction);
    return {picture_radiance(uv), pdf_at(direction, uv)};
}

float Environment::importance() const {
    // The estimate assumes that half of the cosine-weighted hemisphere sees the sky.
    return 0.5f * kPi * mean_luminance_;
}

}  // namespace carom::render
