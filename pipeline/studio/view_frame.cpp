#include "pipeline/studio/view_frame.h"

namespace carom::studio {
namespace {

Vec3 vector_of(const Triple& t) {
    return {t[0], t[1], t[2]};
}

}  // namespace

pipeline::PlannedFrame frame_of(const FreeView& view) {
    pipeline::PlannedFrame frame;
    frame.scene_time = frame.scene_open = frame.scene_close = view.scene_time;
    frame.camera_open.position = vector_of(view.position);
    frame.camera_open.target = vector_of(view.target);
    frame.camera_open.up = vector_of(view.up);
    frame.camera_open.vertical_fov = view.fov;
    frame.camera_open.focus_distance = view.focus;
    frame.camera_open.lens_radius = view.lens_radius;
    frame.camera_close = frame.camera_open;
    return frame;
}

}  // namespace carom::studio
