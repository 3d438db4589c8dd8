// What makes light of camera rays.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "render/film/film.h"
#include "render/geometry/ray.h"
#include "render/sampling/sampler.h"

namespace carom::render {

/// One camera sample.
struct RadianceSample {
    V3f radiance{0, 0, 0};
    float coverage = 0;   // 1 where the camera's ray met something
    V3f normal{0, 0, 0};  // what it met, world axes, towards the camera
    V3f albedo{0, 0, 0};
    std::uint32_t object = kNoObject;  // that it met, lights after objects
};

/// Where a sample belongs, for messages.
struct SampleIndex {
    int x = 0, y = 0, sample = 0;
};

/// A sample that is wanted.
struct CameraTask {
    Ray ray;
    SampleStream stream;
    SampleIndex index;
};

/// Immutable; shared by all threads.
class Integrator {
  public:
    virtual ~Integrator() = default;

    /// Room to work in, for one thread.
    class Workspace {
      public:
        virtual ~Workspace() = default;
    };
    /// Null: none is needed.
    [[nodiscard]] virtual std::unique_ptr<Workspace> make_workspace() const { return nullptr; }

    /// `sample` for each task, in whatever order suits: results do not depend on what else is asked
    /// for. `workspace`: of this integrator.
    virtual void samples(std::span<const CameraTask> tasks, float pixel_spread,
                         std::span<RadianceSample> results, Workspace* /*workspace*/,
                         RenderStatistics& count) const {
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            results[i] = sample(tasks[i].ray, pixel_spread, tasks[i].stream, tasks[i].index, count);
        }
    }

    /// The light that arrives against `camera_ray`; `pixel_spread`: width of a pixel at distance 1.
    /// All values are finite and >= 0. Adds to `count`.
    [[nodiscard]] virtual RadianceSample sample(const Ray& camera_ray, float pixel_spread,
                                                const SampleStream& stream,
                                                const SampleIndex& index,
                                                RenderStatistics& count) const = 0;

  protected:
    Integrator() = default;
    Integrator(const Integrator&) = default;
    Integrator& operator=(const Integrator&) = default;
};

}  // namespace carom::render
