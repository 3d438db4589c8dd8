// Light that reaches a point by way of a smooth ball, sought on purpose: a point of the light is
// chosen and the mirror point between solved for (manifold connections: Hanika, Droske and Fascione
// 2015, "Manifold next event estimation"; for spheres in closed form).
#pragma once

#include <optional>
#include <vector>

#include "render/integrator/transport_scene.h"

namespace carom::render {

/// A smooth ball: one that a coat covers, or of polished metal.
struct MirrorBall {
    float radius = 0;
    const Material* material = nullptr;
    std::uint32_t object = 0;
    Imath::Box3f centres;  // every place that its centre takes
};

/// All of them in the scene, in order of object.
[[nodiscard]] std::vector<MirrorBall> mirror_balls(const TransportScene& scene);

struct MirroredLight {
    V3f direction;       // unit, from the receiver to the mirror point
    float distance = 0;  // m
    std::uint32_t ball = kNoObject;
    V3f onward;       // unit, from the mirror point to the light
    V3f origin;       // of the second leg, off the ball
    float reach = 0;  // its length to the light, m
    /// Solid angle at the receiver per density of the choice, sr: the mean over choices of
    /// radiance times this is the integral of the mirrored radiance over directions. Of a light
    /// without a surface next to nothing, and the radiance so much the more.
    float solid_angle = 0;
    V3f radiance;  // that arrives if nothing is in the way of the two legs
};

/// Irradiance on the ball by which pairs of ball and light are chosen, about; 0 for a light whose
/// image in the ball is not sought: environments, objects that shine, lights too near.
[[nodiscard]] float mirrored_importance(const TransportScene& scene, const MirrorBall& ball,
                                        std::size_t light);

/// One choice, for `u` in [0, 1)^2. Empty if it does not arrive. `receiver` lies outside the ball;
/// the pair's importance is above 0.
[[nodiscard]] std::optional<MirroredLight> mirrored_light(const TransportScene& scene,
                                                          const MirrorBall& ball, std::size_t light,
                                                          const V3f& receiver, float time,
                                                          const V2f& u);

/// Whether anything stands in the way of either leg, the first of which starts at `origin`. Adds
/// the rays traced to `count`.
[[nodiscard]] bool is_blocked(const TransportScene& scene, const MirroredLight& mirrored,
                              const V3f& origin, float time, RenderStatistics& count);

}  // namespace carom::render
