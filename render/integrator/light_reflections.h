// Small lights as the camera sees them mirrored in smooth balls.
#pragma once

#include <cstdint>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/integrator/mirrored_light.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// Light that arrives at one place of the picture.
struct Splat {
    V2f place;          // pixels from the top left
    V3f flux{0, 0, 0};  // a pixel gets this times the density of its filter there
};

/// A path that finds the image of a bulb in a ball does so by chance, and the more so where lens or
/// shutter smear it over many pixels: sparkles. Here it is sought from the other end (Dutré,
/// Lafortune and Willems 1993, "Monte Carlo light tracing with direct computation of pixel
/// intensities"): point of the light, lens and time are chosen, the mirror point is solved for, and
/// the light lands wherever in the picture it is seen. Paths leave out what is so covered.
class LightReflections {
  public:
    /// Finds the pairs of ball and light whose image is small; that of a light without a surface is
    /// a point, which no path finds. Both are borrowed.
    LightReflections(const TransportScene& scene, const ThinLensCamera& camera);

    [[nodiscard]] std::size_t pair_count() const { return pairs_.size(); }

    /// Whether the image of `light` in the ball `object` is found here.
    [[nodiscard]] bool covers(std::uint32_t object, std::size_t light) const {
        const std::size_t at = object * light_count_ + light;
        return at < covered_.size() && covered_[at];
    }

    /// The image of one pair, for pictures with `samples` per pixel. A function of its arguments;
    /// adds to `count`.
    [[nodiscard]] std::vector<Splat> splats(std::size_t pair, double samples, std::uint64_t seed,
                                            RenderStatistics& count) const;

  private:
    struct Pair {
        MirrorBall ball;
        std::size_t light = 0;
        double size = 0;  // splats per sample of a pixel
    };
    struct Landing {
        V2f place;
        V3f flux;
        float area = 0;  // pixels that the light's image fills, judged by this choice alone
    };
    [[nodiscard]] std::optional<Landing> landing(const MirrorBall& ball, std::size_t light,
                                                 const CameraSample& sample,
                                                 RenderStatistics& count) const;
    void consider(const MirrorBall& ball, std::size_t light);

    TransportScene scene_;
    const ThinLensCamera& camera_;
    std::size_t light_count_ = 0;
    std::vector<Pair> pairs_;
    std::vector<bool> covered_;  // by object, then by light
};

}  // namespace carom::render
