#include "lab/comparison/frame_meter.h"

#include "core/cpu_time.h"
#include "render/frame/frame.h"

namespace carom::pipeline {

using render::AccelerationKind;

bool FrameMeter::can_count(AccelerationKind kind) {
    return kind != AccelerationKind::hybrid && kind != AccelerationKind::embree;
}

ComparedStructure FrameMeter::measure(render::RenderSettings settings, AccelerationKind kind,
                                      bool counts, const render::StructureOptions& options,
                                      const WorkContext& context) {
    ComparedStructure result;
    result.name = name_of(kind);
    result.shadow_rays = options.shadow_rays_stop ? ShadowRays::any : ShadowRays::closest;
    result.is_counted = counts;
    arena_.execute([&] {
        if (!structure_ || structure_->kind() != kind) {
            prepared_.reset();
            structure_.emplace(kind);
            prepared_.emplace(scene_.scene, settings, structure_->maker());
        }
        structure_->set(counts, options);
        const double start = process_cpu_seconds();
        (void)render::render_frame(*prepared_, scene_.tracks, scene_.frame, settings, context);
        result.cpu_seconds = process_cpu_seconds() - start - structure_->build_seconds();
    });
    result.build_seconds = structure_->build_seconds();
    result.bytes = structure_->bytes();
    result.tests = structure_->take_counts();
    return result;
}

}  // namespace carom::pipeline
