// The modes of resonators and of boxes: damped vibrations that an impact excites.
#pragma once

#include <vector>

#include "sound/sound_scene.h"
#include "sound/source/complex.h"

namespace carom::sound {

/// The pole of a mode, w (-1/(2 Q) + i sqrt(1 - 1/(4 Q^2))), 1/s.
[[nodiscard]] Complex mode_pole(const Mode& mode);

/// The residue of its pressure at 1 m per N s, p / (2 i Im p) times its gain: the response to an
/// impulse, 2 Re(residue e^{pt}), begins with the gain.
[[nodiscard]] Complex mode_residue(const Mode& mode);

/// The first two bending modes of a free bar of length L and thickness h,
///     f_n = (1.028, 2.834) (h/L^2) sqrt(E/rho) / sqrt(1 + (7, 20) (h/L)^2),   Q = 1/loss.
/// The numerators are those of a slender bar (Fletcher & Rossing, The Physics of Musical
/// Instruments, 1998, section 2.14), the last factor a fit to Timoshenko's beam, within 2 % up to
/// h/L = 1/4. The gains are 2 and 1.
[[nodiscard]] std::vector<Mode> bar_modes(double length, double thickness, double density,
                                          const Material& material);

/// The bending modes of a box that is hit along the unit vector `direction` of its own axes, along
/// its two shorter edges, each with its gain times the part of the direction along that edge.
[[nodiscard]] std::vector<Mode> box_modes(const Vec3& size, double mass, const Material& material,
                                          const Vec3& direction);

}  // namespace carom::sound
