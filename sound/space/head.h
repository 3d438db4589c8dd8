// From where a sound reaches the two ears: a delay and a filter for each of them.
#pragma once

#include "core/vectors.h"
#include "sound/sound_scene.h"

namespace carom::sound {

inline constexpr double kHeadRadius = 0.0875;  // m, of the rigid sphere that stands for the head

/// What happens to a sound between the centre of the head and one ear. The filter is
///     y[n] = b0 x[n] + b1 x[n-1] - a1 y[n-1].
struct Ear {
    double delay = 0;  // s, in addition to that of the head's centre; negative for the nearer ear
    double b0 = 1;
    double b1 = 0;
    double a1 = 0;  // the same for all directions, so that a moving source needs no care

    bool operator==(const Ear&) const = default;
};

struct Ears {
    Ear left, right;

    bool operator==(const Ears&) const = default;
};

/// The unit vector from the listener to `place` in the listener's axes: x to the right, y ahead, z
/// up. Ahead if the place is the listener's.
[[nodiscard]] Vec3 direction_of(const Listener& listener, const Vec3& place);

/// The direction from which a sound seems to come where the picture shows an angle of 2 half_width
/// and loudspeakers stand 30 degrees to the left and right: its azimuth becomes
/// atan2(k sin azimuth, cos azimuth) with k = tan 30 degrees / tan half_width, limited to [1, 3].
/// The edges of the picture sound from the loudspeakers; left, right, ahead and behind stay, and so
/// does the elevation. `direction` is a unit vector in the listener's axes.
[[nodiscard]] Vec3 widened(const Vec3& direction, double half_width);

/// The ears for a sound from `place`.
///
/// Stereo::sphere: the head is a rigid sphere with opposite ears, after Brown and Duda (1998), "A
/// structural model for binaural sound synthesis", IEEE Transactions on Speech and Audio Processing
/// 6 (5), section III. With the angle theta between the direction and that of the ear, a the radius
/// of the head, c the speed of sound and w0 = c / a:
///     delay = -(a/c) cos theta, or (a/c)(theta - pi/2) from behind the ear (Woodworth's formula)
///     H(s) = (1 + alpha s / 2w0) / (1 + s / 2w0),   alpha = 1.05 + 0.95 cos(1.2 theta).
/// H is made digital by the bilinear transform, s -> 2 f (z - 1) / (z + 1), f the sample rate. It
/// is exact at zero and at half of the sample rate, and moves the corner of 1248 Hz by 3 Hz.
///
/// Stereo::pan: constant power between loudspeakers at 30 degrees to the left and right; from
/// further aside all sound is in one of them. No delays. A sound from ahead has the factor 1 in
/// both channels, one from a loudspeaker sqrt 2 in one. Ahead and behind sound alike.
///
/// Stereo::mono: neither delay nor filter.
[[nodiscard]] Ears ears_of(Stereo stereo, Width width, const Listener& listener, const Vec3& place);

/// Runs an ear's filter. The ear may change from sample to sample.
class EarFilter {
  public:
    double run(const Ear& ear, double sample) {
        const double result = ear.b0 * sample + ear.b1 * last_sample_ - ear.a1 * last_result_;
        last_sample_ = sample;
        // Below any audible level, and far above the numbers that processors compute slowly.
        last_result_ = result > kDenormalThreshold || result < -kDenormalThreshold ? result : 0;
        return last_result_;
    }

  private:
    static constexpr double kDenormalThreshold = 1e-30;  // Pa

    double last_sample_ = 0;
    double last_result_ = 0;
};

}  // namespace carom::sound
