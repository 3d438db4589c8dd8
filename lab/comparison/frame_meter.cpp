#include "lab/comparison/frame_meter.h"

#include "core/cpu_time.h"
#include "lab/structures/make_structure.h"
#include "render/acceleration/structure_cost.h"
#include "render/frame/frame.h"

namespace carom::pipeline {

using render::AccelerationKind;

bool FrameMeter::can_count(AccelerationKind kind) {
    return kind != AccelerationKind::hybrid && kind != AccelerationKind::embree;
}

MeasuredFrame FrameMeter::measure(render::RenderSettings settings, AccelerationKind kind,
                                  const render::StructureOptions& options,
                                  const WorkContext& context) {
    settings.acceleration = kind;
    render::StructureProbe probe{options, {}};
    MeasuredFrame result;
    arena_.execute([&] {
        if (prepared_for_ != kind) {
            prepared_for_.reset();
            prepared_.emplace(scene_.scene, settings, render::make_structure);
            prepared_for_ = kind;
        }
        const double start = process_cpu_seconds();
        (void)render::render_frame(*prepared_, scene_.tracks, scene_.frame, settings, context,
                                   nullptr, &probe);
        result.cpu_seconds = process_cpu_seconds() - start - probe.cost.frame_build_seconds;
    });
    result.cost = probe.cost;
    return result;
}

}  // namespace carom::pipeline
