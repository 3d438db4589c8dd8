#include "pipeline/studio/motion_messages.h"

#include <algorithm>
#include <cstdint>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/studio/triple.h"

namespace carom::studio {

namespace {

constexpr std::size_t kMostEnergySamples = 500;
constexpr std::int64_t kMostFrames = 20'000;

void append(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

void append(std::vector<double>& numbers, const sim::Key& key) {
    numbers.push_back(key.time);
    append(numbers, key.position);
    numbers.push_back(key.orientation.r);
    append(numbers, key.orientation.v);
    append(numbers, key.velocity_in);
    append(numbers, key.velocity_out);
    append(numbers, key.angular_velocity_in);
    append(numbers, key.angular_velocity_out);
}

TimelineEvent event_message(const sim::Event& event) {
    TimelineEvent message;
    message.kind = to_string(event.kind);
    message.time = event.time;
    message.end_time = event.end_time;
    message.a = event.a;
    message.b = event.b;
    message.place = triple(event.place);
    message.impulse = event.normal_impulse;
    message.text = phrase_of(event);
    return message;
}

std::vector<double> thinned_energy(const std::vector<sim::EnergySample>& samples) {
    std::vector<double> numbers;
    const std::size_t step = samples.size() / kMostEnergySamples + 1;
    for (std::size_t i = 0; i < samples.size(); i += step) {
        const sim::EnergySample& sample = samples[i];
        numbers.insert(numbers.end(), {sample.time, sample.kinetic, sample.potential});
    }
    return numbers;
}

double middle(double a, double b) {
    return a == b ? a : (a + b) / 2;
}

Vec3 middle(const Vec3& a, const Vec3& b) {
    return {middle(a.x, b.x), middle(a.y, b.y), middle(a.z, b.z)};
}

void append(std::vector<double>& numbers, const pipeline::PlannedFrame& frame, double camera) {
    const render::CameraState& open = frame.camera_open;
    const render::CameraState& close = frame.camera_close;
    numbers.insert(numbers.end(),
                   {static_cast<double>(frame.number), camera, frame.weight, frame.video_time,
                    frame.scene_time, frame.scene_open, frame.scene_close, frame.speed});
    append(numbers, middle(open.position, close.position));
    append(numbers, middle(open.target, close.target));
    append(numbers, middle(open.up, close.up));
    numbers.insert(numbers.end(),
                   {middle(open.roll, close.roll), middle(open.vertical_fov, close.vertical_fov),
                    middle(open.focus_distance, close.focus_distance),
                    middle(open.lens_radius, close.lens_radius)});
}

}  // namespace

std::string phrase_of(const sim::Event& event) {
    using enum sim::EventKind;
    const std::string& a = event.a;
    switch (event.kind) {
        case impact:
            return a + " hits " + event.b;
        case sliding:
            return a + " slides";
        case rolling:
            return a + " rolls";
        case spinning:
            return a + " spins in place";
        case resting:
            return a + " comes to rest";
        case airborne:
            return a + " leaves the ground";
        case potted:
            return a + " is potted in " + event.b;
        case off_table:
            return a + " leaves the table";
        case force:
            return "a force acts on " + a;
        case torque:
            return "a torque acts on " + a;
        case impulse:
            return "an impulse acts on " + a;
        case velocity:
            return a + " gets a velocity";
        case placed:
            return a + " is put down" + (event.b.empty() ? "" : " on the " + event.b + " spot");
        case removed:
            return a + " is taken off the table";
        case strike:
            break;
    }
    return "the stick strikes " + a;
}

Numbers<TimelineHead> timeline_message(const sim::Timeline& timeline) {
    Numbers<TimelineHead> message;
    message.head.start = timeline.start_time;
    message.head.end = timeline.end_time;
    for (const sim::Track& track : timeline.tracks) {
        message.head.tracks.push_back({track.name(),
                                       static_cast<std::int64_t>(message.numbers.size()),
                                       static_cast<std::int64_t>(track.keys().size())});
        for (const sim::Key& key : track.keys()) {
            append(message.numbers, key);
        }
    }
    for (const sim::Event& event : timeline.events) {
        message.head.events.push_back(event_message(event));
    }
    message.head.energy = thinned_energy(timeline.energy);
    return message;
}

Numbers<CamerasHead> cameras_message(const pipeline::Shot& shot, const sim::Timeline& timeline) {
    Numbers<CamerasHead> message;
    std::vector<pipeline::CameraRig> rigs;
    try {
        rigs = pipeline::with_fitted_paths(shot.cameras, timeline);
    } catch (const Error&) {  // an object is not in the timeline
        return message;
    }
    const std::int64_t frames = pipeline::frame_count(rigs, shot.timing);
    const std::int64_t step = frames / kMostFrames + 1;
    for (std::int64_t i = 0; i < frames; i += step) {
        try {
            for (const pipeline::PlannedFrame& frame :
                 pipeline::plan_mixed_frame(i, rigs, shot.timing, timeline)) {
                const auto rig = std::ranges::find(rigs, frame.rig, &pipeline::CameraRig::name);
                append(message.numbers, frame, static_cast<double>(rig - rigs.begin()));
                ++message.head.entries;
            }
        } catch (const Error&) {  // no valid view, which the problems say
            continue;
        }
    }
    return message;
}

}  // namespace carom::studio
