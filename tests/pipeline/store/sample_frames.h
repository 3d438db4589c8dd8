// Small frames and keys for tests of the frame store.
#pragma once

#include <cstdint>

#include "pipeline/store/frame_store.h"

namespace carom::testing {

/// A film of 8 x 4 pixels whose colours half precision represents exactly.
inline render::Film make_film(int seed) {
    render::Film film;
    film.width = 8;
    film.height = 4;
    for (int i = 0; i < 8 * 4 * 4; ++i) {
        film.rgba.push_back(static_cast<float>(seed % 64) + static_cast<float>(i) / 16);
    }
    film.aovs.push_back({"Z", std::vector<float>(32, 0.1f)});
    return film;
}

inline Hash128 make_key(std::uint64_t number) {
    return Hasher().add(number).finish();
}

}  // namespace carom::testing
