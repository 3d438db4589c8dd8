// Rooms for tests.
#pragma once

#include <algorithm>
#include <string_view>

#include "sound/space/room.h"

namespace carom::sound {

/// The room of a name that there is.
inline RoomSettings room_named(std::string_view name) {
    return std::ranges::find(rooms(), name, &NamedRoom::name)->room;
}

}  // namespace carom::sound
