#include "pipeline/plan/report_plot.h"

#include <cmath>

#include "pipeline/plan/colour_ramp.h"
#include "pipeline/plan/loudness_curve.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"
#include "pipeline/plan/simplify_line.h"
#include "pipeline/plan/time_axis.h"

namespace carom::pipeline {

namespace {

constexpr double kTop = 24;          // of the upper panel, mm
constexpr double kSpeedHeight = 92;  // of the panels
constexpr double kEnergyHeight = 44;
constexpr double kSoundHeight = 30;
constexpr double kBetween = 12;
constexpr double kNearestLines = 6.5;  // distance of a panel's grid lines
constexpr double kTolerance = 0.02;    // of curves
constexpr double kStill = 1e-3;        // m/s

/// A panel of the plot, with values increasing upwards.
struct Panel {
    double top = 0, height = 1;  // mm
    double highest = 1;          // value at the top
    bool is_square_root = false;
    double lowest = 0;  // value at the bottom; 0 on a square-root scale

    [[nodiscard]] double at(double value) const {
        const double fraction = std::clamp((value - lowest) / (highest - lowest), 0.0, 1.0);
        return top + height * (1 - (is_square_root ? std::sqrt(fraction) : fraction));
    }
    [[nodiscard]] double bottom() const { return top + height; }
};

/// The values of grid lines: round values at a readable distance, from the top downwards.
std::vector<double> grid_of(const Panel& panel) {
    std::vector<double> values;
    if (!panel.is_square_root) {
        const double range = panel.highest - panel.lowest;
        const double step = round_number(range * kNearestLines / panel.height);
        const int lines = static_cast<int>(range * (1 + 1e-9) / step);
        for (int i = 1; i <= lines; ++i) {
            values.push_back(panel.lowest + i * step);
        }
        return values;
    }
    constexpr int kDecades = 4;
    double last = panel.top - kNearestLines;
    double decade = std::pow(10, std::floor(std::log10(panel.highest)));
    for (int i = 0; i < kDecades; ++i, decade /= 10) {
        for (const double step : {5.0, 2.0, 1.0}) {
            const double value = step * decade;
            const double y = panel.at(value);
            if (value <= panel.highest && y >= last + kNearestLines &&
                y <= panel.bottom() - 0.95 * kNearestLines) {
                values.push_back(value);
                last = y;
            }
        }
    }
    return values;
}

void draw_panel(SvgText& svg, const Panel& panel, const TimeAxis& axis, const std::string& name,
                const std::string& explanation) {
    svg.text("text", name,
             {{"class", "head"}, {"x", svg_number(kMargin)}, {"y", svg_number(panel.top - 3)}});
    svg.text("text", explanation,
             {{"class", "faint"},
              {"x", svg_number(kMargin + text_width(name, 3.1) + 3)},
              {"y", svg_number(panel.top - 3)}});
    std::string lines;
    std::vector<double> values = grid_of(panel);
    values.push_back(panel.lowest);
    for (const double value : values) {
        const double y = panel.at(value);
        lines += (lines.empty() ? "" : " ") + svg_path({{kAxisLeft, y}, {kAxisRight, y}}, false);
        svg.text("text", svg_number(value),
                 {{"class", "small faint end"},
                  {"x", svg_number(kAxisLeft - 1.5)},
                  {"y", svg_number(y + 0.8)}});
    }
    for (const double time : axis.ticks()) {
        const double x = axis.at(time);
        lines += " " + svg_path({{x, panel.top}, {x, panel.bottom()}}, false);
    }
    svg.leaf("path", {{"class", "grid"}, {"d", lines}});
    svg.leaf("path",
             {{"class", "fine"},
              {"d", svg_path({{kAxisLeft, panel.bottom()}, {kAxisRight, panel.bottom()}}, false)}});
}

/// The curve of a track's speed until `end`, with one line per interval of motion. A jump of the
/// speed gives two points at the same time.
class SpeedCurve {
  public:
    SpeedCurve(const TimeAxis& axis, const Panel& panel) : axis_(axis), panel_(panel) {}

    void follow(const sim::Track& track, double end) {
        const auto keys = track.keys();
        for (std::size_t i = 0; i + 1 < keys.size() && keys[i].time < end; ++i) {
            const double from = keys[i].time;
            const double to = std::min(keys[i + 1].time, end);
            const int steps =
                std::clamp(static_cast<int>((axis_.at(to) - axis_.at(from)) / kStep), 1, 2000);
            add(from, keys[i].velocity_in.length());
            add(from, keys[i].velocity_out.length());
            for (int step = 1; step < steps; ++step) {
                const double time = from + (to - from) * step / steps;
                add(time, track.sample(time).velocity.length());
            }
            add(to, to < keys[i + 1].time ? track.sample(to).velocity.length()
                                          : keys[i + 1].velocity_in.length());
        }
        stop();
    }

