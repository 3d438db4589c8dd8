#include "pipeline/store/frame_key.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "pipeline/store/camera_hash.h"
#include "pipeline/store/frame_inputs.h"
#include "render/acceleration/analytic_kernels.h"
#include "render/frame/aov_planes.h"

namespace carom::pipeline {
namespace {

void add_distributed(Hasher& hasher, const render::DistributedSettings& settings) {
    hasher.add(settings.pixel_samples).add(settings.blur_samples).add(settings.lens_samples);
    hasher.add(settings.shadow_samples).add(settings.reflection_samples);
    hasher.add(settings.refraction_samples).add(settings.recursion_limit);
    hasher.add(settings.falloff).add(settings.ambient_coefficient);
}

void add_settings(Hasher& hasher, const render::RenderSettings& settings) {
    hasher.add(settings.width).add(settings.height).add(settings.seed);
    hasher.add(static_cast<std::int32_t>(settings.integrator));
    // What one integrator ignores would only keep its frames from being shared.
    if (settings.integrator == render::IntegratorKind::distributed) {
        add_distributed(hasher, settings.distributed);
    } else {
        hasher.add(settings.samples).add(settings.noise).add(settings.max_samples);
        hasher.add(settings.max_bounces).add(settings.clamp);
    }
    hasher.add(static_cast<std::int32_t>(settings.filter)).add(settings.filter_width);
    hasher.add(static_cast<std::int32_t>(settings.acceleration));
    hasher.add(std::uint64_t{settings.aovs.size()});
    for (const std::string& aov : settings.aovs) {
        hasher.add(aov);
    }
}

// Names do not change what is seen, but what mattes call it.
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

// One smooth piece: the path as it is, and the turning by what it is at five instants. Orientation
// and angular velocity at the ends fix it up to the rounding of its integral, which the instants
// between would show.
void add_stretch(Hasher& hasher, const sim::Track& track, const sim::PathStretch& stretch) {
    hasher.add(stretch.start).add(stretch.end);
    hasher.add(stretch.p0).add(stretch.p1).add(stretch.v0).add(stretch.v1);
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double time = stretch.start * (1 - share) + stretch.end * share;
        const MotionState state = track.sample(time);
        hasher.add(state.orientation).add(state.angular_velocity);
    }
}

void add_track(Hasher& hasher, const sim::Track& track, const render::FrameInput& frame) {
    const std::vector<sim::PathStretch> stretches =
        track.stretches(frame.scene_open, frame.scene_close);
    hasher.add(std::uint64_t{stretches.size()});
    for (const sim::PathStretch& stretch : stretches) {
        add_stretch(hasher, track, stretch);
    }
}

// Which objects share a track, and what each track does. The tracks' names do not matter.
void add_motion(Hasher& hasher, const render::SceneDescription& scene, const FrameInputs& inputs) {
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
    Hasher hasher;
    hasher.add("carom frame, key format 2");
    hasher.add(std::int32_t{render::kRendererRevision}).add(render::simd_tier());
    hasher.add(scene_hash);
    add_settings(hasher, settings);
    if (std::any_of(settings.aovs.begin(), settings.aovs.end(), render::is_matte)) {
        add_names(hasher, scene);
    }
    add_camera(hasher, inputs.frame.camera_open);
    add_camera(hasher, inputs.frame.camera_close);
    hasher.add(inputs.frame.scene_open).add(inputs.frame.scene_close);
    hasher.add(inputs.frame.switch_ratio);
    add_motion(hasher, scene, inputs);
    return hasher.finish();
}

Hash128 frame_key(const PlannedFrame& frame, const Shutter& shutter,
                  const render::SceneDescription& scene, const Hash128& scene_hash,
                  const render::RenderSettings& settings, const sim::Timeline& timeline) {
    return frame_key(frame_inputs(frame, shutter, scene, timeline, settings.seed), scene,
                     scene_hash, settings);
}

}  // namespace carom::pipeline
