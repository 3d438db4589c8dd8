// The fields of what the server says of the film's sound, in the order in which they are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/sound_messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<SoundState>) {
    return fields<SoundState>(
        field("v", &SoundState::v), field("reason", &SoundState::reason),
        field("address", &SoundState::address), field("rate", &SoundState::rate),
        field("samples", &SoundState::samples), field("piece", &SoundState::piece),
        field("ready", &SoundState::ready));
}

}  // namespace carom::studio
