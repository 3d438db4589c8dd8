// Parts of one shot that can be added to another: balls, objects, lights, cameras, materials.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// A shot as text.
struct ShotText {
    std::string text;
    std::string folder;  // to which its paths are relative
    std::string root{};  // the folder of all files that it may use; empty: any
};

/// What `from` and the files that it includes have, except for carom's configurations. Throws Error
/// if `from` is not valid YAML. `to`: the shot to which something may be added; `texts`: the page's
/// texts.
[[nodiscard]] std::vector<Part> read_parts(const ShotText& from, const ShotText& to,
                                           const pipeline::config::OpenTexts* texts = nullptr);

/// The YAML of parts of `from` and of the materials that they need, with paths and names that are
/// right in `to`. Throws Error if there is no such part.
[[nodiscard]] std::vector<Addition> parts_to_add(
    const ShotText& from, const ShotText& to, const std::vector<PartName>& parts,
    const pipeline::config::OpenTexts* texts = nullptr);

}  // namespace carom::studio
