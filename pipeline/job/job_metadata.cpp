#include "pipeline/job/job_metadata.h"

#include <fmt/core.h>

#include "render/camera/camera_matrices.h"
#include "render/frame/frame.h"

namespace carom::pipeline {
namespace {

std::string number_text(double value) {
    return fmt::format("{:.9g}", value);
}

// "off", or the radiance to which indirect light was clamped, which makes pictures too dark.
std::string clamp_text(double clamp) {
    return clamp > 0 ? number_text(clamp) : "off";
}

std::map<std::string, std::string> render_metadata(const Shot& shot) {
    std::map<std::string, std::string> metadata{
        {"carom_version", CAROM_VERSION},
        {"renderer_revision", fmt::format("{}", render::kRendererRevision)}};
    if (shot.render.integrator == render::IntegratorKind::distributed) {
        const render::DistributedSettings& settings = shot.render.distributed;
        metadata["integrator"] = "distributed";
        metadata["samples"] = fmt::format("{}", camera_samples(settings));
        metadata["recursion_limit"] = fmt::format("{}", settings.recursion_limit);
    } else {
        metadata["integrator"] = "path";
        metadata["samples"] = fmt::format("{}", shot.render.samples);
        metadata["noise"] = shot.render.noise > 0 ? number_text(shot.render.noise) : "off";
        metadata["max_bounces"] = fmt::format("{}", shot.render.max_bounces);
        metadata["clamp"] = clamp_text(shot.render.clamp);
    }
    return metadata;
}

/// The rays of the frame by kind. They are unknown for a frame that was read from the store.
void add_rays(const render::RenderStatistics& counts, render::ImageMetadata& metadata) {
    if (counts.camera_rays == 0) {
        return;
    }
    metadata["rays_camera"] = fmt::format("{}", counts.camera_rays);
    metadata["rays_scattered"] = fmt::format("{}", counts.scattered_rays);
    metadata["rays_shadow"] = fmt::format("{}", counts.shadow_rays);
    if (metadata["integrator"] == "distributed") {
        metadata["rays_reflection"] = fmt::format("{}", counts.reflection_rays);
        metadata["rays_refraction"] = fmt::format("{}", counts.refraction_rays);
        metadata["rays_shadow_needless"] = fmt::format("{}", counts.needless_shadow_rays);
    }
}

}  // namespace

render::ImageMetadata stored_frame_metadata(const Shot& shot,
                                            const render::RenderStatistics& counts) {
    render::ImageMetadata metadata = render_metadata(shot);
    add_rays(counts, metadata);
    return metadata;
}

render::ImageMetadata exported_frame_metadata(const Shot& shot, const sim::Timeline& timeline,
                                              std::int64_t frame, const render::Film& film) {
    const PlannedFrame planned = plan_frame(frame, shot.cameras, shot.timing, timeline);
    render::ImageMetadata metadata = render_metadata(shot);
    add_rays(film.statistics, metadata);
    for (const auto& [key, value] : film.notes) {
        if (key.rfind(render::kRaysPrefix, 0) == 0) {
            metadata[key] = value;
        }
    }
    metadata["shot"] = shot.name;
    metadata["camera"] = planned.rig;
    metadata["frame"] = fmt::format("{}", frame);
    metadata["video_time"] = number_text(planned.video_time);
    metadata["scene_time"] = number_text(planned.scene_time);
    // The two fields that formats without custom keys provide.
    metadata["Software"] = std::string("carom ") + CAROM_VERSION;
    metadata["ImageDescription"] = shot.name + ", camera " + planned.rig + ", frame " +
                                   metadata["frame"] + ", scene time " + metadata["scene_time"] +
                                   " s, " + metadata["samples"] + " samples, renderer revision " +
                                   metadata["renderer_revision"];
    return metadata;
}

render::ExrStandardAttributes exr_standard_attributes(const Shot& shot,
                                                      const PlannedFrame& planned) {
    const render::CameraMatrices camera = render::camera_matrices(
        planned.camera_open, planned.camera_close, shot.render.width, shot.render.height);
    return {camera.world_to_camera, camera.world_to_ndc,
            static_cast<int>(shot.timing.fps.numerator()),
            static_cast<int>(shot.timing.fps.denominator())};
}

std::map<std::string, std::string> video_metadata(const Shot& shot) {
    std::map<std::string, std::string> metadata = render_metadata(shot);
    metadata["title"] = shot.output.title.empty() ? shot.name : shot.output.title;
    metadata["shot"] = shot.name;
    return metadata;
}

}  // namespace carom::pipeline
