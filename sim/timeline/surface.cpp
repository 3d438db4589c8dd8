#include "sim/timeline/surface.h"

#include <algorithm>
#include <array>

namespace carom::sim {

std::span<const std::string_view> surface_names() {
    static constexpr std::array<std::string_view, 5> kNames{"cushion", "cloth", "floor", "rail",
                                                            "pocket"};
    return kNames;
}

Surface surface_named(std::string_view name) {
    const auto names = surface_names();
    const auto found = std::find(names.begin(), names.end(), name);
    return found != names.end() ? static_cast<Surface>(found - names.begin() + 1) : Surface::none;
}

}  // namespace carom::sim
