// An energy-conserving BSDF for phong surfaces, for path tracing.
#pragma once

#include <optional>

#include "render/geometry/ray.h"
#include "render/material/phong.h"

namespace carom::render {

/// The lobes of a phong surface for one viewing direction. Directions are in the surface's axes, z
/// > 0 on the viewer's side.
///   diffuse:    k_d / pi times the cosine
///   highlight:  k_s (n + 2) / (2 pi) cos^(n + 1) a / h,
/// where a is the angle to the mirror direction and h the fraction of the lobe above the surface.
/// At normal incidence this is the modified Phong lobe of Lafortune and Willems (1994, "Using the
/// modified Phong reflectance model for physically based rendering", eq. 5). Their lobe reflects
/// about k_s times the cosine of the viewing angle, which is darker than the classic model towards
/// the edges of a ball; this one reflects k_s at every angle and is not reciprocal. Reflection and
/// transmission are single directions, or with a spread of standard deviation s a lobe cos^n around
/// them with n = 2 / s^2, which has the same mean square of the angle and is divided by its own h,
/// so that its albedo is the same at every angle, too. At total reflection k_t is reflected, with
/// the spread of the transmission: otherwise frosted glass would trap light. The four albedos are
/// scaled down together if their sum exceeds 1 in a channel.
class PhongLobes {
  public:
    /// `from_behind`: the viewer is on the inside, which has the model's index of refraction.
    PhongLobes(const PhongModel& model, const V3f& base, bool from_behind, const V3f& wo);

    struct Value {
        V3f value{0, 0, 0};  // times the cosine, 1/sr; without single directions
        float pdf = 0;       // of `sample`, 1/sr
    };
    [[nodiscard]] Value evaluate(const V3f& wi) const;

    struct Sample {
        V3f direction;
        V3f weight;  // of a single direction: its albedo over its probability
        bool is_delta = false;
    };
    /// Empty: absorbed. If not is_delta, the weight is that of `evaluate`, whose pdf is above 0.
    [[nodiscard]] std::optional<Sample> sample(const V2f& u) const;

    /// Whether `evaluate` is not 0 everywhere.
    [[nodiscard]] bool can_evaluate() const;
    /// Whether all lobes except single directions are wide.
    [[nodiscard]] bool is_broad() const;
    [[nodiscard]] bool transmits() const { return through_.probability > 0 && through_.axis.z < 0; }

  private:
    struct Lobe {
        V3f albedo{0, 0, 0};
        V3f axis{0, 0, 1};
        float exponent = -1;  // -1: a single direction
        float kept = 1;       // fraction of the lobe on the axis' side of the surface
        float probability = 0;

        Lobe() = default;
        Lobe(const V3f& the_albedo, const V3f& the_axis, const CosineLobe& shape);
        [[nodiscard]] bool is_delta() const { return exponent < 0; }
        /// Whether a direction is on the side of the surface towards which the lobe scatters.
        [[nodiscard]] bool has_on_its_side(const V3f& wi) const {
            return (wi.z > 0) == (axis.z > 0);
        }
        /// cos^n over its integral over the hemisphere around the axis.
        [[nodiscard]] float density(const V3f& wi) const;
        /// Density of `sampled`, for directions on the lobe's side.
        [[nodiscard]] float pdf(const V3f& wi) const;
        /// A direction that would be on the wrong side is turned to the opposite azimuth around the
        /// axis.
        [[nodiscard]] V3f sampled(const V2f& u) const;
    };

    V3f diffuse_{0, 0, 0};
    float diffuse_probability_ = 0;
    Lobe highlight_, mirrored_, through_;
};

}  // namespace carom::render