    /// The SVG path "M ... M ..."; empty if the object never moves.
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const Vec2& last() const { return last_; }

  private:
    static constexpr double kStep = 0.25;  // mm

    void add(double time, double speed) {
        const Vec2 point(axis_.at(time), panel_.at(speed));
        if (speed > kStill) {
            if (points_.empty()) {
                points_.emplace_back(last_.y > 0 ? last_ : point);
            }
            points_.push_back(point);
        } else if (!points_.empty()) {
            points_.push_back(point);
            stop();
        }
        last_ = point;
    }
    void stop() {
        if (points_.size() > 1) {
            path_ += (path_.empty() ? "" : " ") + svg_path(simplified(points_, kTolerance), false);
        }
        points_.clear();
    }

    TimeAxis axis_;
    Panel panel_;
    std::vector<Vec2> points_;
    std::string path_;
    Vec2 last_{0, 0};
};

double top_speed(const PlanObject& object) {
    double top = 0;
    for (const sim::Key& key : object.track->keys()) {
        if (key.time <= object.gone) {
            top = std::max({top, key.velocity_in.length(), key.velocity_out.length()});
        }
    }
    return top;
}

/// A moving object and the colour of its curve.
struct Moving {
    double top = 0;  // speed, m/s
    const PlanObject* object = nullptr;
    std::string colour;
};

void draw_speed(PlanDrawing& plan, const Moving& moving, const TimeAxis& axis, const Panel& panel) {
    const PlanObject& object = *moving.object;
    SpeedCurve curve(axis, panel);
    curve.follow(*object.track, std::min(object.gone, plan.timeline.end_time));
    const std::string& path = curve.path();
    const std::string name = object.track->name();
    plan.svg.open("g");
    plan.svg.text("title", name + ", at most " + speed_text(top_speed(object)));
    if (object.radius) {
        plan.svg.leaf("path", {{"class", "casing curve"}, {"d", path}});
    }
    plan.svg.leaf("path", {{"class", object.radius ? "path curve" : "path moving"},
                           {"stroke", moving.colour},
                           {"d", path}});
    if (object.paint.is_striped) {
        plan.svg.leaf("path", {{"class", "stripe curve"}, {"d", path}});
    }
    if (object.gone < plan.timeline.end_time) {
        plan.svg.leaf("circle", {{"class", "ball"},
                                 {"fill", moving.colour},
                                 {"cx", svg_number(curve.last().x)},
                                 {"cy", svg_number(curve.last().y)},
                                 {"r", "0.9"}});
    }
    plan.svg.close();
}

/// The colour ramps of the moving objects: objects that look the same get different colours.
std::vector<ColourRamp> ramps_of(const PlanDrawing& plan) {
    std::vector<RampEntry> entries;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        if (top_speed(plan.objects[i]) > kStill) {
            entries.push_back({plan.objects[i].paint, plan.objects[i].radius.has_value()});
            places.push_back(i);
        }
    }
    std::vector<ColourRamp> ramps = colour_ramps(entries);
    for (ColourRamp& ramp : ramps) {
        for (std::size_t& member : ramp.members) {
            member = places[member];
        }
    }
    return ramps;
}

std::vector<Moving> moving_objects(const PlanDrawing& plan, std::span<const ColourRamp> ramps) {
    std::vector<Moving> all;
    for (const PlanObject& object : plan.objects) {
        all.push_back({top_speed(object), &object, object.paint.colour});
    }
    for (const ColourRamp& ramp : ramps) {
        for (std::size_t place = 0; place < ramp.members.size(); ++place) {
            all[ramp.members[place]].colour = ramp.colour(place);
        }
    }
    std::erase_if(all, [](const Moving& one) { return one.top <= kStill; });
    return all;
}

/// Draws objects that are not balls first, then balls from fast to slow, so that the curves of slow
/// balls stay visible.
void draw_speeds(PlanDrawing& plan, std::span<const ColourRamp> ramps, const TimeAxis& axis) {
    std::vector<Moving> moving = moving_objects(plan, ramps);
    std::stable_sort(moving.begin(), moving.end(),
                     [](const Moving& a, const Moving& b) { return a.top > b.top; });
    const Panel panel{kTop, kSpeedHeight, moving.empty() ? 1 : 1.02 * moving.front().top, true};
    std::stable_partition(moving.begin(), moving.end(),
                          [](const Moving& one) { return !one.object->radius; });
    plan.svg.open("g", {{"id", "speeds"}});
    draw_panel(plan.svg, panel, axis, "speed, m/s",
               "square-root scale; a dot where an object is potted");
    for (const Moving& one : moving) {
        draw_speed(plan, one, axis, panel);
    }
    plan.svg.close();
}

void draw_energy_key(SvgText& svg, double y) {
    double x = kAxisRight - 78;
    for (const auto& [kind, text] :
         {std::pair("total", "with potential"), std::pair("kinetic", "kinetic")}) {
        svg.leaf("path", {{"class", kind}, {"d", svg_path({{x, y}, {x + 8, y}}, false)}});
        svg.text("text", text, {{"x", svg_number(x + 10)}, {"y", svg_number(y + 0.9)}});
        x += 42;
    }
}

void draw_energy(PlanDrawing& plan, const TimeAxis& axis, double top) {
    const auto& energy = plan.timeline.energy;
    double lowest = 1e300;
    double highest = 0;
    for (const sim::EnergySample& sample : energy) {
        lowest = std::min(lowest, sample.potential);
        highest = std::max(highest, sample.total());
    }
    const double range = energy.empty() ? 0 : highest - lowest;
    const Panel panel{top, kEnergyHeight, range > 1e-9 ? 1.02 * range : 1, false};
    std::vector<Vec2> kinetic;
    std::vector<Vec2> total;
    for (const sim::EnergySample& sample : energy) {
        const double x = axis.at(sample.time);
        kinetic.emplace_back(x, panel.at(sample.kinetic));
        total.emplace_back(x, panel.at(sample.total() - lowest));
    }
    plan.svg.open("g", {{"id", "energy"}});
    draw_panel(plan.svg, panel, axis, "energy, J", "potential energy counts from its lowest");
    if (!energy.empty()) {
        std::vector<Vec2> area = simplified(kinetic, kTolerance);
        plan.svg.leaf("path",
                      {{"class", "total"}, {"d", svg_path(simplified(total, kTolerance), false)}});
        plan.svg.leaf("path", {{"class", "kinetic"}, {"d", svg_path(area, false)}});
        area.insert(area.begin(), {area.front().x, panel.bottom()});
        area.emplace_back(area.back().x, panel.bottom());
        plan.svg.leaf("path", {{"class", "area"}, {"d", svg_path(area, true)}});
        draw_energy_key(plan.svg, top - 3.9);
    }
    plan.svg.close();
}

/// How loud the film is, over its own time. Returns the y below its axis.
double draw_sound(SvgText& svg, const FilmLevels& sound, double top) {
    const TimeAxis axis{0, sound.length};
    const Panel panel{top, kSoundHeight, 0, false, kQuietest};
    const std::vector<Vec2> curve = loudness_curve(sound, axis, panel.top, panel.bottom());
    svg.open("g", {{"id", "sound"}});
    draw_panel(svg, panel, axis, "sound, dB of full scale", "over the time of the film");
    svg.leaf("path", {{"class", "area"}, {"d", svg_path(area_below(curve, panel.bottom()), true)}});
    svg.leaf("path", {{"class", "kinetic"}, {"d", svg_path(curve, false)}});
    draw_time_axis(svg, axis, panel.bottom() + 2, "film");
    svg.close();
    return panel.bottom() + 6;
}

}  // namespace

