// The grain of photographic film.
#pragma once

#include <cstdint>
#include <span>

namespace carom::pipeline {

/// Of which frame, and where in it, a strip of a picture is.
struct GrainPlace {
    std::int64_t frame = 0;
    int width = 0, height = 0;  // of the whole picture, pixels
    int first_row = 0;          // of the strip
};

/// Adds grain to a display signal (RGB, 16 bits, whole rows from the top left): noise with the mean
/// 0 that is independent in each pixel and channel, and is the same for the same pixel of the same
/// frame. Black and white have none.
///
/// The model is film of round grains at random places (Newson, Delon and Galerne 2017, "A
/// stochastic film grain model for resolution-independent rendering"). Of grains with the radius r,
/// far smaller than a pixel of the area A, the covered part of a pixel is nearly normal around the
/// signal u, with the variance K(u) pi r^2 / A, where K is the integral of the covariance of the
/// Boolean model in units of a grain's area. So the grain has a size on the film, not in pixels: a
/// picture of twice the size, seen at the same size, looks alike. At `strength` 1 the radius is
/// 2.4e-5 of the picture's height, 0.45 micrometres on 35 mm film.
void add_grain(std::span<std::uint16_t> signal, const GrainPlace& place, double strength);

/// K at u in [0, 1]; 0 outside.
[[nodiscard]] double grain_variance(double u);

}  // namespace carom::pipeline
