// The surfaces that bodies touch and that are no bodies of the world.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace carom::sim {

enum class Surface : std::uint8_t {
    none,  // not one of these: a body
    cushion,
    cloth,
    floor,
    rail,    // its wood, and the slate's underside
    pocket,  // its lining and its floor
};

/// The names of all but `none` in files and messages, in the order of the values. No body of a
/// world may have one of them.
[[nodiscard]] std::span<const std::string_view> surface_names();

/// none for all other names.
[[nodiscard]] Surface surface_named(std::string_view name);

/// Of the cloth or the floor.
[[nodiscard]] inline bool is_level(Surface surface) {
    return surface == Surface::cloth || surface == Surface::floor;
}

[[nodiscard]] inline bool is_surface(std::string_view name) {
    return surface_named(name) != Surface::none;
}

}  // namespace carom::sim
