// The closed forms of a contact's force and of what it radiates, sample by sample.
#pragma once

#include <numbers>

#include "sound/source/direct_sound.h"
#include "sound/source/pulse.h"

namespace carom::sound {

/// f(t) of pulse.h in 1/s, for a contact of `duration` > 0 (s).
inline double pulse_force(double time, double duration, PulseShape shape = PulseShape::elastic) {
    if (time <= 0 || time >= duration) {
        return 0;
    }
    double force = 0;
    for (std::size_t i = 0; i < kPulseSines; ++i) {
        force += pulse_coefficients(shape)[i] *
                 sine(pulse_harmonic(i) * std::numbers::pi * time / duration);
    }
    return force / duration;
}

/// r(t) of pulse.h, which is 0 before the contact. Its unit is that of e^{pt}: none.
inline Complex pole_response_at(Complex pole, double duration, double time,
                                PulseShape shape = PulseShape::elastic) {
    if (time <= 0) {
        return {};
    }
    const PoleResponse response = pole_response(pole, duration, shape);
    if (time > duration) {
        return (exponential((time - duration) * pole) + exponential(time * pole)) * response.a;
    }
    Complex result = exponential(time * pole) * response.a;
    for (std::size_t i = 0; i < kPulseSines; ++i) {
        const SinCos angle = sin_cos(pulse_harmonic(i) * std::numbers::pi * time / duration);
        result = result - (angle.cos * response.c[i] + angle.sin * response.s[i]);
    }
    return result;
}

/// The pressure of a direct sound at a time (s, scene time, after the same instant as the onsets),
/// Pa.
inline double pressure_at(const DirectSound& sound, double time) {
    double pressure = 0;
    const auto add = [&](const Partial& partial, double onset) {
        const Complex response =
            pole_response_at(partial.pole, sound.contact_time, time - onset, sound.shape);
        pressure += 2 * (partial.residue * response).re;
    };
    for (const SphereWave& wave : sound.spheres) {
        add(wave.partial, wave.onset);
    }
    for (const Partial& mode : sound.modes) {
        add(mode, 0);
    }
    return pressure;
}

}  // namespace carom::sound
