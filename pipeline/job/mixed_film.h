// Two pictures in one, for cross-fades.
#pragma once

#include "render/film/film.h"

namespace carom::pipeline {

/// Linear light: the colours and the coverage of `film` become its own times 1 - weight and those
/// of `other`, of the same size, times weight. What its further channels say of one place cannot be
/// mixed; they stay those of `film`.
void mix_in(const render::Film& other, double weight, render::Film& film);

}  // namespace carom::pipeline
