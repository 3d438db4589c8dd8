#include "pipeline/plan/camera_ruler.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/error.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/plan/quantity_text.h"
#include "pipeline/plan/time_axis.h"

namespace carom::pipeline {

namespace {

// Lengths and distances on paper, mm.
constexpr double kShortestPath = 4;  // shorter paths get no ticks
constexpr double kNearestTicks = 0.5;
constexpr double kTick = 0.55;
constexpr double kLongTick = 1.1;
constexpr double kNearestArrows = 2;
constexpr double kNearestTimes = 6;
constexpr double kArrow = 6;
constexpr double kArrowHead = 0.8;
constexpr double kTimesPerPath = 6;
constexpr double kTimeText = 2.2;

double path_length(const PlanDrawing& plan, const PlanRig& rig) {
    double length = 0;
    for (std::size_t i = 1; i < rig.states.size(); ++i) {
        length +=
            (plan.sheet.at(rig.states[i].position) - plan.sheet.at(rig.states[i - 1].position))
                .length();
    }
    return length;
}

double film_length(const PlanRig& rig) {
    return rig.rig->video_end.to_double() - rig.rig->video_start.to_double();
}

/// Position and view direction of a camera at one instant of the film, on paper.
struct Place {
    Vec2 at{0, 0};
    Vec2 ahead{0, 0};  // horizontal part of the unit view direction
};

class RulerPainter {
  public:
    RulerPainter(PlanDrawing& plan, const PlanRig& rig) : plan_(plan), rig_(rig) {}

    void draw(const CameraRuler& ruler) {
        std::string ticks;
        const double fps = plan_.shot.timing.fps.to_double();
        const double start = rig_.rig->video_start.to_double();
        const auto first = static_cast<std::int64_t>(std::ceil(start * fps - 1e-6));
        const auto end =
            static_cast<std::int64_t>(std::ceil((start + film_length(rig_)) * fps - 1e-6));
        for (std::int64_t n = first; n < end; n += ruler.frame_step) {
            add_tick(static_cast<double>(n) / fps, kTick, ticks);
        }
        draw_lines(ticks, "tick");
        std::string long_ticks;
        const double step = ruler.time_step;
        const auto first_step = static_cast<std::int64_t>(std::ceil(start / step - 1e-6));
        const auto last_step =
            static_cast<std::int64_t>(std::floor((start + film_length(rig_)) / step + 1e-6));
        for (std::int64_t n = first_step; n <= last_step; ++n) {
            const double time = step * static_cast<double>(n);
            add_tick(time, kLongTick, long_ticks);
            const Place place = place_at(time);
            if ((place.at - last_arrow_).length() >= kNearestArrows) {
                draw_arrow(place);
            }
            if ((place.at - last_time_).length() >= kNearestTimes) {
                draw_time(place, time);
            }
        }
        draw_lines(long_ticks, "long-tick");
    }

  private:
    [[nodiscard]] Place place_at(double film_time) const {
        const WideRational time(Rational::nearest(std::clamp(
            film_time, rig_.rig->video_start.to_double(), rig_.rig->video_end.to_double())));
        const render::CameraState state = camera_state(
            *rig_.rig, {progress_at(*rig_.rig, time), scene_time_at(*rig_.rig, time).to_double()},
            plan_.timeline);
        const Vec3 ahead = (state.target - state.position).normalized();
        return {plan_.sheet.at(state.position), Vec2(ahead.x, -ahead.y)};
    }

    void add_tick(double time, double length, std::string& lines) const {
        const double around = 0.25 / plan_.shot.timing.fps.to_double();
        const Vec2 along = place_at(time + around).at - place_at(time - around).at;
        if (along.length() < 1e-6) {
            return;  // the camera does not move
        }
        const Vec2 across = Vec2(-along.y, along.x).normalized();
        const Vec2 at = place_at(time).at;
        lines += (lines.empty() ? "" : " ") +
                 svg_path({at - length * across, at + length * across}, false);
    }

    void draw_lines(const std::string& lines, const char* name) {
        if (!lines.empty()) {
            plan_.svg.leaf("path", {{"class", name}, {"stroke", rig_.colour}, {"d", lines}});
        }
    }

    /// Draws an arrow in the view direction.
    void draw_arrow(const Place& place) {
        last_arrow_ = place.at;
        const Vec2 tip = place.at + kArrow * place.ahead;
        draw_lines(svg_path({place.at, tip}, false), "view");
        if (kArrow * place.ahead.length() > 2 * kArrowHead) {
            const Vec2 on = place.ahead.normalized();
            const Vec2 across(-on.y, on.x);
            const Vec2 back = tip - 1.6 * kArrowHead * on;
            plan_.svg.leaf("path", {{"fill", rig_.colour},
                                    {"d", svg_path({tip, back + 0.5 * kArrowHead * across,
                                                    back - 0.5 * kArrowHead * across},
                                                   true)}});
        }
        for (int i = 0; i <= 4; ++i) {
            const Vec2 on = place.at + (tip - place.at) * (i / 4.0);
            plan_.labels.keep_free({on - Vec2(0.6), on + Vec2(0.6)}, 1);
        }
    }

    void draw_time(const Place& place, double time) {
        last_time_ = place.at;
        const std::string text = time_text(time);
        const Vec2 size(text_width(text, kTimeText), kTimeText);
        const Vec2 corner = plan_.labels.place(place.at, size, 1.3);
        plan_.svg.text("text", text,
                       {{"class", "small"},
                        {"x", svg_number(corner.x)},
                        {"y", svg_number(corner.y + 0.8 * kTimeText)},
                        {"style", "fill:" + rig_.colour}});
    }

    PlanDrawing& plan_;
    const PlanRig& rig_;
    Vec2 last_arrow_{1e9, 1e9};
    Vec2 last_time_{1e9, 1e9};
};

}  // namespace

std::optional<CameraRuler> camera_ruler(const PlanDrawing& plan) {
    const double fps = plan.shot.timing.fps.to_double();
    double longest = 0;  // film time of the cameras that move, s
    double frames = 1;   // between ticks
    for (const PlanRig& rig : plan.rigs) {
        const double length = path_length(plan, rig);
        if (length >= kShortestPath) {
            longest = std::max(longest, film_length(rig));
            frames = std::max(frames, kNearestTicks * film_length(rig) * fps / length);
        }
    }
    if (longest <= 0) {
        return std::nullopt;
    }
    return CameraRuler{static_cast<int>(std::lround(round_number(std::max(1.0, frames)))),
                       round_number(std::max(longest / kTimesPerPath, 1 / fps))};
}

void draw_ruler(PlanDrawing& plan, const PlanRig& rig, const CameraRuler& ruler) {
    if (path_length(plan, rig) < kShortestPath) {
        return;
    }
    try {
        RulerPainter(plan, rig).draw(ruler);
    } catch (const Error&) {
        // The camera is invalid in some frame; 'carom check' reports the reason.
    }
}

std::string frame_step_text(int frame_step) {
    if (frame_step == 1) {
        return "each frame";
    }
    return fmt::format("each {}{} frame", frame_step, frame_step == 2 ? "nd" : "th");
}

}  // namespace carom::pipeline
