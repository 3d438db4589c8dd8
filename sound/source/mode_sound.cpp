#include "sound/source/mode_sound.h"

#include <array>
#include <cmath>
#include <numbers>

namespace carom::sound {

Complex mode_pole(const Mode& mode) {
    const double w = 2 * std::numbers::pi * mode.frequency;
    return {-w / (2 * mode.q), w * std::sqrt(1 - 1 / (4 * mode.q * mode.q))};
}

Complex mode_residue(const Mode& mode) {
    const Complex pole = mode_pole(mode);
    return mode.gain * (pole / Complex{0, 2 * pole.im});
}

std::vector<Mode> bar_modes(double length, double thickness, double density,
                            const Material& material) {
    struct Shape {
        double slender;
        double timoshenko;
        double gain;
    };
    constexpr std::array<Shape, 2> kShapes{{{1.028, 7, 2}, {2.834, 20, 1}}};
    const double slope = thickness / length;
    const double wave_speed = std::sqrt(material.modulus / density);
    std::vector<Mode> modes;
    modes.reserve(kShapes.size());
    for (const Shape& shape : kShapes) {
        modes.push_back({shape.slender * slope / length * wave_speed /
                             std::sqrt(1 + shape.timoshenko * slope * slope),
                         1 / material.loss, shape.gain});
    }
    return modes;
}

std::vector<Mode> box_modes(const Vec3& size, double mass, const Material& material,
                            const Vec3& direction) {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
        longest = size[axis] > size[longest] ? axis : longest;
    }
    const double density = mass / (size.x * size.y * size.z);
    std::vector<Mode> modes;
    for (int axis = 0; axis < 3; ++axis) {
        const double part = std::abs(direction[axis]);
        if (axis == longest || part < 1e-3) {
            continue;
        }
        for (Mode mode : bar_modes(size[longest], size[axis], density, material)) {
            mode.gain *= part;
            modes.push_back(mode);
        }
    }
    return modes;
}

}  // namespace carom::sound
