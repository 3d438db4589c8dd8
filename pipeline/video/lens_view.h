// What the lens does to the finished picture of a frame.
#pragma once

#include <cstdint>

#include "pipeline/camera/lens_look.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// A frame's lens as its picture is seen through it.
struct LensView {
    LensLook look{};
    double half_height = 0;  // tangent of half the angle of the picture's height

    [[nodiscard]] bool is_seen() const { return look.falloff > 0 || look.lateral_colour != 0; }

    bool operator==(const LensView&) const = default;
};

/// Which frame is viewed, and through which lens.
struct ViewedFrame {
    std::int64_t number = 0;
    LensView lens{};

    /// Implicit, so that a number is a frame that is seen through a perfect lens.
    // NOLINTNEXTLINE(google-explicit-constructor)
    ViewedFrame(std::int64_t frame, const LensView& its_lens = {})
        : number(frame), lens(its_lens) {}
};

/// The colours of the film through the lens, without its other channels.
///
/// The light is multiplied by 1 - falloff (1 - cos^4(angle)) with the angle between the direction
/// of a pixel and the optical axis, as in a lens without distortion. It is 1 in the centre.
///
/// The red picture is enlarged by 1 + lateral_colour / 2 and the blue one reduced by as much. They
/// are resampled with Catmull-Rom's cubic, without values beyond those of the two nearest pixels,
/// so that lamps have no dark edges.
[[nodiscard]] render::Film with_lens(const render::Film& film, const LensView& lens);

}  // namespace carom::pipeline
