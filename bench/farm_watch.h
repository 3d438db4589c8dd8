// How a waiting worker of a simulated farm finds out that a claim is dead: it has seen no change of
// the claim's counter for some time by its own clock.
#pragma once

#include <vector>

#include "bench/farm_frames.h"
#include "core/splitmix.h"

namespace carom::bench {

/// A few claims that the worker reads at each poll.
class ClaimWatch {
  public:
    /// Replaces the claims that ended by others, chosen at random.
    void fill(const FarmFrames& frames, int wanted, SplitMix64& random, double now);
    /// Reads the counters. Returns the frame of a claim that is dead, or -1.
    int read(const FarmFrames& frames, double expiry, double now);
    [[nodiscard]] int count() const { return static_cast<int>(watches_.size()); }

  private:
    struct Watch {
        int frame = 0;
        double last_change = 0;
        double since = 0;  // the worker has seen no change
    };

    [[nodiscard]] bool has(int frame) const;

    std::vector<Watch> watches_;
};

/// The same for a worker that reads every claim at each poll since `waiting_since`: it has seen
/// each change, and all that it must not count is the time before it began.
[[nodiscard]] int dead_claim(const FarmFrames& frames, double waiting_since, double expiry,
                             double now);

}  // namespace carom::bench
