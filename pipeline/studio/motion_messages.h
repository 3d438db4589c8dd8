// The motion of a shot and the views of its cameras as binary messages.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The head, and the numbers of the payload.
template <class Head>
struct Numbers {
    Head head;
    std::vector<double> numbers;
};

/// The tracks, the events and the energy of a timeline.
[[nodiscard]] Numbers<TimelineHead> timeline_message(const sim::Timeline& timeline);

/// The cameras of all frames of the film. `timeline`: with the shot's keyed motions.
[[nodiscard]] Numbers<CamerasHead> cameras_message(const pipeline::Shot& shot,
                                                   const sim::Timeline& timeline);

/// What happens in an event, in a few words: "cue hits one".
[[nodiscard]] std::string phrase_of(const sim::Event& event);

}  // namespace carom::studio
