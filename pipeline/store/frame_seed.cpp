#include "pipeline/store/frame_seed.h"

#include "pipeline/store/camera_hash.h"

namespace carom::pipeline {

std::uint64_t frame_seed(std::uint64_t render_seed, const render::FrameInput& frame) {
    Hasher hasher;
    hasher.add("carom frame seed, format 1");
    hasher.add(render_seed);
    hasher.add(frame.scene_open).add(frame.scene_close);
    add_camera(hasher, frame.camera_open);
    add_camera(hasher, frame.camera_close);
    return hasher.finish().low;
}

}  // namespace carom::pipeline
