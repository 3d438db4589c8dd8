#include "pipeline/job/mixed_film.h"

#include <algorithm>

namespace carom::pipeline {

void mix_in(const render::Film& other, double weight, render::Film& film) {
    const auto fraction = static_cast<float>(weight);
    std::transform(film.rgba.begin(), film.rgba.end(), other.rgba.begin(), film.rgba.begin(),
                   [fraction](float a, float b) { return a * (1 - fraction) + b * fraction; });
}

}  // namespace carom::pipeline
