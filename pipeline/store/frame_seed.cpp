#include "pipeline/store/frame_seed.h"

#include "core/field_hasher.h"
#include "render/camera/camera_fields.h"

namespace carom::pipeline {

std::uint64_t frame_seed(std::uint64_t render_seed, const render::FrameInput& frame) {
    FieldHasher hasher;
    hasher.add("carom frame seed, format 1");
    hasher.add(render_seed).add(frame.scene_open).add(frame.scene_close);
    hasher.add_value(frame.camera_open).add_value(frame.camera_close);
    return hasher.finish().low;
}

}  // namespace carom::pipeline
