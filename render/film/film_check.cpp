#include "render/film/film_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/assert.h"
#include "core/error.h"

namespace carom::render {
namespace {

std::size_t pixel_count(const Film& film) {
    return static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
}

void check_finite(const std::string& channel, std::size_t pixel, float value, int width,
                  const std::string& path) {
    if (!std::isfinite(value)) {
        const std::size_t columns = static_cast<std::size_t>(width);
        throw Error(fmt::format(
            "'{}': pixel ({}, {}), channel {}, is not a finite number; such a picture is not "
            "written",
            path, pixel % columns, pixel / columns, channel));
    }
}

void check_sizes(const Film& film) {
    CAROM_ASSERT(film.width > 0 && film.height > 0);
    CAROM_ASSERT(film.rgba.size() == 4 * pixel_count(film));
    for (const Channel& aov : film.aovs) {
        CAROM_ASSERT(aov.values.size() == pixel_count(film));
    }
}

}  // namespace

bool all_finite(std::span<const float> values) {
    FiniteCheck check;
    for (const float value : values) {
        check.add(value);
    }
    return check.all_finite();
}

void check_film(const Film& film, const std::string& path) {
    constexpr const char* kColourNames[4] = {"R", "G", "B", "A"};
    check_sizes(film);
    if (!all_finite(film.rgba)) {
        for (std::size_t i = 0; i < film.rgba.size(); ++i) {
            check_finite(kColourNames[i % 4], i / 4, film.rgba[i], film.width, path);
        }
    }
    for (const Channel& aov : film.aovs) {
        if (!all_finite(aov.values)) {
            for (std::size_t p = 0; p < aov.values.size(); ++p) {
                check_finite(aov.name, p, aov.values[p], film.width, path);
            }
        }
    }
}

}  // namespace carom::render
