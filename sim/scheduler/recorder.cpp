#include "sim/scheduler/recorder.h"

#include <algorithm>
#include <utility>

#include "sim/scheduler/lasting_states.h"

namespace carom::sim {

Recorder::Recorder(const WorldDescription& world, Record record) : record_(record) {
    for (const Body& body : world.bodies) {
        if (body.kind != BodyKind::dynamic) {
            continue;
        }
        last_states_.push_back(
            {body.pose.position, body.pose.orientation, body.velocity, body.angular_velocity});
        if (keeps_all()) {
            track_recorders_.emplace_back(body.name, world.key_reduction);
        }
    }
    last_keys_.resize(last_states_.size());
}

const MotionState& Recorder::note_state(std::size_t track, double time, const MotionState& state) {
    MotionState& last = last_states_[track];
    const Pose pose{last.position, last.orientation};
    last = state;
    if (last_keys_[track].time == time) {
        last.position = pose.position;
        last.orientation = pose.orientation;
    }
    last_keys_[track].time = time;
    return last;
}

void Recorder::add_key(std::size_t track, double time, const MotionState& state) {
    add_break(track, time, state, state);
}

void Recorder::add_sample(std::size_t track, double time, const MotionState& state) {
    time = key_time(track, time);
    const MotionState& last = note_state(track, time, state);
    if (keeps_all()) {
        track_recorders_[track].add(time, last);
    }
}

void Recorder::add_break(std::size_t track, double time, const MotionState& before,
                         const MotionState& after) {
    time = key_time(track, time);
    const MotionState from = note_state(track, time, before);
    const MotionState& to = note_state(track, time, after);
    if (keeps_all()) {
        track_recorders_[track].add_break(time, from, to);
    }
}

void Recorder::add_jump(std::size_t track, double time, const MotionState& before,
                        const MotionState& after) {
    time = key_time(track, time);
    const MotionState from = note_state(track, time, before);
    MotionState& to = last_states_[track];
    to = after;
    to.orientation = from.orientation;
    const double landed =
        keeps_all() ? track_recorders_[track].add_jump(time, from, to) : time_after_jump(time);
    last_keys_[track] = {landed, landed};
}

void Recorder::add_contact(const std::string& a, const std::string& b, const ContactLoad& load) {
    if (keeps_all()) {
        contacts_.add(a, b, load);
    }
}

Event& Recorder::add_event(EventKind kind, double time, const std::string& a, const Vec3& place) {
    Event& event = events_.emplace_back();
    event.kind = kind;
    event.time = event.end_time = time;
    event.a = a;
    event.place = place;
    return event;
}

void Recorder::log_impact(double time, const std::string& a, const std::string& b,
                          const Vec3& place, const Vec3& normal, const ImpulsePair& impulse) {
    Event& event = add_event(EventKind::impact, time, a, place);
    event.b = b;
    event.normal = normal;
    event.normal_impulse = impulse.normal;
    event.tangential_impulse = impulse.tangential;
}

void Recorder::log(EventKind kind, double time, const std::string& a, const Vec3& place,
                   const std::string& b) {
    add_event(kind, time, a, place).b = b;
}

void Recorder::log_action(EventKind kind, double time, double end_time, const std::string& a,
                          const Vec3& place, const Vec3& vector) {
    Event& event = add_event(kind, time, a, place);
    event.end_time = end_time;
    event.vector = vector;
}

void Recorder::log_strike(double time, const std::string& ball, const Vec3& place,
                          const Vec3& velocity, double impulse) {
    Event& event = add_event(EventKind::strike, time, ball, place);
    event.vector = velocity;
    event.normal_impulse = impulse;
}

void Recorder::add_energy(const EnergySample& sample) {
    if (!keeps_all() || (!energy_.empty() && energy_.back() == sample)) {
        return;
    }
    energy_.push_back(sample);
}

void Recorder::warn(Diagnostic warning) {
    constexpr std::size_t kMaxWarnings = 100;
    if (warnings_.size() >= kMaxWarnings) {
        return;
    }
    warning.severity = Severity::warning;
    warnings_.push_back(std::move(warning));
}

std::vector<Event> Recorder::take_events() {
    std::vector<Event> events;
    for (std::size_t i = 0; i < events_.size(); ++i) {
        if (!retracted_.contains(i)) {
            events.push_back(std::move(events_[i]));
        }
    }
    keep_lasting_states(events);
    return events;
}

Timeline Recorder::take_timeline(double end_time) {
    Timeline timeline;
    timeline.end_time = end_time;
    for (TrackRecorder& recorder : track_recorders_) {
        timeline.tracks.push_back(recorder.finish());
    }
    timeline.events = take_events();
    timeline.energy = std::move(energy_);
    timeline.lasting_contacts = contacts_.take();
    timeline.put_backs = std::move(put_backs_);
    timeline.warnings = std::move(warnings_);
    return timeline;
}

}  // namespace carom::sim
