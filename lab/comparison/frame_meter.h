// What one picture with one structure takes.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "lab/comparison/comparison.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {

struct MeasuredFrame {
    render::StructureCost cost;
    double cpu_seconds = 0;  // of the frame, all threads; building left out
};

class FrameMeter {
  public:
    /// Refers to the scene. `threads`: 0 for as many as there are processors.
    FrameMeter(const LaboratoryScene& scene, int threads) : scene_(scene), arena_(threads) {}

    /// Whether the tests of such a structure can be counted.
    [[nodiscard]] static bool can_count(render::AccelerationKind kind);

    /// `settings`: the scene's, or those of a part. Throws Error, Stopped.
    [[nodiscard]] MeasuredFrame measure(render::RenderSettings settings,
                                        render::AccelerationKind kind,
                                        const render::StructureOptions& options,
                                        const WorkContext& context);

  private:
    const LaboratoryScene& scene_;
    render::ThreadArena arena_;
    // The last structure's: what it shares with all pictures is the same for parts of one.
    std::optional<render::AccelerationKind> prepared_for_;
    std::optional<render::PreparedScene> prepared_;
};

}  // namespace carom::pipeline
