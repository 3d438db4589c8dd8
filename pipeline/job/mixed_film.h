// Mixes two pictures for a cross-fade.
#pragma once

#include "render/film/film.h"

namespace carom::pipeline {

/// Mixes `other`, which has the same size, into `film` in linear light: colours and coverage become
/// (1 - weight) * film + weight * other. Other channels, such as depth, cannot be mixed and remain
/// those of `film`.
void mix_in(const render::Film& other, double weight, render::Film& film);

}  // namespace carom::pipeline
