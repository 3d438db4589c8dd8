// Environment (infinite) light.
#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/ray.h"
#include "render/light/environment_picture.h"
#include "render/sampling/distribution_2d.h"
#include "render/scene/scene_description.h"
#include "render/texture/image.h"

namespace carom::render {

/// A constant radiance, or an equirectangular picture (from a file or a sky model) with bilinear
/// interpolation. Immutable.
class Environment {
  public:
    /// An environment without light.
    Environment() = default;

    /// Throws Error if the picture cannot be read.
    explicit Environment(const EnvironmentLight& light);

    /// An equirectangular picture of radiance.
    explicit Environment(const LinearImage& picture);

    [[nodiscard]] V3f radiance(const V3f& direction) const;

    /// Whether sampling it is better than waiting for scattered rays to leave the scene. It is not
    /// for a constant environment, which cosine-distributed directions sample perfectly.
    [[nodiscard]] bool is_sampled() const { return !padded_.empty(); }

    /// Estimate of the irradiance that it gives, in the unit of the area lights' importance.
    [[nodiscard]] float importance() const;

    /// The picture for kernels, if `is_sampled`; valid as long as this object is. Without any light
    /// in it, its distribution has no density.
    [[nodiscard]] EnvironmentPicture picture() const;

  private:
    /// x in [-1, width], y in [-1, height]: the border repeats the pixels beyond it.
    [[nodiscard]] V3f pixel(int x, int y) const;
    void pad(const LinearImage& image);
    [[nodiscard]] float cell_brightness(int x, int y) const;
    void show(const LinearImage& picture);

    V3f scale_{0, 0, 0};
    int width_ = 0;  // of the picture, pixels
    int height_ = 0;
    std::vector<std::uint32_t>
        padded_;      // SharedExponent, with a border of one pixel; empty: constant
    float unit_ = 1;  // the unit of `padded_`
    Distribution2D distribution_;
    float turns_ = 0;  // rotation about z
    float mean_luminance_ = 0;
};

}  // namespace carom::render
