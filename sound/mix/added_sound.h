// Another sound that is mixed with what is computed, such as music.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace carom::sound {

/// Fills the beginning of both spans, which have the same size, with the next samples in units of
/// full scale. Returns how many these are: at least one, except after the sound's end.
using SampleReader = std::function<std::size_t(std::span<double> left, std::span<double> right)>;

/// Begins the sound anew, with the film's first sample. It is called several times, because a film
/// is heard before its gain is known. Empty: there is no other sound.
using AddedSound = std::function<SampleReader()>;

}  // namespace carom::sound
