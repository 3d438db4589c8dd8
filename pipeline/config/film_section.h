// The section `film` of a file that makes one film of several shots.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "pipeline/camera/rational.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline {

/// A title between shots.
struct TitleCard {
    std::string text;
    std::string subtitle;
    Vec3 colour{1, 1, 1};                 // linear, of the letters
    Vec3 background{0.006, 0.008, 0.01};  // linear
};

namespace config {

/// A shot, or a title card, of which exactly one is given.
struct FilmPartSection {
    std::optional<std::string> shot;     // as written
    std::vector<std::string> overrides;  // "render.samples=64"
    std::optional<Rational> from, to;    // times of the shot's own film, s
    std::optional<TitleCard> title;
    Rational length{3};  // of a title card, s
    Rational fade;       // s
    Place place;
    Place shot_place;
};

struct FilmSection {
    std::optional<std::array<int, 2>> size;
    std::optional<Rational> fps;
    std::vector<FilmPartSection> parts;
    Place place;
};

}  // namespace config
}  // namespace carom::pipeline
