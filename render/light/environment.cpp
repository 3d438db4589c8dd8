#include "render/light/environment.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/light/scalar_kernels.h"
#include "render/light/shared_exponent.h"
#include "render/light/sky.h"

namespace carom::render {
namespace {

constexpr int kMostColumns = 256;
constexpr float kCellWeight[3] = {0.125f, 0.75f, 0.125f};

}  // namespace

Environment::Environment(const EnvironmentLight& light)
    : scale_(light.radiance), turns_(static_cast<float>(light.rotation) / kTurn) {
    mean_luminance_ = luminance(scale_);
    if (light.image.empty() && !light.sky) {
        return;
    }
    show(light.sky ? sky_picture(*light.sky) : read_linear_image(light.image, false));
}

Environment::Environment(const LinearImage& picture) : scale_(1) {
    show(picture);
}

void Environment::show(const LinearImage& picture) {
    pad(picture);
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
        const float sine = scalar::sin_cos<scalar::One>(kPi * latitude).sine;
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

V3f Environment::pixel(int x, int y) const {
    const std::uint32_t bits =
        padded_[static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(width_ + 2) +
                static_cast<std::size_t>(x + 1)];
    return scalar::shared_exponent_value<scalar::One>(bits);
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
            padded_.push_back(SharedExponent(colour / unit_).bits());
        }
    }
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

EnvironmentPicture Environment::picture() const {
    return {width_,         height_, List<std::uint32_t>(padded_),
            scale_ * unit_, turns_,  distribution_.tables()};
}

V3f Environment::radiance(const V3f& direction) const {
    if (!is_sampled()) {
        return scale_;
    }
    const EnvironmentPicture known = picture();
    return scalar::environment_radiance<scalar::One>(
        known, scalar::environment_uv<scalar::One>(known, direction));
}

float Environment::importance() const {
    // The estimate assumes that half of the cosine-weighted hemisphere sees the sky.
    return 0.5f * kPi * mean_luminance_;
}

}  // namespace carom::render
