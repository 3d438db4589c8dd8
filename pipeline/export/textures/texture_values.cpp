#include "pipeline/export/textures/texture_values.h"

#include <array>
#include <cmath>
#include <memory>

#include "pipeline/export/plain_colour.h"
#include "render/material/material_textures.h"
#include "render/material/scalar_kernels.h"

namespace carom::pipeline {

namespace {

namespace scalar = render::scalar;
using Imath::V2f;
using Imath::V3f;
using render::ColourSource;
using render::NumberSource;
using render::NumberTexture;
using render::PictureChannel;
using scalar::One;

/// Sources whose textures lie on a plane of which uv are the coordinates of a place, in metres or
/// repeats. Textures that are elsewhere become their mean.
struct Flattened {
    const PlacedTexture& shared;

    [[nodiscard]] ColourSource colour(const ColourSource& source) const {
        return std::visit(*this, source);
    }
    [[nodiscard]] NumberTexture texture(const NumberTexture& texture) const {
        return {colour(texture.pattern), texture.range};
    }
    [[nodiscard]] NumberSource number(const NumberSource& source) const {
        return source.texture() == nullptr ? source : texture(*source.texture());
    }

    ColourSource operator()(const std::shared_ptr<const render::MixTexture>& mix) const {
        return std::make_shared<const render::MixTexture>(
            render::MixTexture{colour(mix->a), colour(mix->b), number(mix->by)});
    }
    template <class Texture>
    ColourSource operator()(Texture texture) const {
        if constexpr (requires { placed(texture); }) {
            const std::optional<PlacedTexture> own = placed(texture);
            if (own && fit_together(*own, shared)) {
                texture.placement = {render::Mapping::uv};
                return texture;
            }
        }
        return plain_colour(texture);
    }
};

/// The textures of a flattened material, as the renderer sees them straight from above through the
/// pixels of the picture that is made of a group.
class Plane {
  public:
    /// `lengths`: over which coordinates grow by 1, m.
    Plane(const render::StandardMaterial& material, const TextureGroup& group,
          PictureStore& pictures, const Vec2& lengths = {1, 1})
        : textures_(textures_of(material, pictures)) {
        const V2f length(lengths);
        const V2f pixel(baked_grid(group, pictures).pixel());
        point_.object_position = {0, 0, 0};
        point_.geometric_normal = kNormal;
        point_.uv_metres = {1, 1};
        point_.along = {pixel.x, 0};
        point_.across = {0, pixel.y};
        point_.way_along = {pixel.x * length.x, 0, 0};
        point_.way_across = {0, pixel.y * length.y, 0};
        point_.footprint = std::sqrt(point_.way_along.x * point_.way_across.y);
        point_.u_gradient = {1 / length.x, 0, 0};
        point_.v_gradient = {0, 1 / length.y, 0};
    }

    [[nodiscard]] const render::MaterialTextures& numbers() const { return textures_.numbers(); }

    /// Of each texture.
    [[nodiscard]] auto values(const Vec2& c) const {
        std::array<scalar::TextureValueOf<One>, render::MaterialTextures::kMost> values{};
        scalar::evaluate<One>(list(), numbers(), 0, numbers().count, at(c), values.data());
        return values;
    }
    [[nodiscard]] float number(const render::NumberPick& pick, const Vec2& c) const {
        return scalar::number_of<One>(pick, values(c).data());
    }
    [[nodiscard]] V3f normal(const Vec2& c) const {
        return scalar::resolve_surface<One>(list(), numbers(), at(c), kNormal, kNormal, kNormal)
            .normal;
    }

  private:
    static render::TexturesOfMaterial textures_of(const render::StandardMaterial& material,
                                                  PictureStore& pictures) {
        render::ImageCache images([&](const std::string& path) { return *pictures.picture(path); });
        return {material, images};
    }
    [[nodiscard]] render::List<render::TextureData> list() const {
        return render::List<render::TextureData>(textures_.list());
    }
    [[nodiscard]] scalar::TexturePointOf<One> at(const Vec2& c) const {
        scalar::TexturePointOf<One> point = point_;
        point.uv = V2f(c);
        return point;
    }

    static constexpr V3f kNormal{0, 0, 1};

    render::TexturesOfMaterial textures_;
    scalar::TexturePointOf<One> point_{};
};

}  // namespace

PictureChannel channel_of(const render::ImageTexture& image, const PictureFacts& facts,
                          NumberUse use) {
    if (image.channel != PictureChannel::automatic) {
        return image.channel;
    }
    return use == NumberUse::mask && facts.alpha != AlphaKind::opaque ? PictureChannel::alpha
                                                                      : PictureChannel::luminance;
}

bool is_as_stored(const render::ImageTexture& image, PictureChannel channel,
                  const PictureFacts& facts) {
    return channel == PictureChannel::alpha ||
           (facts.alpha == AlphaKind::opaque && image.tint == Vec3(1, 1, 1));
}

ColourAt colour_values(const ColourSource& source, const TextureGroup& group,
                       PictureStore& pictures, bool is_bare) {
    render::StandardMaterial flat;
    flat.base = Flattened{group.shared}.colour(source);
    if (is_bare) {
        flat.opacity = NumberTexture{Vec3(1, 1, 1)};
    }
    return [plane = Plane(flat, group, pictures)](const Vec2& c) {
        return plane.values(c)[static_cast<std::size_t>(plane.numbers().base)].colour;
    };
}

NumberAt number_values(const NumberSource& source, const TextureGroup& group,
                       PictureStore& pictures, NumberUse use) {
    const bool is_mask = use == NumberUse::mask;
    render::StandardMaterial flat;
    (is_mask ? flat.opacity : flat.metal) = Flattened{group.shared}.number(source);
    return [plane = Plane(flat, group, pictures), is_mask](const Vec2& c) {
        const render::MaterialTextures& numbers = plane.numbers();
        return plane.number(is_mask ? numbers.opacity : numbers.numbers[render::kMetal], c);
    };
}

ColourAt normal_values(render::Relief relief, const TextureGroup& group, const Vec2& lengths,
                       PictureStore& pictures) {
    if (auto* picture = std::get_if<render::NormalPicture>(&relief)) {
        picture->image.placement = {render::Mapping::uv};
        picture->strength = 1;
    } else if (auto* height = std::get_if<render::HeightTexture>(&relief)) {
        height->number = Flattened{group.shared}.texture(height->number);
    }
    render::StandardMaterial flat;
    flat.relief = relief;
    return
        [plane = Plane(flat, group, pictures, lengths)](const Vec2& c) { return plane.normal(c); };
}

}  // namespace carom::pipeline
