#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"
#include "pipeline/plan/shot_lookup.h"

namespace carom::pipeline {

namespace {

constexpr double kBadge = 1.75;        // radius of a number's disc, mm
constexpr double kStickLength = 1.47;  // m
constexpr double kTipRadius = 0.0065;
constexpr double kButtRadius = 0.0145;
constexpr double kTipGap = 0.006;  // between tip and ball, m
constexpr double kLine = 4.2;      // line height of the list, mm
constexpr double kText = 2.6;
constexpr double kSmall = 2.2;

/// The direction of the stick, seen from above; the ball's direction if the shot gives none.
Vec2 aim_of(const PlanDrawing& plan, const sim::Event& event, const sim::Strike* strike) {
    Vec2 aim(event.vector.x, event.vector.y);
    if (strike == nullptr) {
        return aim;
    }
    if (strike->direction) {
        return {std::cos(*strike->direction), std::sin(*strike->direction)};
    }
    const auto towards = [&](const Vec3& point) {
        return Vec2(point.x - event.place.x, point.y - event.place.y);
    };
    if (strike->toward) {
        if (const sim::Track* track = plan.timeline.find(*strike->toward)) {
            return towards(track->sample(event.time).position);
        }
        if (const sim::Body* body = find_body(plan.shot, *strike->toward)) {
            return towards(body->pose.position);
        }
    }
    return strike->toward_point ? towards(*strike->toward_point) : aim;
}

void draw_stick(PlanDrawing& plan, const sim::Event& event) {
    const sim::Strike* strike = strike_of(plan.shot, plan.timeline, event);
    const sim::Body* ball = find_body(plan.shot, event.a);
    Vec2 aim = aim_of(plan, event, strike);
    if (aim.length() < 1e-9) {
        return;
    }
    aim.normalize();
    const auto* sphere = ball != nullptr ? std::get_if<sim::Sphere>(&ball->shape) : nullptr;
    const double radius = sphere != nullptr ? sphere->radius : 0.028;
    const double elevation = strike != nullptr ? strike->elevation : 0;
    const double aside = strike != nullptr ? strike->tip.x * radius : 0;
    const Vec2 right(aim.y, -aim.x);
    const Vec2 centre = Vec2(event.place.x, event.place.y) + aside * right;
    const double inside = std::sqrt(std::max(0.0, radius * radius - aside * aside));
    const Vec2 tip = centre - (inside * std::cos(elevation) + kTipGap) * aim;
    const Vec2 butt = tip - kStickLength * std::cos(elevation) * aim;
    plan.svg.open("g");
    plan.svg.text("title", "the stick at " + time_text(event.time));
    const Vec2 start = plan.sheet.at(Vec2(event.place.x, event.place.y));
    const Vec2 ahead = plan.sheet.at(Vec2(event.place.x, event.place.y) + 0.6 * aim);
    plan.svg.leaf("path", {{"class", "aim"}, {"d", svg_path({start, ahead}, false)}});
    plan.svg.leaf("path", {{"class", "stick"},
                           {"d", svg_path({plan.sheet.at(tip + kTipRadius * right),
                                           plan.sheet.at(tip - kTipRadius * right),
                                           plan.sheet.at(butt - kButtRadius * right),
                                           plan.sheet.at(butt + kButtRadius * right)},
                                          true)}});
    plan.svg.leaf("path", {{"class", "line"},
                           {"stroke-width", svg_number(plan.sheet.length(0.004) + 0.2)},
                           {"d", svg_path({plan.sheet.at(tip + kTipRadius * right),
                                           plan.sheet.at(tip - kTipRadius * right)},
                                          false)}});
    plan.svg.close();
    for (int i = 0; i <= 12; ++i) {
        const Vec2 on = plan.sheet.at(tip + (butt - tip) * (i / 12.0));
        plan.labels.keep_free({on - Vec2(0.8), on + Vec2(0.8)}, 0.5);
    }
}

void draw_badge(SvgText& svg, int number, const Vec2& centre) {
    svg.leaf("circle", {{"class", "badge"},
                        {"cx", svg_number(centre.x)},
                        {"cy", svg_number(centre.y)},
                        {"r", svg_number(kBadge)}});
    svg.text(
        "text", fmt::format("{}", number),
        {{"class", "number"}, {"x", svg_number(centre.x)}, {"y", svg_number(centre.y + 0.76)}});
}

void draw_number(PlanDrawing& plan, const NumberedEvent& event) {
    const Vec2 place = plan.sheet.at(event.place);
    const double label = event.label.empty() ? 0 : text_width(event.label, kSmall) + 0.8;
    const Vec2 size(2 * kBadge + label, 2 * kBadge);
    const Vec2 corner = plan.labels.place(place, size, 2.4);
    const Vec2 badge = corner + Vec2(kBadge);
    const Vec2 nearest(std::clamp(place.x, corner.x, corner.x + size.x),
                       std::clamp(place.y, corner.y, corner.y + size.y));
    plan.svg.open("g");
    plan.svg.text("title", time_text(event.time) + ": " + event.text);
    plan.svg.leaf("path", {{"class", "fine"}, {"d", svg_path({place, nearest}, false)}});
    draw_badge(plan.svg, event.number, badge);
    if (label > 0) {
        const SvgText::Attributes at{{"x", svg_number(badge.x + kBadge + 0.6)},
                                     {"y", svg_number(badge.y + 0.8)}};
        SvgText::Attributes halo = at;
        halo.insert(halo.end(), {{"class", "small halo"},
                                 {"stroke-width", "0.9"},
                                 {"stroke-linejoin", "round"},
                                 {"style", "fill:none"}});
        SvgText::Attributes ink = at;
        ink.emplace_back("class", "small");
        plan.svg.text("text", event.label, halo);
        plan.svg.text("text", event.label, ink);
    }
    plan.svg.close();
}

/// A sentence about the impacts that the list omits; empty if it has all of them.
std::string without_number_text(const NumberedEvents& events) {
    const int count = events.slow + events.left_out;
    if (count == 0) {
        return {};
    }
    std::string text = fmt::format("{}{}", count, count == 1 ? " impact" : " impacts");
    if (events.left_out == 0) {
        text += " below " + speed_text(kMinNumberedSpeed);
    } else {
        text += ", the gentlest,";
    }
    return text + (count == 1 ? " has no number; 'carom report' has it."
                              : " have no number; 'carom report' has them all.");
}

}  // namespace

double text_width(const std::string& text, double font_size) {
    // In these sentences letters of DejaVu Sans are 0.56 em wide on average. Continuation bytes of
    // UTF-8 (10xxxxxx) are not counted.
    const auto letters = std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    });
    return 0.56 * font_size * static_cast<double>(letters);
}

