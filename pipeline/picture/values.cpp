#include "pipeline/picture/values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include "core/elementary.h"
#include "pipeline/picture/track_line.h"

namespace carom::pipeline {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kResting = 1e-3;  // m/s
constexpr const char* kNone = "–";

/// A value and the format in which it is usually written.
struct Number {
    double value = 0;
    const char* usual = ".2f";
};

Number frame_value(const std::string& name, const FrameMoment& moment) {
    if (name == "frame") {
        return {static_cast<double>(moment.number), ".0f"};
    }
    if (name == "video_time") {
        return {moment.video_time, ".3f"};
    }
    if (name == "scene_time") {
        return {moment.scene_time, ".3f"};
    }
    return {moment.playback_speed, ".3g"};
}

/// The direction of a level velocity, counter-clockwise from +x, degrees in [0, 360).
std::optional<double> direction_of(const Vec3& velocity) {
    if (velocity.x * velocity.x + velocity.y * velocity.y < kResting * kResting) {
        return std::nullopt;
    }
    const double angle = arctangent2(velocity.y, velocity.x) * kDegrees;
    return angle < 0 ? angle + 360 : angle;
}

std::optional<Number> object_value(const ObjectValue& value, const FrameMoment& moment,
                                   const sim::Timeline& timeline) {
    const sim::Track* track = timeline.find(value.object);
    if (track == nullptr) {
        return std::nullopt;
    }
    const MotionState state = track->sample(moment.scene_time);
    if (value.name == "speed") {
        return Number{state.velocity.length(), ".2f"};
    }
    if (value.name == "spin") {
        return Number{state.angular_velocity.length(), ".1f"};
    }
    if (value.name == "distance") {
        return Number{distance_gone(*track, timeline.start_time, moment.scene_time), ".2f"};
    }
    if (value.name == "direction") {
        const std::optional<double> direction = direction_of(state.velocity);
        return direction ? std::optional(Number{*direction, ".0f"}) : std::nullopt;
    }
    return Number{value.name == "x"   ? state.position.x
                  : value.name == "y" ? state.position.y
                                      : state.position.z,
                  ".3f"};
}

std::optional<Number> pair_value(const PairValue& value, const FrameMoment& moment,
                                 const sim::Timeline& timeline) {
    const sim::Track* first = timeline.find(value.first);
    const sim::Track* second = timeline.find(value.second);
    if (first == nullptr || second == nullptr) {
        return std::nullopt;
    }
    const MotionState a = first->sample(moment.scene_time);
    const MotionState b = second->sample(moment.scene_time);
    if (value.name == "distance") {
        return Number{(a.position - b.position).length(), ".3f"};
    }
    const std::optional<double> from = direction_of(a.velocity);
    const std::optional<double> to = direction_of(b.velocity);
    if (!from || !to) {
        return std::nullopt;
    }
    const double turn = std::abs(*from - *to);
    return Number{std::min(turn, 360 - turn), ".0f"};
}

std::string text_of(const TextValue& value, const FrameMoment& moment,
                    const sim::Timeline& timeline) {
    std::optional<Number> number;
    if (const auto* frame = std::get_if<FrameValue>(&value.name)) {
        number = frame_value(frame->name, moment);
    } else if (const auto* object = std::get_if<ObjectValue>(&value.name)) {
        number = object_value(*object, moment, timeline);
    } else {
        number = pair_value(std::get<PairValue>(value.name), moment, timeline);
    }
    return number ? number_text(number->value, value.format, number->usual) : kNone;
}

}  // namespace

double distance_gone(const sim::Track& track, double start, double scene_time) {
    double distance = 0;
    const std::vector<LinePoint> line = track_line(track, start, std::max(start, scene_time));
    for (std::size_t i = 1; i < line.size(); ++i) {
        distance += (line[i].position - line[i - 1].position).length();
    }
    return distance;
}

std::string number_text(double value, const std::string& format, const std::string& usual) {
    const std::string& chosen = format.empty() ? usual : format;
    std::string text = fmt::format(fmt::runtime("{:" + chosen + "}"), value);
    const bool is_zero = std::ranges::none_of(text, [](char c) { return c >= '1' && c <= '9'; });
    if (std::signbit(value) && is_zero) {
        text = fmt::format(fmt::runtime("{:" + chosen + "}"), 0.0);
    }
    return text;
}

std::string text_with_values(std::span<const TextPiece> pieces, const FrameMoment& moment,
                             const sim::Timeline& timeline) {
    std::string text;
    for (const TextPiece& piece : pieces) {
        if (const auto* words = std::get_if<std::string>(&piece)) {
            text += *words;
        } else {
            text += text_of(std::get<TextValue>(piece), moment, timeline);
        }
    }
    return text;
}

}  // namespace carom::pipeline
