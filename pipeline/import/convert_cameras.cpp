// Converts cameras to rigs, which film one after the other.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"

namespace carom::pipeline::scene_text {

namespace {

using config::quote;

constexpr double kDefaultFov = 2;
constexpr double kNarrowestAngle = 1e-4;  // rad
constexpr double kWidestAngle = 3.1;

/// A camera with all defaults filled in.
struct Rig {
    const Camera* camera = nullptr;
    double video_start = 0, video_end = 0, time_start = 0, time_end = 0;
};

/// The cameras in order of video time. Missing times follow from the given ones.
std::vector<Rig> timed(Conversion& conversion) {
    std::vector<Rig> rigs;
    double end = 0;  // of the previous camera
    for (const Camera& camera : conversion.scene.cameras) {
        Rig rig{&camera};
        rig.video_start = camera.video_start.value_or(end);
        const double length = camera.time_start && camera.time_end
                                  ? std::abs(*camera.time_end - *camera.time_start)
                                  : 1;
        rig.video_end = camera.video_end.value_or(rig.video_start + length);
        rig.time_start = camera.time_start.value_or(rig.video_start);
        rig.time_end = camera.time_end.value_or(rig.time_start + rig.video_end - rig.video_start);
        if (!camera.video_start || !camera.video_end || !camera.time_start || !camera.time_end) {
            conversion.note("camera " + quote(camera.name.text) + " has default times: from " +
                            yaml(rig.video_start) + " to " + yaml(rig.video_end) +
                            " s of the film, it shows the scene from " + yaml(rig.time_start) +
                            " to " + yaml(rig.time_end) + " s");
        }
        if (!(rig.video_end > rig.video_start)) {
            conversion.problems.error(camera.name.place,
                                      "camera " + quote(camera.name.text) + " films from " +
                                          yaml(rig.video_start) + " to " + yaml(rig.video_end) +
                                          " s of the film; the end must be after the start");
        }
        end = rig.video_end;
        rigs.push_back(rig);
    }
    std::stable_sort(rigs.begin(), rigs.end(),
                     [](const Rig& a, const Rig& b) { return a.video_start < b.video_start; });
    return rigs;
}

/// Moves cameras to earlier video times, so that the film has no gaps and starts at 0. An overlap
/// is an error.
void close_gaps(std::vector<Rig>& rigs, Conversion& conversion) {
    double end = 0;
    double shift = 0;
    for (std::size_t i = 0; i < rigs.size(); ++i) {
        Rig& rig = rigs[i];
        rig.video_start -= shift;
        rig.video_end -= shift;
        const double gap = rig.video_start - end;
        const std::string name = quote(rig.camera->name.text);
        if (gap > 1e-9) {
            conversion.note("the gap of " + yaml(gap) + " s before camera " + name +
                            " was removed from the film");
            rig.video_start -= gap;
            rig.video_end -= gap;
            shift += gap;
        } else if (gap < -1e-9) {
            conversion.problems.error(rig.camera->name.place,
                                      "camera " + name + " starts before camera " +
                                          quote(rigs[i - 1].camera->name.text) + " ends");
        }
        end = rig.video_end;
    }
}

std::string path(const std::vector<Vec3>& points, const Axes& axes) {
    if (points.size() == 1) {
        return yaml(axes.place(points.front()));
    }
    std::string text;
    for (const Vec3& point : points) {
        text += (text.empty() ? "{bezier: [" : ", ") + yaml(axes.place(point));
    }
    return text + "]}";
}

/// The angle of view across the height of the picture, rad, within what carom allows.
double vertical_angle(double fov, double height_by_width, FieldOfView meaning) {
    const double half_width = meaning == FieldOfView::distance ? 2 / fov : fov / 2;
    return std::clamp(2 * std::atan(height_by_width * half_width), kNarrowestAngle, kWidestAngle);
}

std::string degrees(double angle) {
    return yaml(angle * 180 / std::numbers::pi) + " deg";
}

/// One value, or a list of the values at start and end.
std::string start_end(const std::string& start, const std::string& end) {
    return start == end ? start : "[" + start + ", " + end + "]";
}

std::string focus(const Real& distance, const Axes& axes) {
    return distance ? yaml(axes.length(*distance)) : "auto";
}

/// The roll angle of a camera with view direction `forward` that turns its up vector from
/// `reference` to `up`.
double roll_between(const Vec3& forward, const Vec3& reference, const Vec3& up) {
    const Vec3 right = forward.cross(reference);
    const Vec3 upright = right.cross(forward);
    // A camera with roll r has the up vector upright cos r - right sin r.
    return std::atan2(-(up.dot(right.normalized())), up.dot(upright.normalized()));
}

void write_sky(std::ostringstream& out, const Rig& rig, Conversion& conversion) {
    const Camera& camera = *rig.camera;
    const Vec3 usual = conversion.axes.author_up();
    const Vec3 start = camera.sky_start.value_or(usual);
    const Vec3 end = camera.sky_end.value_or(start);
    const std::string owner = "camera " + quote(camera.name.text);
    const auto looks_along = [](const Vec3& forward, const Vec3& sky) {
        return forward.cross(sky).length() < 1e-6 * forward.length() * sky.length();
    };
    const Vec3 first = camera.targets.front() - camera.positions.front();
    const Vec3 last = camera.targets.back() - camera.positions.back();
    for (const auto& [forward, sky] : {std::pair(first, start), std::pair(last, end)}) {
        if (forward.length() < 1e-9) {
            conversion.problems.error(
                camera.name.place,
                owner + " has the same position as its target at the start or the end");
            return;
        }
        if (looks_along(forward, sky)) {
            conversion.problems.error(
                camera.name.place, owner + " looks along its sky vector at the start or the end");
            return;
        }
    }
    const Vec3 up = conversion.axes.direction(start);
    if (up.cross(Vec3(0, 0, 1)).length() > 1e-12 || up.z < 0) {
        out << "    up: " << yaml(up.normalized()) << "\n";
    }
    const double roll = looks_along(last, start) ? 0 : roll_between(last, start, end);
    if (std::abs(roll) > 1e-9) {
        out << "    roll: [0 deg, " << degrees(roll) << "]\n";
        conversion.note(owner + ": the rotation of its sky vector became a roll at constant speed");
    }
}

void write_lens(std::ostringstream& out, const Rig& rig, Conversion& conversion) {
    const Camera& camera = *rig.camera;
    const std::optional<Settings>& settings = conversion.scene.settings;
    const double width = settings ? settings->width.value_or(kDefaultWidth) : kDefaultWidth;
    const double height = settings ? settings->height.value_or(kDefaultHeight) : kDefaultHeight;
    const double start = camera.fov_start.value_or(kDefaultFov);
    const double end = camera.fov_end.value_or(camera.fov_start.value_or(kDefaultFov));
    const std::string owner = "camera " + quote(camera.name.text);
    if (!camera.fov_start) {
        conversion.note(owner + " has the default FOV, " + yaml(kDefaultFov));
    }
    const FieldOfView meaning = conversion.options.field_of_view;
    conversion.note(meaning == FieldOfView::distance
                        ? "FOV is interpreted as the distance of an image plane four units wide, "
                          "2 atan(2 / FOV) across the picture; '--fov formula' takes the manual's "
                          "2 atan(FOV / 2), with which its own example would zoom out"
                        : "FOV is interpreted by the manual's formula, 2 atan(FOV / 2) across the "
                          "picture; '--fov distance' takes 2 atan(2 / FOV)");
    out << "    fov: "
        << start_end(degrees(vertical_angle(start, height / width, meaning)),
                     degrees(vertical_angle(end, height / width, meaning)))
        << "\n";
    if (start != end) {
        conversion.note(owner +
                        ": during its zoom the angle changes linearly, not the distance FOV");
    }
    out << "    focus: "
        << start_end(focus(camera.dof_start, conversion.axes),
                     focus(camera.dof_end, conversion.axes))
        << "\n";
    const double dof_c = settings ? settings->dof_c.value_or(0) : 0;
    const double samples = settings ? settings->dof_samples.value_or(0) : 0;
    if (dof_c > 0 && samples > 1) {
        const double radius = conversion.axes.length(dof_c);
        out << "    aperture: " << yaml(std::min(radius, 10.0)) << " m\n";
        conversion.note(
            "dof_c is the radius of a lens with uniformly distributed rays; the surface in focus "
            "is "
            "a plane");
    }
}

}  // namespace

std::string cameras_section(Conversion& conversion, double& duration) {
    std::vector<Rig> rigs = timed(conversion);
    close_gaps(rigs, conversion);
    std::ostringstream out;
    out << "cameras:\n";
    Names names(names_of(conversion.scene.cameras));
    duration = 0;
    for (const Rig& rig : rigs) {
        duration = std::max({duration, rig.time_start, rig.time_end});
        out << "  - name: " << conversion.name("camera", rig.camera->name.text, names) << "\n"
            << "    video: [" << yaml(rig.video_start) << " s, " << yaml(rig.video_end) << " s]\n"
            << "    scene: [" << yaml(rig.time_start) << " s, " << yaml(rig.time_end) << " s]\n"
            << "    position: " << path(rig.camera->positions, conversion.axes) << "\n"
            << "    target: " << path(rig.camera->targets, conversion.axes) << "\n";
        write_lens(out, rig, conversion);
        write_sky(out, rig, conversion);
    }
    return out.str();
}

}  // namespace carom::pipeline::scene_text
