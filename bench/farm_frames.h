// The frames of a simulated farm's film and the claims of its workers, as the store shows them.
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace carom::bench {

enum class FrameState { open, claimed, done };

struct FarmFrame {
    FrameState state = FrameState::open;
    int owner = -1;             // the worker whose claim it is
    double last_change = 0;     // of the claim's counter
    double work_left = 1;       // less than 1 after a handover
    int claims = 0;             // so far
    double rendered_since = 0;  // by the latest worker that began
};

class FarmFrames {
  public:
    explicit FarmFrames(int count);

    [[nodiscard]] const FarmFrame& operator[](int number) const {
        return frames_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] int count() const { return static_cast<int>(frames_.size()); }
    [[nodiscard]] int unfinished() const { return count() - done_; }
    /// The frames in the order in which workers want them.
    [[nodiscard]] const std::vector<int>& order() const { return order_; }

    /// The worker has the claim from now on, whoever had it before.
    void claim(int number, int worker, double now);
    /// The worker changes its counter. Nothing happens if the claim is no longer its own.
    void beat(int number, int worker, double now);
    void finish(int number);
    /// The worker removes its claim, and `part` of the work that was left is stored.
    void hand_over(int number, int worker, double part);
    /// Another worker begins to render the frame, too.
    void start_backup(int number, double now) { at(number).rendered_since = now; }

    /// The first open frame in the order, or -1.
    [[nodiscard]] int first_open() const;
    [[nodiscard]] std::vector<int> all_open() const;
    /// The frame whose counter has not changed for longest, or -1 if nothing is claimed.
    [[nodiscard]] int stalest_claim() const;
    /// A claimed frame that no worker began to render since `time`, or -1.
    [[nodiscard]] int not_begun_since(double time) const;

  private:
    FarmFrame& at(int number) { return frames_[static_cast<std::size_t>(number)]; }

    std::vector<FarmFrame> frames_;
    std::vector<int> order_;
    std::set<std::pair<double, int>> claims_;  // last change and frame
    int done_ = 0;
};

/// The numbers 0 to `count` - 1 in the order of their reversed bits.
[[nodiscard]] std::vector<int> bit_reversed_order(int count);

}  // namespace carom::bench