std::string report_plot_svg(const Shot& shot, const sim::Timeline& timeline, PlanPage page,
                            const FilmLevels& sound) {
    PlanDrawing plan{shot,
                     timeline,
                     {},
                     plan_objects(shot, timeline),
                     {},
                     number_events(shot, timeline, kMostNumbers),
                     {},
                     LabelPlacer({}),
                     SvgText(SvgText::Kind::fragment)};
    plan.svg.text("text", shot.name, {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "13"}});
    plan.svg.text("text",
                  sound.decibels.empty() ? "speed and energy over scene time"
                                         : "speed and energy over scene time, sound over film time",
                  {{"class", "end faint"}, {"x", svg_number(kPageWidth - kMargin)}, {"y", "13"}});
    const TimeAxis axis{timeline.start_time, timeline.end_time};
    const std::vector<ColourRamp> ramps = ramps_of(plan);
    draw_speeds(plan, ramps, axis);
    double y = kTop + kSpeedHeight + kBetween;
    draw_energy(plan, axis, y);
    y += kEnergyHeight + 2;
    y = draw_event_marks(plan.svg, axis, plan.events.events, y);
    draw_time_axis(plan.svg, axis, y, "scene");
    if (!sound.decibels.empty()) {
        y = draw_sound(plan.svg, sound, y + kBetween + 3);
    }
    y = draw_names(plan, ramps, y + 6) + 4;
    y = draw_event_list(plan, y) + 6;
    return svg_page(plan.svg.finish(), shot.name + ": speed and energy", page, y);
}

}  // namespace carom::pipeline