std::string fitted_text(const std::string& text, double font_size, double width) {
    std::string shorter = text;
    while (!shorter.empty() && text_width(shorter + "…", font_size) > width) {
        do {
            shorter.pop_back();
        } while (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0x80U) != 0);
    }
    return text_width(text, font_size) <= width ? text : shorter + "…";
}

void draw_sticks(PlanDrawing& plan) {
    plan.svg.open("g", {{"id", "sticks"}});
    for (const sim::Event& event : plan.timeline.events) {
        if (event.kind == sim::EventKind::strike) {
            draw_stick(plan, event);
        }
    }
    plan.svg.close();
}

void draw_event_numbers(PlanDrawing& plan) {
    plan.svg.open("g", {{"id", "events"}});
    for (const NumberedEvent& event : plan.events.events) {
        draw_number(plan, event);
    }
    plan.svg.close();
}

double draw_event_list(PlanDrawing& plan, double y) {
    const auto& events = plan.events.events;
    const double width = kPageWidth - 2 * kMargin;
    double widest = 0;
    for (const NumberedEvent& event : events) {
        widest = std::max(widest, text_width(event.text, kText));
    }
    constexpr double kBefore = 22;  // number and time, mm
    const int columns = 3 * (widest + kBefore + 4) <= width                         ? 3
                        : 2 * (widest + kBefore + 4) <= width || events.size() > 10 ? 2
                                                                                    : 1;
    const int rows = (static_cast<int>(events.size()) + columns - 1) / columns;
    const double column_width = width / columns;
    plan.svg.open("g", {{"id", "list"}});
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::size_t column = i / static_cast<std::size_t>(rows);
        const std::size_t row = i % static_cast<std::size_t>(rows);
        const double x = kMargin + column_width * static_cast<double>(column);
        const double line = y + kLine * (static_cast<double>(row) + 0.5);
        draw_badge(plan.svg, events[i].number, {x + kBadge, line});
        plan.svg.text("text", time_text(events[i].time),
                      {{"class", "end faint"},
                       {"x", svg_number(x + kBefore - 2)},
                       {"y", svg_number(line + 0.95)}});
        plan.svg.text("text", fitted_text(events[i].text, kText, column_width - kBefore - 2),
                      {{"x", svg_number(x + kBefore)}, {"y", svg_number(line + 0.95)}});
    }
    double bottom = y + kLine * rows;
    if (const std::string text = without_number_text(plan.events); !text.empty()) {
        bottom += kLine;
        plan.svg.text(
            "text", text,
            {{"class", "faint"}, {"x", svg_number(kMargin)}, {"y", svg_number(bottom - 1)}});
    }
    plan.svg.close();
    return bottom;
}

}  // namespace carom::pipeline
