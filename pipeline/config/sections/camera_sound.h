// The keys about sound that a whole film and a single camera have in common.
#pragma once

#include "pipeline/config/map_spec.h"
#include "pipeline/shot/sound_settings.h"

namespace carom::pipeline::config {

/// Adds `listener`, `stereo`, `width`, `pitch`, `lowest`, `reverse`, `delay`, `dynamics` and `mix`,
/// with their defaults: they hold for all cameras that do not say otherwise.
void add_common_sound_keys(MapSpec<SoundSettings>& spec);

/// `none`, for a camera without sound (its gain is minus infinity), or a map of the same keys and
/// of `gain`, whose values replace those of the film.
[[nodiscard]] ValueType<CameraSound> camera_sound();

}  // namespace carom::pipeline::config
