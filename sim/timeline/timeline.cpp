#include "sim/timeline/timeline.h"

#include <algorithm>

namespace carom::sim {

const Track* Timeline::find(std::string_view name) const {
    const auto found = std::find_if(tracks.begin(), tracks.end(),
                                    [&](const Track& track) { return track.name() == name; });
    return found == tracks.end() ? nullptr : &*found;
}

}  // namespace carom::sim
