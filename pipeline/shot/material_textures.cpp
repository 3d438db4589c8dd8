#include "pipeline/shot/material_textures.h"

#include <algorithm>
#include <memory>
#include <variant>

namespace carom::pipeline {

namespace {

using render::ColourSource;
using render::MixTexture;
using render::NumberSource;
using MixPointer = std::shared_ptr<const MixTexture>;

/// The textures of one parameter after another.
class Walk {
  public:
    explicit Walk(const TextureVisitor& visit) : visit_(visit) {}

    void colour(std::string_view key, const ColourSource& source) const {
        if (std::holds_alternative<Vec3>(source)) {
            return;
        }
        visit_(key, source);
        if (const auto* mix = std::get_if<MixPointer>(&source)) {
            colour(key, (*mix)->a);
            colour(key, (*mix)->b);
            number(key, (*mix)->by);
        }
    }

    void number(std::string_view key, const NumberSource& source) const {
        if (source.texture() != nullptr) {
            colour(key, source.texture()->pattern);
        }
    }

    void relief(const render::Relief& relief) const {
        if (const auto* normal = std::get_if<render::NormalPicture>(&relief)) {
            colour("normal", normal->image);
        } else if (const auto* height = std::get_if<render::HeightTexture>(&relief)) {
            colour("height", height->number.pattern);
        }
    }

  private:
    const TextureVisitor& visit_;
};

int depth_of(const ColourSource& source) {
    const auto* mix = std::get_if<MixPointer>(&source);
    return mix == nullptr ? 0 : pipeline::depth_of(**mix);
}

}  // namespace

void visit_textures(const render::MaterialDescription& material, const TextureVisitor& visit) {
    const Walk walk(visit);
    if (material.phong) {
        walk.colour("diffuse", material.phong->diffuse);
        return;
    }
    const render::StandardMaterial& surface = material.surface;
    walk.colour("base", surface.base);
    for (const render::TexturedParameter& parameter : render::textured_parameters(surface)) {
        walk.number(parameter.key, *parameter.number);
    }
    walk.relief(surface.relief);
    walk.colour("emission", surface.emission);
    walk.number("opacity", surface.opacity);
}

int texture_count(const render::MaterialDescription& material) {
    int count = 0;
    visit_textures(material,
                   [&](std::string_view /*key*/, const ColourSource& /*texture*/) { ++count; });
    return count;
}

bool is_cut_out(const render::MaterialDescription& material) {
    return !material.phong && material.surface.opacity.constant_or(0) < 1;
}

int depth_of(const MixTexture& mix) {
    const render::NumberTexture* by = mix.by.texture();
    return 1 +
           std::max({depth_of(mix.a), depth_of(mix.b), by == nullptr ? 0 : depth_of(by->pattern)});
}

const render::Placement* placement_of(const ColourSource& texture) {
    return std::visit(
        [](const auto& one) -> const render::Placement* {
            if constexpr (requires { one.placement; }) {
                return &one.placement;
            } else {
                return nullptr;
            }
        },
        texture);
}

}  // namespace carom::pipeline
