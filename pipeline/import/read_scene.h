// From the words of a scene text to what it describes.
#pragma once

#include "pipeline/import/scene_model.h"
#include "pipeline/import/tokenizer.h"

namespace carom::pipeline::scene_text {

/// Everything that can be read; what is wrong becomes problems. References are indices of what
/// stands earlier in the text.
[[nodiscard]] SceneModel read_scene(const std::vector<Item>& items, config::ProblemList& problems);

}  // namespace carom::pipeline::scene_text
