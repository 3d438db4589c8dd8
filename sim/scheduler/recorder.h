// What a simulation writes down: tracks, events, energy, warnings.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "sim/impact/ball_impact.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

class Recording {
  public:
    explicit Recording(const WorldDescription& world);

    /// The state of moving body `track` at one instant, kept as a key.
    void keep(std::size_t track, double time, const MotionState& state);
    /// A state on a smooth segment, dropped if its neighbours give it.
    void add(std::size_t track, double time, const MotionState& state);
    void add_break(std::size_t track, double time, const MotionState& before,
                   const MotionState& after);

    /// `place`: the point of contact; `normal` from b towards a.
    void log_impact(double time, const std::string& a, const std::string& b, const Vec3& place,
                    const Vec3& normal, const ImpulsePair& impulse);
    void log(EventKind kind, double time, const std::string& a, const Vec3& place,
             const std::string& b = {});
    void log_action(EventKind kind, double time, double end_time, const std::string& a,
                    const Vec3& place, const Vec3& vector);
    /// The event turned out not to have happened: the timeline will be without it.
    void retract(std::size_t event) { retracted_.insert(event); }
    void add_energy(const EnergySample& sample);
    void warn(Diagnostic warning);

    [[nodiscard]] const std::vector<Event>& events() const { return events_; }
    [[nodiscard]] Timeline take_timeline(double end_time);

  private:
    /// A ball that is put back on its ground moves by a few micrometres at most; a key that is
    /// already written at that instant keeps its pose.
    [[nodiscard]] MotionState aligned(std::size_t track, double time, const MotionState& state);

    struct Written {
        double time = -1;
        Pose pose;
    };
    std::vector<TrackRecorder> recorders_;
    std::vector<Written> last_;
    std::vector<Event> events_;
    std::set<std::size_t> retracted_;
    std::vector<EnergySample> energy_;
    std::vector<Diagnostic> warnings_;
};

}  // namespace carom::sim
