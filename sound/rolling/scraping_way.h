// The way of two surfaces past each other, from the lasting contacts of a timeline.
#pragma once

#include <span>

#include "sound/rolling/way.h"

namespace carom::sound {

/// A contact of nearly constant force and slip.
struct Scrape {
    double from = 0;   // scene time, s
    double to = 0;     // s, > `from`
    double force = 0;  // N, mean normal force
    double slip = 0;   // m/s, mean slip speed

    bool operator==(const Scrape&) const = default;
};

/// The way through scrapes that follow each other without gaps, and its pressures by
/// rolling_level.h. In the middle of each scrape, slip and force are its own, before the first and
/// after the last middle they are constant, and in between linear: no step is heard where the
/// record of one contact is divided.
[[nodiscard]] Way scraping_way(std::span<const Scrape> scrapes);

}  // namespace carom::sound
