// Lamps: lights with what is seen around them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// The names of its parts, and of their materials if they have own ones, begin with a slash, to
/// which the lamp's name is added in front (name_parts).
struct Lamp {
    std::optional<render::LightDescription> light;  // empty: a part shines
    std::vector<render::ObjectDescription> parts;
    std::vector<render::MaterialDescription> materials;
};

/// The parts' material unless another one is given.
inline constexpr const char* kShadeMaterial = "lamp_shade";
inline constexpr const char* kHousingMaterial = "lamp_housing";

/// The light with the outside of its shade, "/shade": sheet of 2 mm, closed at the top.
[[nodiscard]] Lamp lamp_in_shade(const render::ShadeLight& light, const std::string& material);

/// The light with a flat box behind it, "/housing", whose frame is seen around it.
[[nodiscard]] Lamp lamp_in_housing(const render::RectangleLight& light);

/// A fluorescent or LED tube with round ends.
struct Tube {
    Vec3 centre{0, 0, 1};
    Vec3 axis{1, 0, 0};      // unit
    double length = 1;       // m, > 0, without the ends
    double radius = 0.008;   // m, > 0
    Vec3 radiance{1, 1, 1};  // W/(m^2 sr)

    /// m^2.
    [[nodiscard]] double area() const;
};

/// The tube as an object, "/tube", that shines all around.
[[nodiscard]] Lamp lamp_of_tube(const Tube& tube);

/// Gives the light and all parts the names that they have in the shot.
void name_parts(Lamp& lamp, const std::string& name);

}  // namespace carom::pipeline
