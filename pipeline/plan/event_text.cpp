#include "pipeline/plan/event_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/plan/quantity_text.h"

namespace carom::pipeline {

namespace {

// Smaller angles (rad) and offsets of the tip (ball radii) would be printed as 0.
constexpr double kSteep = 0.5 / 57.295779513082321;
constexpr double kOffCentre = 0.005;

/// Whether the second object hit the first rather than the other way round.
bool is_second_object_faster(const ReportedEvent& impact) {
    return impact.b && (!impact.a || impact.b->before > impact.a->before);
}

/// The ball's speed after the contact with stick and cloth.
std::string speed_after(const ReportedEvent& strike) {
    return speed_text(strike.a ? strike.a->after : strike.event.vector.length());
}

std::string tip_text(double offset, const char* more, const char* less) {
    return std::abs(offset) < kOffCentre ? std::string()
                                         : ", tip " + radius_fraction_text(std::abs(offset)) + " " +
                                               (offset > 0 ? more : less);
}

}  // namespace

const std::string& hit_object(const ReportedEvent& impact) {
    return is_second_object_faster(impact) ? impact.event.a : impact.event.b;
}

EventText impact_text(const ReportedEvent& impact) {
    const sim::Event& event = impact.event;
    const bool b_moves_in = is_second_object_faster(impact);
    const std::string& mover = b_moves_in ? event.b : event.a;
    const std::string& other = hit_object(impact);
    const auto& mover_speed = b_moves_in ? impact.b : impact.a;
    const auto& other_speed = b_moves_in ? impact.a : impact.b;
    EventText text;
    text.brief = mover + " → " + other;
    if (mover_speed && sim::is_level(event.surface())) {
        text.brief = mover + " lands on the " + event.b;
    } else if (mover_speed && !other_speed) {
        text.brief +=
            ", " + speed_text(mover_speed->before) + " to " + speed_text(mover_speed->after);
    }
    text.full = text.brief;
    if (mover_speed && other_speed) {
        const std::string cut = impact.cut ? ", cut " + angle_text(*impact.cut) : "";
        text.label = speed_text(mover_speed->before) + cut;
        text.brief += " at " + text.label;
        text.full = text.brief + ", " + other + " leaves at " + speed_text(other_speed->after);
    }
    return text;
}

EventText strike_text(const ReportedEvent& event, const sim::Strike* strike) {
    EventText text{event.event.a + " struck, leaves at " + speed_after(event), "",
                   speed_after(event)};
    if (strike == nullptr) {
        return text;
    }
    if (strike->elevation > kSteep) {
        text.full += ", stick " + angle_text(strike->elevation) + " steep";
    }
    text.full += tip_text(strike->tip.x, "right", "left");
    text.full += tip_text(strike->tip.y, "high", "low");
    if (strike->speed) {
        text.label = "stick " + speed_text(*strike->speed);
    }
    return text;
}

EventText single_object_text(const sim::Event& event) {
    if (event.kind == sim::EventKind::potted) {
        std::string pocket = event.b;
        std::replace(pocket.begin(), pocket.end(), '_', ' ');
        return {event.a + " potted, " + pocket, "", ""};
    }
    if (event.kind == sim::EventKind::off_table) {
        return {event.a + " leaves the table", "", ""};
    }
    if (event.kind == sim::EventKind::placed) {
        return {event.a + " put down" + (event.b.empty() ? "" : " on the " + event.b + " spot"), "",
                ""};
    }
    if (event.kind == sim::EventKind::removed) {
        return {event.a + " taken off", "", ""};
    }
    return {std::string(to_string(event.kind)) + " on " + event.a, "", ""};
}

}  // namespace carom::pipeline
