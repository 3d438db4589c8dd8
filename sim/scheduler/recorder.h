// Records the results of a simulation: tracks, events, energy and warnings.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/impact/ball_impact.h"
#include "sim/scheduler/contact_log.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

/// What is recorded.
enum class Record {
    all,
    outcome,  // events, warnings and the last states, without tracks, energy and contacts
};

class Recorder {
  public:
    Recorder(const WorldDescription& world, Record record);

    [[nodiscard]] bool keeps_all() const { return record_ == Record::all; }

    /// Adds a key to the track of moving body `track`.
    void add_key(std::size_t track, double time, const MotionState& state);
    /// Adds a state on a smooth segment; it is dropped if its neighbours already determine it.
    void add_sample(std::size_t track, double time, const MotionState& state);
    void add_break(std::size_t track, double time, const MotionState& before,
                   const MotionState& after);

    /// The ball is put down somewhere else, or taken off: its track jumps.
    void add_jump(std::size_t track, double time, const MotionState& before,
                  const MotionState& after);
    void add_put_back(PutBack put_back) { put_backs_.push_back(std::move(put_back)); }

    /// `place`: the point of contact; `normal`: from b towards a.
    void log_impact(double time, const std::string& a, const std::string& b, const Vec3& place,
                    const Vec3& normal, const ImpulsePair& impulse);
    void log(EventKind kind, double time, const std::string& a, const Vec3& place,
             const std::string& b = {});
    void log_action(EventKind kind, double time, double end_time, const std::string& a,
                    const Vec3& place, const Vec3& vector);
    /// `place`: the ball's centre; `velocity`: what the stick gave it, m/s; `impulse`: of the tip
    /// on the ball, N s.
    void log_strike(double time, const std::string& ball, const Vec3& place, const Vec3& velocity,
                    double impulse);
    /// Leaves a logged event out of the timeline: it turned out not to have happened.
    void retract(std::size_t event) { retracted_.insert(event); }
    void add_energy(const EnergySample& sample);
    void add_contact(const std::string& a, const std::string& b, const ContactLoad& load);
    void warn(Diagnostic warning);

    [[nodiscard]] const std::vector<Event>& events() const { return events_; }
    [[nodiscard]] Timeline take_timeline(double end_time);
    /// The last state of every track's body.
    [[nodiscard]] const std::vector<MotionState>& last_states() const { return last_states_; }

  private:
    Event& add_event(EventKind kind, double time, const std::string& a, const Vec3& place);

    /// A ball that is put back on its surface moves by a few micrometres at most. If a key has
    /// already been written at that instant, the state takes over its pose. Returns the track's
    /// last state, which this is now.
    const MotionState& note_state(std::size_t track, double time, const MotionState& state);

    /// The time of a state: at the instant of a jump, that of the key after it.
    [[nodiscard]] double key_time(std::size_t track, double time) const {
        return std::max(time, last_keys_[track].least_time);
    }

    [[nodiscard]] std::vector<Event> take_events();

    struct LastKey {
        double time = -1;
        double least_time = -1;  // the track's next state is not earlier: it jumped
    };
    Record record_;
    std::vector<TrackRecorder> track_recorders_;
    std::vector<LastKey> last_keys_;
    std::vector<MotionState> last_states_;
    std::vector<Event> events_;
    std::set<std::size_t> retracted_;
    ContactLog contacts_;
    std::vector<EnergySample> energy_;
    std::vector<PutBack> put_backs_;
    std::vector<Diagnostic> warnings_;
};

}  // namespace carom::sim
