#include "pipeline/store/frame_key.h"

#include <algorithm>
#include <cstdint>

#include "core/field_hasher.h"
#include "pipeline/store/frame_inputs.h"
#include "pipeline/store/own_key.h"
#include "render/denoise/denoise.h"
#include "render/frame/aov_planes.h"
#include "render/frame/frame_fields.h"
#include "render/scene/render_settings_fields.h"
#include "sim/timeline/track_fields.h"

namespace carom::pipeline {
namespace {

// Settings that the integrator ignores are set to their defaults, so that they do not keep frames
// from being shared.
render::RenderSettings used_settings(render::RenderSettings settings) {
    const render::RenderSettings usual;
    if (settings.integrator == render::IntegratorKind::distributed) {
        settings.samples = usual.samples;
        settings.noise = usual.noise;
        settings.max_samples = usual.max_samples;
        settings.max_bounces = usual.max_bounces;
        settings.clamp = usual.clamp;
        settings.for_denoiser = usual.for_denoiser;
    } else {
        settings.distributed = usual.distributed;
    }
    return settings;
}

// Names do not change the image, but mattes contain them.
void add_names(Hasher& hasher, const render::SceneDescription& scene) {
    for (const render::ObjectDescription& object : scene.objects) {
        hasher.add(object.name).add(object.material);
    }
    for (const render::MaterialDescription& material : scene.materials) {
        hasher.add(material.name);
    }
    for (const render::LightDescription& light : scene.lights) {
        hasher.add(light.name);
    }
}

// Adds one smooth segment: the path itself, and the rotation at five instants. Orientation and
// angular velocity at both ends determine the rotation up to the rounding of its integral, which
// the instants in between detect.
void add_segment(FieldHasher& hasher, const sim::Track& track, const sim::PathSegment& segment) {
    hasher.add_value(segment);
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double time = segment.start * (1 - fraction) + segment.end * fraction;
        const MotionState state = track.sample(time);
        hasher.add(state.orientation).add(state.angular_velocity);
    }
}

void add_track(FieldHasher& hasher, const sim::Track& track, const render::FrameInput& frame) {
    const std::vector<sim::PathSegment> segments =
        track.segments(frame.scene_open, frame.scene_close);
    hasher.add(std::uint64_t{segments.size()});
    for (const sim::PathSegment& segment : segments) {
        add_segment(hasher, track, segment);
    }
}

// Adds which objects share a track, and the motion of each track. The tracks' names do not enter.
void add_motion(FieldHasher& hasher, const render::SceneDescription& scene,
                const FrameInputs& inputs) {
    for (const render::ObjectDescription& object : scene.objects) {
        std::uint64_t track = 0;  // 0: none
        for (std::size_t i = 0; i < inputs.tracks.size() && !object.track.empty(); ++i) {
            track = inputs.tracks[i].name() == object.track ? i + 1 : track;
        }
        hasher.add(track);
    }
    hasher.add(std::uint64_t{inputs.tracks.size()});
    for (const sim::Track& track : inputs.tracks) {
        const bool is_still = track.keys().size() == 1;
        hasher.add(is_still);
        if (is_still) {
            hasher.add(track.keys().front().position).add(track.keys().front().orientation);
        } else {
            add_track(hasher, track, inputs.frame);
        }
    }
}

}  // namespace

Hash128 frame_key(const FrameInputs& inputs, const render::SceneDescription& scene,
                  const Hash128& scene_hash, const render::RenderSettings& settings) {
    FieldHasher hasher;
    hasher.add("carom frame").add(std::int32_t{kFrameKeyFormat});
    hasher.add(std::int32_t{render::kRendererRevision});
    hasher.add(scene_hash);
    hasher.add_value(used_settings(settings));
    if (std::any_of(settings.aovs.begin(), settings.aovs.end(), render::is_matte)) {
        add_names(hasher, scene);
    }
    hasher.add_value(inputs.frame);
    add_motion(hasher, scene, inputs);
    return own_key(hasher.finish());
}

Hash128 denoised_key(const Hash128& noisy, double strength) {
    Hasher hasher;
    hasher.add("carom denoised frame, key format 1");
    hasher.add(std::int32_t{render::kDenoiserRevision}).add(noisy).add(strength);
    return own_key(hasher.finish());
}

}  // namespace carom::pipeline
