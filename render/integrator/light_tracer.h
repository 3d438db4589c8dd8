// Light tracing of the reflections of small lights in smooth spheres, as the camera sees them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/integrator/specular_connection.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// Light that lands at one position of the picture.
struct Splat {
    V2f position;       // pixels from the top left
    V3f flux{0, 0, 0};  // a pixel gets this times the density of its filter there
    int quarter = 0;    // of the image's samples, to which it belongs
};

/// Camera paths find the reflection of a small bulb in a sphere only by chance, and less often
/// where depth of field or motion blur spreads it over many pixels: that causes fireflies. Here a
/// point of the light, a point of the lens and a time are chosen, the specular point is solved for,
/// and the light lands wherever the picture shows it (Dutré, Lafortune and Willems 1993, "Monte
/// Carlo light tracing with direct computation of pixel intensities"). Camera paths leave out what
/// is covered here.
class LightTracer {
  public:
    /// Finds the pairs of sphere and light whose image is small. The image of a delta light is a
    /// point, which no camera path finds. Both arguments are borrowed.
    LightTracer(const TransportScene& scene, const ThinLensCamera& camera);

    [[nodiscard]] std::size_t pair_count() const { return pairs_.size(); }

    /// Whether the image of `light` in the sphere `object` is rendered here.
    [[nodiscard]] bool covers(std::uint32_t object, std::size_t light) const {
        const std::size_t at = object * light_count_ + light;
        return at < covered_.size() && covered_[at];
    }

    /// The image of one pair, for pictures with `samples` per pixel. The result depends only on the
    /// arguments; adds to `count`.
    [[nodiscard]] std::vector<Splat> splats(std::size_t pair, double samples, std::uint64_t seed,
                                            RenderStatistics& count) const;

  private:
    struct Pair {
        SpecularSphere sphere;
        std::size_t light = 0;
        double size = 0;  // splats per sample of a pixel
    };
    struct SplatSample {
        V2f position;
        V3f flux;
        float area = 0;  // pixels that the light's image fills, estimated from this choice alone
    };
    [[nodiscard]] std::optional<SplatSample> sample_splat(const SpecularSphere& sphere,
                                                          std::size_t light,
                                                          const CameraSample& sample,
                                                          RenderStatistics& count) const;
    void add_if_small(const SpecularSphere& sphere, std::size_t light);

    TransportScene scene_;
    const ThinLensCamera& camera_;
    std::size_t light_count_ = 0;
    std::vector<Pair> pairs_;
    std::vector<bool> covered_;  // by object, then by light
};

}  // namespace carom::render
