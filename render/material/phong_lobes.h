// The classic surface as light scattering that keeps energy, for path tracing.
#pragma once

#include <optional>

#include "render/geometry/ray.h"
#include "render/material/phong.h"

namespace carom::render {

/// Where and how strongly each term of a phong surface scatters towards one viewer. Directions are
/// in the surface's axes, z > 0 on the viewer's side.
///   diffuse:        k_d / pi
///   highlight:      k_s (n + 2) / (2 pi) cos^n a   (Lafortune and Willems 1994, "Using the
///   modified
///                   Phong reflectance model for physically based rendering", eq. 5),
/// a being the angle to the mirrored direction. What is mirrored or seen through is one direction,
/// or with a spread of standard deviation s a lobe cos^n around it with n = 2 / s^2, which has the
/// same mean square of the angle; it holds its share whatever the angle of view, as the classic
/// model does, but for what falls on the wrong side of the surface. At total reflection k_t joins
/// k_r. The four shares are scaled down together where their sum is above 1 in a channel.
class PhongLobes {
  public:
    /// `from_behind`: the viewer is on the inside, whose index of refraction the model gives.
    PhongLobes(const PhongModel& model, const V3f& base, bool from_behind, const V3f& wo);

    struct Value {
        V3f value{0, 0, 0};  // times the cosine, 1/sr; single directions not counted
        float pdf = 0;       // of `sample`, 1/sr
    };
    [[nodiscard]] Value evaluate(const V3f& wi) const;

    struct Sample {
        V3f direction;
        V3f weight;  // of a single direction: its share over its probability
        bool is_delta = false;
    };
    /// Empty: absorbed. Without is_delta the weight is left to `evaluate`, whose pdf is above 0.
    [[nodiscard]] std::optional<Sample> sample(const V2f& u) const;

    /// Whether `evaluate` is not 0 everywhere.
    [[nodiscard]] bool can_evaluate() const;
    /// Whether all lobes but single directions are wide.
    [[nodiscard]] bool is_broad() const;
    [[nodiscard]] bool transmits() const { return through_.probability > 0; }

  private:
    struct Lobe {
        V3f share{0, 0, 0};
        V3f axis{0, 0, 1};
        float exponent = -1;  // -1: the axis alone
        float probability = 0;

        [[nodiscard]] bool is_delta() const { return exponent < 0; }
        /// cos^n over its integral over the sphere's half around the axis.
        [[nodiscard]] float density(const V3f& wi) const;
        [[nodiscard]] V3f sampled(const V2f& u) const;
    };

    V3f diffuse_{0, 0, 0};
    float diffuse_probability_ = 0;
    Lobe highlight_, mirrored_, through_;
};

}  // namespace carom::render
