// The textures of a material, whatever parameter they belong to.
#pragma once

#include <functional>
#include <string_view>

#include "render/scene/material_description.h"

namespace carom::pipeline {

inline constexpr int kMostTextures = 12;  // of a material

/// `key`: the parameter as it is written in a shot, "coat.roughness". `texture` is no constant.
using TextureVisitor =
    std::function<void(std::string_view key, const render::ColourSource& texture)>;

/// Visits the textures of one parameter after the other; each mix before what it mixes.
void visit_textures(const render::MaterialDescription& material, const TextureVisitor& visit);

/// How many textures a material has; a mix counts, and so does each texture in it.
[[nodiscard]] int texture_count(const render::MaterialDescription& material);

/// Whether some or all of the surface may be missing, by its opacity.
[[nodiscard]] bool is_cut_out(const render::MaterialDescription& material);

/// How many mixes are one in another; 1: it contains none.
[[nodiscard]] int depth_of(const render::MixTexture& mix);

/// How a picture or pattern is laid on the surface; nullptr: the texture has no choice.
[[nodiscard]] const render::Placement* placement_of(const render::ColourSource& texture);

}  // namespace carom::pipeline
