// Contacts at the beginning of a shot that belong to its description, and not to what happens.
#pragma once

#include <vector>

#include "sound/sound_scene.h"

namespace carom::sound {

/// For each event of the shot's log, whether it is a contact of things that only settle: a body
/// that is described a little above what it rests on falls onto it, without anything that a film
/// would show. A body settles from the shot's beginning if it is at rest then, until it has moved
/// by kSettlingWay, something is done to it (a strike, a force), or something hits it that does not
/// settle. Its impacts with other such bodies, and with what never moves, are true here, unless
/// nothing has moved at all: then a log that was made by hand knows more than the tracks.
[[nodiscard]] std::vector<bool> settling_contacts(const SoundShot& shot);

/// How far any point of a body moves while it settles, m: about one pixel of a film.
inline constexpr double kSettlingWay = 0.002;

}  // namespace carom::sound
