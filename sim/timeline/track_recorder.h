// Reduces a dense series of states to a track with as few keys as the error bound allows.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::sim {

/// The largest deviation of the interpolated path from any recorded state.
struct KeyReduction {
    double position_error = 2e-6;                   // m, > 0
    double orientation_error = 1.7453292519943e-4;  // rad (0.01 degree), > 0
};

/// Takes states in order of time and drops keys as soon as it can, so that it never holds more than
/// a few thousand states besides the keys of the track. Keys added by `add` may be dropped; those
/// of `add_break` and `add_jump`, the first and the last are kept, except within trains of tiny
/// breaks (two balls that press against each other part and meet again thousands of times a
/// second), of which one in a millisecond is kept. Throws an Error that names the track if times
/// are out of order or two states of one instant differ.
class TrackRecorder {
  public:
    explicit TrackRecorder(std::string name, KeyReduction reduction = {});

    /// Adds a state on a smooth segment. A state at the time of the last one must equal it (within
    /// 1e-9) and is ignored: callers may add the end of a segment and the beginning of the next
    /// one.
    void add(double time, const MotionState& state);

    /// Adds an instantaneous change: the pose is continuous, the velocities jump from `before` to
    /// `after`. If the last key is at the same time, its incoming velocities are kept and its
    /// outgoing ones are replaced (several impacts in one instant).
    void add_break(double time, const MotionState& before, const MotionState& after);

    /// The object is put somewhere else at once: the position and the velocities jump from `before`
    /// to `after`, the orientation does not. Adds a key at `time` and one at the next number, or
    /// both one later if the track already jumped at `time`. Returns the time of the second key;
    /// states that follow must not be earlier.
    double add_jump(double time, const MotionState& before, const MotionState& after);

    /// The reduced track; the recorder cannot be used afterwards.
    [[nodiscard]] Track finish();

  private:
    void add_key(const Key& key, bool is_kept);
    void keep_last();
    [[nodiscard]] bool is_last_kept() const;
    void reduce(std::size_t open);
    void advance(std::size_t step);
    [[nodiscard]] bool can_skip(std::size_t step) const;
    [[nodiscard]] bool is_in_train(double time, const MotionState& before,
                                   const MotionState& after);

    std::string name_;
    KeyReduction reduction_;
    std::vector<Key> keys_;         // those of the track so far
    std::vector<Key> dense_;        // the states from the last one of these on
    std::deque<std::size_t> kept_;  // indices of dense_ that have to be keys, increasing, > 0
    std::size_t good_ = 1;          // so many states can be skipped at once
    double kept_time_ = 0;          // of the last state that has to be a key
    bool was_tiny_ = false;         // the last break was tiny, or belongs to a train
};

}  // namespace carom::sim
