// The classic surface as light scattering that keeps energy, for path tracing.
#pragma once

#include <optional>

#include "render/geometry/ray.h"
#include "render/material/phong.h"

namespace carom::render {

/// Where and how strongly each term of a phong surface scatters towards one viewer. Directions are
/// in the surface's axes, z > 0 on the viewer's side.
///   diffuse:    k_d / pi times the cosine
///   highlight:  k_s (n + 2) / (2 pi) cos^(n + 1) a / h,
/// a being the angle to the mirrored direction and h the share of the lobe that lies above the
/// surface. Seen straight on, this is the modified Phong lobe of Lafortune and Willems (1994,
/// "Using the modified Phong reflectance model for physically based rendering", eq. 5). That one
/// sends back k_s times about the cosine of the viewing angle, which is darker than the classic
/// model towards the edges of a ball; this one sends back k_s at every angle and is not reciprocal.
/// What is mirrored or seen through is one direction, or with a spread of standard deviation s a
/// lobe cos^n around it with n = 2 / s^2, which has the same mean square of the angle and is
/// divided by its own h: so it holds its share at every angle, too. At total reflection k_t is
/// mirrored, with the spread that it passes with: what is frosted lets all light out in the end.
/// The four shares are scaled down together where their sum is above 1 in a channel.
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
    [[nodiscard]] bool transmits() const { return through_.probability > 0 && through_.axis.z < 0; }

  private:
    struct Lobe {
        V3f share{0, 0, 0};
        V3f axis{0, 0, 1};
        float exponent = -1;  // -1: the axis alone
        float kept = 1;       // share of the lobe on the axis' side of the surface
        float probability = 0;

        Lobe() = default;
        Lobe(const V3f& the_share, const V3f& the_axis, const CosineLobe& shape);
        [[nodiscard]] bool is_delta() const { return exponent < 0; }
        /// Whether a direction is on the side of the surface that the lobe scatters to.
        [[nodiscard]] bool has_on_its_side(const V3f& wi) const {
            return (wi.z > 0) == (axis.z > 0);
        }
        /// cos^n over its integral over the sphere's half around the axis.
        [[nodiscard]] float density(const V3f& wi) const;
        /// Density of `sampled`, for directions on the lobe's side.
        [[nodiscard]] float pdf(const V3f& wi) const;
        /// What would pass to the wrong side is turned to the opposite azimuth around the axis.
        [[nodiscard]] V3f sampled(const V2f& u) const;
    };

    V3f diffuse_{0, 0, 0};
    float diffuse_probability_ = 0;
    Lobe highlight_, mirrored_, through_;
};

}  // namespace carom::render
