// Puts balls down on the table and takes them off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostic.h"
#include "sim/billiards/free_place.h"
#include "sim/scheduler/bodies.h"
#include "sim/scheduler/recorder.h"

namespace carom::sim {

/// Carries out the events that put a ball somewhere. One whose place is occupied waits: the place
/// is looked at again at the start of every window, at least 60 times per second. A later event for
/// the same ball ends the wait. Call it between two steps of ODE only.
class BallPlacer {
  public:
    BallPlacer(const WorldDescription& world, Bodies& bodies, Recorder& recorder)
        : world_(world), bodies_(bodies), recorder_(recorder) {}

    /// Event `event` of the world puts the ball down, now or later.
    void place(std::size_t event, std::uint32_t ball, double time);
    /// The event takes the ball off the table.
    void remove(std::size_t event, std::uint32_t ball, double time);
    [[nodiscard]] bool has_waiting() const { return !waiting_.empty(); }
    /// Whether a waiting ball can be put down now.
    [[nodiscard]] bool can_place_waiting(double time) const;
    /// The events that have been carried out since the last call.
    [[nodiscard]] std::vector<std::size_t> take_done() { return std::exchange(done_, {}); }
    /// Puts down the waiting balls whose places are free now, in the order in which they began to
    /// wait.
    void place_waiting(double time);

    /// The name of the ball or object that moves or rests where the ball would lie; empty if none.
    [[nodiscard]] std::string obstacle(std::uint32_t ball, const Vec2& place, double time) const;
    /// Puts the ball down at `place`, which has to be free.
    void put_down(std::uint32_t ball, const Vec2& place, const std::string& spot, double time);

    /// One warning for each event that still waits, or ended its wait without success.
    [[nodiscard]] std::vector<Diagnostic> never_placed(double time) const;

  private:
    struct Waiting {
        std::size_t event = 0;
        std::uint32_t ball = 0;
    };

    [[nodiscard]] const PlaceBall& action_of(std::size_t event) const;
    [[nodiscard]] bool try_place(const Waiting& waiting, double time);
    [[nodiscard]] std::optional<billiards::FreePlace> find_place(const Waiting& waiting,
                                                                 double time) const;
    [[nodiscard]] billiards::FreePlaces lying_balls(std::uint32_t except, double time) const;
    [[nodiscard]] Vec3 hidden_place(std::uint32_t ball) const;
    void end_wait(std::uint32_t ball, std::size_t by_event);
    [[nodiscard]] std::string never_happened(std::size_t event, const std::string& why) const;

    const WorldDescription& world_;
    Bodies& bodies_;
    Recorder& recorder_;
    std::vector<Waiting> waiting_;
    std::vector<std::size_t> done_;
    std::vector<Diagnostic> given_up_;
};

}  // namespace carom::sim
