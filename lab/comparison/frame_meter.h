// Measures the cost of one frame with one structure.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "lab/comparison/comparison.h"
#include "lab/structures/structure_meter.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {

class FrameMeter {
  public:
    /// Refers to the scene. `threads`: 0 for one per processor.
    FrameMeter(const LaboratoryScene& scene, int threads) : scene_(scene), arena_(threads) {}

    /// Whether the tests of this structure can be counted.
    [[nodiscard]] static bool can_count(render::AccelerationKind kind);

    /// `settings`: those of the scene, or of a part of its picture; `counts`: whether tests are
    /// counted, which takes time. Throws Error, Stopped.
    [[nodiscard]] ComparedStructure measure(render::RenderSettings settings,
                                            render::AccelerationKind kind, bool counts,
                                            const render::StructureOptions& options,
                                            const WorkContext& context);

  private:
    const LaboratoryScene& scene_;
    render::ThreadArena arena_;
    // Of the last measurement: what frames share is reused for parts of a picture.
    std::optional<render::StructureMeter> structure_;
    std::optional<render::PreparedScene> prepared_;
};

}  // namespace carom::pipeline
