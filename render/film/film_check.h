// What a film must be before it is written.
#pragma once

#include <string>

#include "render/film/film.h"

namespace carom::render {

/// Asserts that all channels have the film's size. Throws Error with the path if a value is
/// infinite or not a number.
void check_film(const Film& film, const std::string& path);

}  // namespace carom::render
