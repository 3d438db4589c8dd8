// Checks the output settings.
#include <algorithm>
#include <cmath>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/video/overlay_extent.h"
#include "pipeline/video/video_format.h"

namespace carom::pipeline::config {

namespace {

/// Warns of an overlay that does not fit into the picture.
void check_overlay(Builder& builder) {
    const Shot& shot = builder.shot;
    const OverlaySettings& overlay = shot.output.overlay;
    if (overlay.show.empty()) {
        return;
    }
    const double picture_width = static_cast<double>(shot.render.width) / shot.render.height;
    const OverlayExtent extent = overlay_extent(overlay);
    const double excess = std::max(extent.width / picture_width, extent.height);
    if (excess <= 1) {
        return;
    }
    const double largest = std::floor(overlay.size / excess * 1000) / 1000;
    builder.reader.warning(builder.place_of({"output", "overlay"}),
                           std::string("the overlay runs off the picture's ") +
                               (extent.height > 1 ? "upper or lower" : "right or left") +
                               " edge; the largest 'size' that fits is " +
                               show(largest, Dimension::none));
}

}  // namespace

/// The precedence of a value by its place: first options, then the shot, then included files.
int precedence(const Builder& builder, const Place& place) {
    if (place.source < 0) {
        return -1;
    }
    const bool is_option = builder.reader.sources().at(place.source).name.starts_with("--");
    return is_option ? 2 : place.source == 0 ? 1 : 0;  // the first source is the shot
}

/// The place of the key with the highest precedence among keys of `output` that contradict each
/// other.
Place place_of_setting(const Builder& builder, const std::vector<std::string>& keys) {
    Place last = builder.place_of({"output"});
    int highest = -1;
    const Entry* output = builder.root.find("output");
    for (const std::string& key : keys) {
        const Entry* entry = output != nullptr ? output->value.find(key) : nullptr;
        if (entry != nullptr && precedence(builder, entry->value.place) > highest) {
            highest = precedence(builder, entry->value.place);
            last = entry->value.place;
        }
    }
    return last;
}

/// Why the frames cannot be denoised; empty if they can.
std::string denoising_problem(const render::RenderSettings& render) {
    if (render.integrator == render::IntegratorKind::distributed) {
        return "frames of the integrator 'distributed' cannot be denoised";
    }
    if (render.samples < 2 || render.samples % 2 != 0) {
        return "frames can only be denoised with an even number of 'samples', because they are "
               "taken in two halves";
    }
    return {};
}

/// Where frames cannot be denoised, that is an error of the shot, but a preset only switches it on
/// where it can.
void apply_denoise(Builder& builder) {
    Shot& shot = builder.shot;
    if (shot.output.denoise.strength <= 0) {
        return;
    }
    const std::string problem = denoising_problem(shot.render);
    if (problem.empty()) {
        shot.render.for_denoiser = true;
        return;
    }
    const Place place = place_of_setting(builder, {"denoise"});
    if (precedence(builder, place) > 0) {
        builder.reader.error(place, problem);
    } else {
        builder.reader.warning(place, problem + "; they stay as they are");
        shot.output.denoise.strength = 0;
    }
}

/// The size of the picture is not checked here: whether it is possible depends on the type of the
/// output file, which only the command knows.
void check_output(Builder& builder) {
    const Reader::Scope scope(builder.reader, "output", {});
    const Shot& shot = builder.shot;
    const std::string film = "film" + default_extension(shot.output);
    const std::string problem = check_video_format({1280, 720, shot.timing.fps}, shot.output, film);
    if (!problem.empty()) {
        const SettingProblem setting = find_setting_problem(shot.output, film);
        builder.reader.error(setting.sentence.empty() ? builder.place_of({"render", "fps"})
                                                      : place_of_setting(builder, setting.keys),
                             problem);
    }
    check_overlay(builder);
}

void check_poster(Builder& builder) {
    const Reader::Scope scope(builder.reader, "output", {});
    const Shot& shot = builder.shot;
    const double end =
        static_cast<double>(frame_count(shot.cameras, shot.timing)) / shot.timing.fps.to_double();
    if (shot.output.poster && *shot.output.poster >= end) {
        builder.reader.warning(builder.place_of({"output", "poster"}),
                               "the poster's time of " +
                                   show(*shot.output.poster, Dimension::time) +
                                   " is not within the film, which ends at " +
                                   show(end, Dimension::time) + "; the last frame is used instead");
    }
}

}  // namespace carom::pipeline::config
