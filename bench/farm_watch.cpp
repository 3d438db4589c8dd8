#include "bench/farm_watch.h"

#include <algorithm>

namespace carom::bench {
namespace {

/// How often a worker draws a frame until it has found enough claims.
constexpr int kDraws = 64;

}  // namespace

bool ClaimWatch::has(int frame) const {
    return std::any_of(watches_.begin(), watches_.end(),
                       [frame](const Watch& watch) { return watch.frame == frame; });
}

void ClaimWatch::fill(const FarmFrames& frames, int wanted, SplitMix64& random, double now) {
    const auto has_ended = [&frames](const Watch& watch) {
        return frames[watch.frame].state != FrameState::claimed;
    };
    watches_.erase(std::remove_if(watches_.begin(), watches_.end(), has_ended), watches_.end());
    for (int draw = 0; draw < kDraws && count() < wanted; ++draw) {
        const int frame = static_cast<int>(random.next_unit() * frames.count());
        if (frames[frame].state == FrameState::claimed && !has(frame)) {
            watches_.push_back({frame, frames[frame].last_change, now});
        }
    }
}

int ClaimWatch::read(const FarmFrames& frames, double expiry, double now) {
    for (Watch& watch : watches_) {
        const FarmFrame& frame = frames[watch.frame];
        if (frame.last_change != watch.last_change) {
            watch.last_change = frame.last_change;
            watch.since = now;
        } else if (frame.state == FrameState::claimed && now - watch.since > expiry) {
            return watch.frame;
        }
    }
    return -1;
}

int dead_claim(const FarmFrames& frames, double waiting_since, double expiry, double now) {
    const int frame = frames.stalest_claim();
    if (frame < 0) {
        return -1;
    }
    const double since = std::max(waiting_since, frames[frame].last_change);
    return now - since > expiry ? frame : -1;
}

}  // namespace carom::bench
