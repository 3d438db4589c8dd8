// Judges a strike of the shot: its window, its chance and a map of what others around it do.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/sought_strike.h"
#include "sim/trials.h"

namespace carom::studio {

struct JudgedStrike {
    std::shared_ptr<const sim::Trials> trials;  // of the world of `sought`
    const SoughtStrike& sought;
    const sim::Timeline& timeline;  // of the shot
    const Judge& question;
    std::int64_t v = 0;  // of the shot
};

/// Tells what the strike pots, within which directions and how likely, then, if that is wanted, the
/// maps of others like it. A shot whose trials take long is not judged. Throws Stopped if a stop is
/// requested, after an answer without pots if there was none yet.
void judge_strike(const JudgedStrike& job, const std::stop_token& stop,
                  const std::function<void(const ServerMessage&)>& tell);

}  // namespace carom::studio
