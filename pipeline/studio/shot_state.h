// What the page draws and edits of a shot.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The whole state but for its version. `timeline`: of the shot, with its keyed motions; without
/// tracks while there is none. `root`: the folder below which files are written.
[[nodiscard]] ShotState shot_state(const pipeline::Shot& shot, const pipeline::ShotSource& source,
                                   const sim::Timeline& timeline, const std::string& root);

/// The parts of the state.
[[nodiscard]] std::vector<SceneObject> object_messages(const pipeline::Shot& shot,
                                                       const pipeline::ShotSource& source,
                                                       const sim::Timeline& timeline);
[[nodiscard]] std::vector<SceneLight> light_messages(const pipeline::Shot& shot);
[[nodiscard]] std::vector<ShotEvent> event_messages(const pipeline::Shot& shot,
                                                    const sim::Timeline& timeline);
[[nodiscard]] std::vector<ShotAnnotation> annotation_messages(const pipeline::Shot& shot,
                                                              const sim::Timeline& timeline);

}  // namespace carom::studio
