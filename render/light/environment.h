// Environment (infinite) light.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/geometry/ray.h"
#include "render/light/area_light.h"
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

    [[nodiscard]] V3f radiance(const V3f& direction) const;

    /// Whether sampling it is better than waiting for scattered rays to leave the scene. It is not
    /// for a constant environment, which cosine-distributed directions sample perfectly.
    [[nodiscard]] bool is_sampled() const { return !padded_.empty(); }

    /// Samples in proportion to brightness and solid angle. Requires `is_sampled`.
    [[nodiscard]] std::optional<LightSample> sample(const V2f& u) const;

    /// Radiance along a sampled direction.
    [[nodiscard]] V3f radiance(const LightSample& sample) const {
        return picture_radiance(sample.place);
    }

    /// The environment in one direction.
    struct Value {
        V3f radiance;
        float pdf = 0;  // of `sample`, 1/sr
    };
    /// Computes `radiance` and `pdf` together.
    [[nodiscard]] Value evaluate(const V3f& direction) const;

    /// Density of `sample`, 1/sr; 0 if not `is_sampled`.
    [[nodiscard]] float pdf(const V3f& direction) const;

    /// Estimate of the irradiance that it gives, in the unit of the area lights' importance.
    [[nodiscard]] float importance() const;

    /// The picture for kernels, if `is_sampled`; valid as long as this object is. Without any light
    /// in it, its distribution has no density.
    [[nodiscard]] EnvironmentPicture picture() const;

  private:
    [[nodiscard]] V3f picture_radiance(const V2f& uv) const;
    /// x in [-1, width], y in [-1, height]: the border repeats the pixels beyond it.
    [[nodiscard]] V3f pixel(int x, int y) const;
    void pad(const LinearImage& image);
    [[nodiscard]] float cell_brightness(int x, int y) const;

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
