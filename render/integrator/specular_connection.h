// Connections from a point to a light by a specular reflection on a sphere, or through a sphere of
// clear glass: a point of the light is sampled and the specular points between are solved for
// (manifold next event estimation: Hanika, Droske and Fascione 2015; for spheres in closed form, or
// in one dimension).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/geometry/refracted_paths.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// A sphere with a specular surface: coated smoothly, or of polished metal; or of clear glass.
struct SpecularSphere {
    float radius = 0;
    const Material* material = nullptr;
    std::uint32_t object = 0;
    Imath::Box3f centres;  // box around all positions of its centre
    bool refracts = false;
};

/// All specular spheres of the scene, in the order of their objects.
[[nodiscard]] std::vector<SpecularSphere> specular_spheres(const TransportScene& scene);
/// All spheres of clear glass, likewise.
[[nodiscard]] std::vector<SpecularSphere> clear_spheres(const TransportScene& scene);

struct SpecularConnection {
    V3f direction{0, 0, 1};  // unit, from the receiver to the specular point
    float distance = 0;      // m
    std::uint32_t sphere = kNoObject;
    V3f light_direction{0, 0, 1};  // unit, from the specular point to the light
    V3f origin{0, 0, 0};           // of the second leg, offset from the sphere's surface
    float light_distance = 0;      // length of the second leg, m
    /// Solid angle at the receiver over the density of the choice, sr: the mean over choices of
    /// radiance times this value is the integral of the reflected radiance over directions. For
    /// delta lights it is almost 0 and the radiance correspondingly large.
    float solid_angle = 0;
    V3f radiance{0, 0, 0};  // that arrives if neither leg is occluded
};

/// Estimate of the irradiance on the sphere, by which pairs of sphere and light are chosen. It is 0
/// if connections to the light are not sampled: environments, emissive objects, lights that are too
/// close, and lights that look large from a sphere of glass, as scattered rays find them well
/// there.
[[nodiscard]] float connection_importance(const TransportScene& scene, const SpecularSphere& sphere,
                                          std::size_t light);

/// Samples one connection, for `u` in [0, 1)^2. Empty if no light arrives. `receiver` lies outside
/// the sphere; the pair's importance is above 0.
[[nodiscard]] std::optional<SpecularConnection> connect(const TransportScene& scene,
                                                        const SpecularSphere& sphere,
                                                        std::size_t light, const V3f& receiver,
                                                        float time, const V2f& u);

/// All connections through a sphere of clear glass to one point of the light, likewise; the
/// reflections inside are left out. Their number is that of the paths
/// (render/geometry/refracted_paths.h).
struct RefractedConnections {
    int count = 0;
    struct One {
        SpecularConnection outside;  // its legs outside the sphere
        V3f entry{0, 0, 0};          // on the sphere
        V3f inside{0, 0, 1};         // unit, from there to where it leaves
        float inside_distance = 0;   // m
    };
    std::array<One, RefractedPaths::kMost> at;
};
[[nodiscard]] RefractedConnections connect_through(const TransportScene& scene,
                                                   const SpecularSphere& sphere, std::size_t light,
                                                   const V3f& receiver, float time, const V2f& u);
/// Likewise of all three legs.
[[nodiscard]] bool is_occluded(const TransportScene& scene,
                               const RefractedConnections::One& connection, const V3f& origin,
                               float time, RenderStatistics& count);

/// Occlusion test of both legs, the first of which starts at `origin`. Adds the rays traced to
/// `count`.
[[nodiscard]] bool is_occluded(const TransportScene& scene, const SpecularConnection& connection,
                               const V3f& origin, float time, RenderStatistics& count);

}  // namespace carom::render
