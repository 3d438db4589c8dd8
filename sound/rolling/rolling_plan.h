// What a RollingSource is made from.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/vectors.h"
#include "sim/timeline/track.h"
#include "sound/rolling/ball_way.h"
#include "sound/rolling/stretches.h"
#include "sound/rolling/texture.h"

namespace carom::sound {

struct RollingPlan {
    std::string body;
    const sim::Track* track = nullptr;  // of the body; nullptr if it does not move
    Vec3 place{0, 0, 0};                // m, of a body without a track
    Texture texture;
    std::uint64_t seed = 0;
    std::vector<Stretch> stretches;  // in order of time, without overlaps
    /// The ways of one of the stretches, the whole of it.
    std::function<BallWays(const Stretch&)> ways;
};

}  // namespace carom::sound
