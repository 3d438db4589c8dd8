// From a dense series of states to a track of as few keys as the error bound allows.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::sim {

/// How far the interpolated path may be from any recorded state.
struct KeyReduction {
    double position_error = 2e-6;                   // m, > 0
    double orientation_error = 1.7453292519943e-4;  // rad (0.01 degree), > 0
};

/// Takes states in order of time. Keys added by `add` may be dropped; `add_break` keys never are,
/// nor are the first and the last. Throws Error, naming the track, for times out of order and for
/// two states of one instant that differ.
class TrackRecorder {
  public:
    explicit TrackRecorder(std::string name, KeyReduction reduction = {});

    /// A state on a smooth segment. A state at the time of the last one replaces nothing and must
    /// equal it (within 1e-9): callers may add a segment's end and the next one's beginning.
    void add(double time, const MotionState& state);

    /// Something happened in an instant: the pose is one, the velocities jump from `before` to
    /// `after`. If the last key is at the same time, its incoming velocities are kept and its
    /// outgoing ones replaced (several impacts in one instant).
    void add_break(double time, const MotionState& before, const MotionState& after);

    /// The reduced track; the recorder is spent.
    [[nodiscard]] Track finish();

  private:
    void add_key(const Key& key, bool is_kept);

    std::string name_;
    KeyReduction reduction_;
    std::vector<Key> dense_;
    std::vector<std::size_t> kept_;  // indices into dense_, increasing
};

}  // namespace carom::sim
