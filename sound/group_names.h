// The names of the groups of sounds, in shots and of files.
#pragma once

#include <array>
#include <string_view>

#include "sound/sound_scene.h"

namespace carom::sound {

/// By Group.
inline constexpr std::array<std::string_view, kGroupCount> kGroupNames{
    "balls", "cushions", "cloth", "stick", "pockets", "objects", "rolling"};

}  // namespace carom::sound
