#include "pipeline/config/surface_names.h"

#include <algorithm>

namespace carom::pipeline::config {

const std::vector<std::string>& surface_names() {
    static const std::vector<std::string> names{"cushion", "cloth", "floor", "rail", "pocket"};
    return names;
}

bool is_surface(std::string_view name) {
    const std::vector<std::string>& names = surface_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace carom::pipeline::config
