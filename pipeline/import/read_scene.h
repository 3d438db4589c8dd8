// Reads a scene model from the tokens of a scene text.
#pragma once

#include "pipeline/import/scene_model.h"
#include "pipeline/import/tokenizer.h"

namespace carom::pipeline::scene_text {

/// Returns everything that can be read and reports the rest as problems. References are indices of
/// elements that are defined earlier in the text.
[[nodiscard]] SceneModel read_scene(const std::vector<Item>& items, config::ProblemList& problems);

}  // namespace carom::pipeline::scene_text
