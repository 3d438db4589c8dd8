// Variants of a shot, simulated for their outcome alone.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

/// What comes of a variant.
struct Outcome {
    double end_time = 0;      // s
    bool is_stopped = false;  // at `end_time`, because its question was answered
    std::vector<Event> events;
    std::vector<MotionState> states;  // of the moving bodies then, as Trials::names() lists them
    std::vector<Diagnostic> warnings;
    std::optional<Timeline> motion;  // if wanted: also tracks, energies and lasting contacts
};

/// How far a trial goes.
struct TrialLimits {
    /// Sees each event when it is logged; true ends the trial. A flight of less than 10 ms is seen,
    /// but may turn out not to have happened.
    std::function<bool(const Event&)> is_answered;
    std::uint64_t max_steps = ~std::uint64_t{0};  // counted as in bake_within
    bool keeps_motion = false;                    // which takes longer
    std::stop_token stop;
};

/// Shares between all variants of a shot what is equal in them: its table, meshes and checks.
class Trials {
  public:
    /// `world`: with any events. Throws Error if it has problems.
    explicit Trials(WorldDescription world);
    ~Trials();
    Trials(const Trials&) = delete;
    Trials& operator=(const Trials&) = delete;

    [[nodiscard]] const WorldDescription& world() const;
    /// The bodies that move, not by keys, in the world's order.
    [[nodiscard]] const std::vector<std::string>& names() const;

    /// The outcome of the world with these events instead of its own: events, and states where it
    /// was not stopped, have the bits that `bake` gives them. Empty if it takes more steps than
    /// allowed. Throws Error if the events have problems, Stopped if a stop is requested. Any
    /// number of threads may call it at once.
    [[nodiscard]] std::optional<Outcome> run(std::vector<ForceEvent> events,
                                             const TrialLimits& limits = {}) const;

  private:
    struct Shared;
    std::unique_ptr<const Shared> shared_;
};

}  // namespace carom::sim
