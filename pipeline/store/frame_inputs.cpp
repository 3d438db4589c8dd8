#include "pipeline/store/frame_inputs.h"

#include <algorithm>

#include "core/error.h"
#include "pipeline/store/frame_seed.h"

namespace carom::pipeline {
namespace {

bool is_still(const sim::PathSegment& segment) {
    const Vec3 zero(0, 0, 0);
    return segment.p0 == segment.p1 && segment.v0 == zero && segment.v1 == zero;
}

bool is_at_rest(const MotionState& state, const Quat& orientation) {
    return state.angular_velocity == Vec3(0, 0, 0) && state.orientation == orientation;
}

// The angular velocity is linear between keys, so it is zero throughout if it is zero at both ends.
bool rests_during(const sim::Track& track, double open, double close) {
    const Quat orientation = track.sample(open).orientation;
    const std::vector<sim::PathSegment> segments = track.segments(open, close);
    for (const sim::PathSegment& segment : segments) {
        const bool has_jumped = segment.p0 != segments.front().p0;
        if (has_jumped || !is_still(segment) ||
            !is_at_rest(track.sample(segment.start), orientation) ||
            !is_at_rest(track.sample((segment.start + segment.end) / 2), orientation) ||
            !is_at_rest(track.sample(segment.end), orientation)) {
            return false;
        }
    }
    return true;
}

/// A track whose only key is the pose at that time.
sim::Track freeze_at(const sim::Track& track, double scene_time) {
    const MotionState state = track.sample(scene_time);
    sim::Key key;
    key.position = state.position;
    key.orientation = state.orientation;
    return sim::Track(track.name(), {key});
}

}  // namespace

FrameInputs frame_inputs(const PlannedFrame& frame, const Shutter& shutter,
                         const render::SceneDescription& scene, const sim::Timeline& timeline,
                         std::uint64_t render_seed) {
    FrameInputs inputs;
    bool moves = false;
    for (const render::ObjectDescription& object : scene.objects) {
        const auto is_same = [&](const sim::Track& track) { return track.name() == object.track; };
        if (object.track.empty() || std::ranges::any_of(inputs.tracks, is_same)) {
            continue;
        }
        const sim::Track* track = timeline.find(object.track);
        if (track == nullptr) {
            throw Error("object '" + object.name + "' follows the track '" + object.track +
                        "', which the timeline does not have");
        }
        if (frame.scene_open == frame.scene_close ||
            rests_during(*track, frame.scene_open, frame.scene_close)) {
            inputs.tracks.push_back(freeze_at(*track, frame.scene_open));
        } else {
            inputs.tracks.push_back(*track);
            moves = true;
        }
    }
    inputs.frame.camera_open = frame.camera_open;
    inputs.frame.camera_close = frame.camera_close;
    inputs.frame.scene_open = moves ? frame.scene_open : 0;
    inputs.frame.scene_close = moves ? frame.scene_close : 0;
    inputs.frame.switch_ratio = shutter.switch_ratio;
    inputs.frame.seed = frame_seed(render_seed, inputs.frame);
    return inputs;
}

}  // namespace carom::pipeline
