// Connections from a point to a light by a specular reflection on a ball: a point of the light is
// sampled and the specular point between is solved for (manifold next event estimation: Hanika,
// Droske and Fascione 2015; in closed form for spheres).
#pragma once

#include <optional>
#include <vector>

#include "render/integrator/transport_scene.h"

namespace carom::render {

/// A ball with a specular surface: coated smoothly, or of polished metal.
struct SpecularBall {
    float radius = 0;
    const Material* material = nullptr;
    std::uint32_t object = 0;
    Imath::Box3f centres;  // box around all positions of its centre
};

/// All specular balls of the scene, in the order of their objects.
[[nodiscard]] std::vector<SpecularBall> specular_balls(const TransportScene& scene);

struct SpecularConnection {
    V3f direction;       // unit, from the receiver to the specular point
    float distance = 0;  // m
    std::uint32_t ball = kNoObject;
    V3f light_direction;       // unit, from the specular point to the light
    V3f origin;                // of the second leg, offset from the ball's surface
    float light_distance = 0;  // length of the second leg, m
    /// Solid angle at the receiver over the density of the choice, sr: the mean over choices of
    /// radiance times this value is the integral of the reflected radiance over directions. For
    /// delta lights it is almost 0 and the radiance correspondingly large.
    float solid_angle = 0;
    V3f radiance;  // that arrives if neither leg is occluded
};

/// Estimate of the irradiance on the ball, by which pairs of ball and light are chosen. It is 0 if
/// connections to the light are not sampled: environments, emissive objects, lights that are too
/// close.
[[nodiscard]] float connection_importance(const TransportScene& scene, const SpecularBall& ball,
                                          std::size_t light);

/// Samples one connection, for `u` in [0, 1)^2. Empty if no light arrives. `receiver` lies outside
/// the ball; the pair's importance is above 0.
[[nodiscard]] std::optional<SpecularConnection> connect(const TransportScene& scene,
                                                        const SpecularBall& ball, std::size_t light,
                                                        const V3f& receiver, float time,
                                                        const V2f& u);

/// Occlusion test of both legs, the first of which starts at `origin`. Adds the rays traced to
/// `count`.
[[nodiscard]] bool is_occluded(const TransportScene& scene, const SpecularConnection& connection,
                               const V3f& origin, float time, RenderStatistics& count);

}  // namespace carom::render
