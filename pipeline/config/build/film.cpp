#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/picture_size.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"
#include "render/scene/scene_problems.h"

namespace carom::pipeline::config {

namespace {

/// The place of a camera's own `name`, or of the camera.
Place place_of_camera(const Builder& builder, std::size_t index) {
    const Entry* cameras = builder.root.find("cameras");
    if (cameras == nullptr || index >= cameras->value.items.size()) {
        return builder.file.cameras_place;
    }
    const Node& camera = cameras->value.items[index];
    const Entry* name = camera.find("name");
    return name != nullptr ? name->value.place : camera.place;
}

/// The corners of the box around the playing field, the cushions and the rails.
std::vector<Vec3> corners_of_table(const sim::billiards::TableMeasures& table) {
    const double beside = table.cushion_width + table.rail_width;
    std::vector<Vec3> corners;
    for (const double x : {-table.length / 2 - beside, table.length / 2 + beside}) {
        for (const double y : {-table.width / 2 - beside, table.width / 2 + beside}) {
            corners.emplace_back(x, y, 0);
            corners.emplace_back(x, y, table.rail_height);
        }
    }
    return corners;
}

/// Fills in what a camera needs to know of the picture and the table.
void fit_to_picture(Builder& builder, std::size_t index, CameraRig& rig) {
    rig.aspect = static_cast<double>(builder.shot.render.width) / builder.shot.render.height;
    if (measures_width(rig.fov_axis, rig.aspect)) {
        rig.sensor_height /= rig.aspect;
    }
    if (!rig.framing) {
        return;
    }
    const auto& table = builder.shot.world.table;
    if (table && table->has_cushions) {
        rig.framing->points = corners_of_table(*table);
        return;
    }
    if (!builder.file.table || table) {  // else its problem was reported
        builder.reader.error(
            builder.place_of({"cameras", fmt::format("{}", index), "frame"}),
            "camera " + quote(rig.name) + " frames the table, but " +
                (table ? "an unbounded cloth has no rails" : "the shot has no table"));
    }
}

void add_cameras(Builder& builder) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < builder.file.cameras.size(); ++i) {
        CameraRig rig = builder.file.cameras[i];
        if (rig.name.empty()) {
            rig.name = fmt::format("camera_{}", i + 1);
        }
        if (!names.insert(rig.name).second) {
            builder.reader.error(place_of_camera(builder, i),
                                 "more than one camera has the name " + quote(rig.name));
        }
        fit_to_picture(builder, i, rig);
        builder.shot.cameras.push_back(std::move(rig));
    }
}

/// The place of a camera's interval of the film.
Place place_of_rig(const Builder& builder, std::size_t index) {
    const Entry* cameras = builder.root.find("cameras");
    if (cameras != nullptr && index < cameras->value.items.size()) {
        if (const Entry* video = cameras->value.items[index].find("video")) {
            return video->value.place;
        }
    }
    return place_of_camera(builder, index);
}

/// Reports gaps and overlaps at the later of two cameras, with the place of the other.
void check_sequence(Builder& builder) {
    const Shot& shot = builder.shot;
    for (const RigProblem& problem : find_problems(shot.cameras, shot.timing)) {
        const Place place =
            problem.rig ? place_of_rig(builder, *problem.rig) : builder.file.cameras_place;
        std::string message = problem.message;
        if (problem.other) {
            const Place other = place_of_rig(builder, *problem.other);
            message += " (" + quote(shot.cameras[*problem.other].name) + " is at " +
                       builder.reader.sources().to_string(other) + ")";
        }
        builder.reader.error(place, message);
    }
}

/// Warns of scene times outside the simulation, at which nothing moves.
void check_scene_times(Builder& builder) {
    const double duration = builder.shot.world.duration;
    for (std::size_t i = 0; i < builder.shot.cameras.size(); ++i) {
        const SceneTimeRange shown = shown_scene_times(builder.shot.cameras[i]);
        const double first = shown.first.to_double();
        const double last = shown.last.to_double();
        if (first < 0) {
            builder.reader.warning(place_of_camera(builder, i),
                                   "camera " + quote(builder.shot.cameras[i].name) +
                                       " shows scene time from " + show(first, Dimension::time) +
                                       " on, but the simulation begins at 0 s");
        }
        if (last > duration) {
            builder.reader.warning(place_of_camera(builder, i),
                                   "camera " + quote(builder.shot.cameras[i].name) +
                                       " shows scene time up to " + show(last, Dimension::time) +
                                       ", but the simulation ends at " +
                                       show(duration, Dimension::time));
        }
    }
}

Rational exposure_of(const ShutterSection& shutter, const Rational& fps) {
    if (!shutter.is_turn) {
        return shutter.length;
    }
    try {
        return shutter.length / fps;
    } catch (const Error&) {  // the exact fraction has too many digits
        return Rational::nearest(shutter.length.to_double() / fps.to_double());
    }
}

/// Warns of exposures that overlap, so that neighbouring frames show the same motion.
void check_exposure(Builder& builder) {
    const FilmTiming& timing = builder.shot.timing;
    const double exposure = timing.shutter.exposure.to_double();
    const double frame = 1 / timing.fps.to_double();
    if (timing.shutter.clock == ShutterClock::video && exposure > frame * (1 + 1e-9)) {
        const Reader::Scope scope(builder.reader, "render", {});
        builder.reader.warning(builder.place_of({"render", "shutter"}),
                               "the shutter is open for " + show(exposure, Dimension::time) +
                                   ", longer than a frame lasts (" + show(frame, Dimension::time) +
                                   ")");
    }
}

/// Scales the picture to its `short_side`.
void apply_short_side(Builder& builder) {
    const std::optional<int>& short_side = builder.file.render.short_side;
    if (!short_side) {
        return;
    }
    render::RenderSettings& render = builder.shot.render;
    const PictureSize size = scaled_to_short_side({render.width, render.height}, *short_side);
    if (std::max(size.width, size.height) > render::kLongestSide) {
        builder.reader.error(
            builder.place_of({"render", "short_side"}),
            fmt::format(
                "a short side of {} makes the picture {}x{}, but a side may have at most {} "
                "pixels; use a smaller 'short_side', or only 'size'",
                *short_side, size.width, size.height, render::kLongestSide));
        return;
    }
    render.width = size.width;
    render.height = size.height;
}

void build_cameras(Builder& builder) {
    const Reader::Scope scope(builder.reader, "cameras", builder.file.cameras_place);
    add_cameras(builder);
    if (builder.reader.has_error()) {
        return;
    }
    if (builder.shot.cameras.empty()) {
        builder.reader.warning(builder.file.cameras_place,
                               "the shot has no camera: it can be baked, but not filmed");
        return;
    }
    check_sequence(builder);
    if (!builder.reader.has_error()) {
        check_scene_times(builder);
    }
}

}  // namespace

void build_film(Builder& builder) {
    const RenderSection& render = builder.file.render;
    Shot& shot = builder.shot;
    shot.render = render.settings;
    apply_short_side(builder);
    shot.output = builder.file.output;
    shot.timing.fps = render.fps;
    shot.timing.shutter.exposure = exposure_of(render.shutter, render.fps);
    shot.timing.shutter.clock = render.shutter.clock;
    shot.timing.shutter.position = render.shutter.position;
    shot.timing.shutter.switch_ratio = render.shutter.switch_ratio;
    apply_denoise(builder);
    check_output(builder);
    check_exposure(builder);
    build_cameras(builder);
    if (!builder.reader.has_error() && !shot.cameras.empty()) {
        check_poster(builder);
    }
}

}  // namespace carom::pipeline::config
