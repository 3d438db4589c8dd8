#include <algorithm>

#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/shot_lookup.h"

namespace carom::pipeline {

namespace {

constexpr double kTolerance = 2e-4;  // of paths, m; 0.01 mm on paper at 1:20

}  // namespace

std::vector<PlanObject> plan_objects(const Shot& shot, const sim::Timeline& timeline) {
    std::vector<PlanObject> objects;
    for (const sim::Track& track : timeline.tracks) {
        if (track.name() == kStickTrack) {  // draw_sticks shows it
            continue;
        }
        PlanObject object;
        object.track = &track;
        object.body = find_body(shot, track.name());
        if (object.body != nullptr) {
            if (const auto* sphere = std::get_if<sim::Sphere>(&object.body->shape)) {
                object.radius = sphere->radius;
            }
        }
        object.paint = paint_of(shot, track.name());
        for (const sim::Event& event : timeline.events) {
            if (event.a != track.name()) {
                continue;
            }
            if (event.kind == sim::EventKind::potted || event.kind == sim::EventKind::removed) {
                object.gone = event.time;
                object.is_removed = event.kind == sim::EventKind::removed;
            } else if (event.kind == sim::EventKind::placed) {
                object.gone = PlanObject::kNotGone;
                object.is_removed = false;
            }
        }
        object.motion = motion_phases(track, object.radius,
                                      std::min(object.gone, timeline.end_time), kTolerance);
        objects.push_back(std::move(object));
    }
    return objects;
}

std::string svg_page(const std::string& body, const std::string& title, PlanPage page,
                     double height) {
    SvgText svg;
    svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                     {"width", svg_number(kPageWidth) + "mm"},
                     {"height", svg_number(height) + "mm"},
                     {"viewBox", "0 0 " + svg_number(kPageWidth) + " " + svg_number(height)}});
    svg.text("title", title);
    svg.text("style", plan_style(page));
    svg.leaf(
        "rect",
        {{"class", "paper"}, {"width", svg_number(kPageWidth)}, {"height", svg_number(height)}});
    svg.raw(body);
    svg.close();
    return svg.finish();
}

}  // namespace carom::pipeline
