// The interface of integrators, which estimate the light along camera rays.
#pragma once

#include <cstdint>
#include <memory>

#include "render/camera/camera_batch.h"
#include "render/film/film.h"
#include "render/geometry/ray.h"
#include "render/sampling/sampler.h"

namespace carom::render {

/// The result of one camera sample.
struct RadianceSample {
    V3f radiance{0, 0, 0};
    float coverage = 0;   // 1 if the camera ray hit something
    V3f normal{0, 0, 0};  // at the hit, world axes, towards the camera
    V3f albedo{0, 0, 0};
    float roughness = 0;  // of the surface below its coat: the root of GGX's alpha
    /// Albedo of what the first surface's coat shows, times what the coat reflects of it.
    V3f mirrored{0, 0, 0};
    /// Of the radiance: what the camera sees of lights and room, directly or in a smooth coat.
    V3f light{0, 0, 0};
    std::uint32_t object = kNoObject;  // that was hit; lights are numbered after the objects

    /// Light reaches the picture weakened by the lens; what is seen stays the same.
    void weigh(float weight) {
        radiance *= weight;
        light *= weight;
    }
};

/// Immutable; shared by all threads.
class Integrator {
  public:
    virtual ~Integrator() = default;

    /// Scratch memory for one thread.
    class Workspace {
      public:
        virtual ~Workspace() = default;
    };
    /// Returns null if the integrator needs none.
    [[nodiscard]] virtual std::unique_ptr<Workspace> make_workspace() const { return nullptr; }

    /// The radiance that arrives along the camera rays of a run. `pixel_spread`: width of a pixel
    /// at distance 1. A result does not depend on the other samples; all values are finite and >=
    /// 0, except by a fault of the integrator, which the caller looks for. `results` has room for
    /// as many; `workspace` comes from this integrator. Adds to `count`.
    virtual void samples(const CameraRun& run, float pixel_spread, RadianceSample* results,
                         Workspace* workspace, RenderStatistics& count) const = 0;

    /// What rays from the camera see: all of `samples` except the radiance, with the same means.
    /// Only of integrators that follow paths; the others set nothing. `workspace`: as of `samples`.
    virtual void trace_first_hits(const CameraRun& /*run*/, float /*pixel_spread*/,
                                  RadianceSample* /*results*/, Workspace* /*workspace*/) const {}

  protected:
    Integrator() = default;
    Integrator(const Integrator&) = default;
    Integrator& operator=(const Integrator&) = default;
};

}  // namespace carom::render
