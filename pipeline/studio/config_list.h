// The files of carom's own that a shot may include, for completion in the page.
#pragma once

#include <string>

namespace carom::studio {

/// The YAML files of the standard config folders as JSON, sorted by their names:
/// [{"name": "tables/pool_9ft.yaml", "about": the comment at its start}]. A name that several
/// folders have is listed once, with the file that an `include` finds. Templates are left out.
[[nodiscard]] std::string config_list_json();

}  // namespace carom::studio
