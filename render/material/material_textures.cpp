#include "render/material/material_textures.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/error.h"

namespace carom::render {
namespace {

bool is_in_object_axes(Mapping mapping) {
    return mapping == Mapping::planar || mapping == Mapping::box || mapping == Mapping::spherical;
}

TextureNeeds needs_of(const TextureData& texture) {
    const Mapping mapping = texture.placement.mapping;
    const bool is_projected = is_in_object_axes(mapping);
    switch (texture.kind) {
        case TextureKind::plain:
        case TextureKind::mix:
            return {};
        case TextureKind::ball:
        case TextureKind::smudges:
            return {true, false, false, false};
        case TextureKind::image:
        case TextureKind::normals:
        case TextureKind::heights:
            return {true, !is_projected, is_projected, is_projected};
        case TextureKind::wood:
            return {true, mapping == Mapping::uv, is_projected, is_projected};
        case TextureKind::cloth:
        case TextureKind::checker:
            break;
    }
    return {true, mapping == Mapping::uv, is_projected, mapping != Mapping::uv};
}

TextureNeeds operator+(const TextureNeeds& a, const TextureNeeds& b) {
    return {a.position || b.position, a.uv || b.uv, a.sides || b.sides, a.axes || b.axes};
}

using scalar::One;
using Values = std::array<scalar::TextureValueOf<One>, MaterialTextures::kMost>;

scalar::TexturePointOf<One> texture_point(const SurfacePoint& point, const TextureNeeds& needs,
                                          const V3f& wo, float width) {
    constexpr float kLeastCosine = 0.1F;
    scalar::SurfacePointOf<One> of_kernels{};
    of_kernels.geometric_normal = point.geometric_normal;
    of_kernels.object_position = point.object_position;
    of_kernels.uv = point.uv;
    of_kernels.uv_metres = point.uv_metres;
    of_kernels.u_gradient = point.u_gradient;
    of_kernels.v_gradient = point.v_gradient;
    of_kernels.x_axis = point.x_axis;
    of_kernels.y_axis = point.y_axis;
    of_kernels.z_axis = point.z_axis;
    return scalar::texture_point<One>(of_kernels, needs, wo, width, kLeastCosine);
}

}  // namespace

template <class Read>
auto TexturesOfMaterial::evaluated(const scalar::TexturePointOf<One>& point,
                                   const Read& read) const {
    Values values{};
    scalar::evaluate<One>(List<TextureData>(list_), numbers_, 0, numbers_.count, point,
                          values.data());
    return read(values);
}

V3f TexturesOfMaterial::emission_at(const SurfacePoint& point, const V3f& wo, float width) const {
    return evaluated(texture_point(point, numbers_.needs, wo, width), [&](const Values& values) {
        const V3f& colour = values[static_cast<std::size_t>(numbers_.emission)].colour;
        return V3f(std::max(colour.x, 0.0F), std::max(colour.y, 0.0F), std::max(colour.z, 0.0F)) *
               numbers_.emission_strength;
    });
}

V3f TexturesOfMaterial::mean_emission() const {
    constexpr float kFar = 1e3F;  // m, and repeats of pictures
    SurfacePoint point;
    point.u_gradient = V3f(kFar, 0, 0);
    point.v_gradient = V3f(0, kFar, 0);
    point.uv_metres = V2f(1, 1);
    return emission_at(point, point.geometric_normal, kFar);
}

float TexturesOfMaterial::opacity_at(const SurfacePoint& point) const {
    return evaluated(
        texture_point(point, numbers_.needs, point.geometric_normal, 0), [&](const Values& values) {
            return std::clamp(scalar::number_of<One>(numbers_.opacity, values.data()), 0.0F, 1.0F);
        });
}

int TexturesOfMaterial::add(const TextureData& data) {
    if (list_.size() == MaterialTextures::kMost) {
        throw Error("more than " + std::to_string(MaterialTextures::kMost) + " textures");
    }
    list_.push_back(data);
    return static_cast<int>(list_.size()) - 1;
}

int TexturesOfMaterial::add(const Texture& texture) {
    kept_.push_back(texture);
    return add(texture.data());
}

int TexturesOfMaterial::add(const ColourSource& source, ImageCache& images, bool is_bare) {
    if (const auto* mixed = std::get_if<std::shared_ptr<const MixTexture>>(&source)) {
        const MixTexture& mix = **mixed;
        const bool shows_parts = is_bare || mix.by.texture() != nullptr;
        TextureData data;
        data.kind = TextureKind::mix;
        data.mix.a = add(mix.a, images, shows_parts);
        data.mix.b = add(mix.b, images, shows_parts);
        data.mix.by = add(mix.by, images, true);
        return add(data);
    }
    if (const auto* image = std::get_if<ImageTexture>(&source)) {
        return add_picture(*image, images, is_bare);
    }
    return add(Texture(source, images, is_bare));
}

/// Each picture once, whatever its channels are for.
int TexturesOfMaterial::add_picture(ImageTexture image, ImageCache& images, bool is_bare) {
    image.channel = PictureChannel::automatic;
    const auto known = std::ranges::find_if(pictures_, [&](const Picture& picture) {
        return picture.image == image && picture.is_bare == is_bare;
    });
    if (known != pictures_.end()) {
        return known->texture;
    }
    const int texture = add(Texture(image, images, is_bare));
    pictures_.push_back({image, is_bare, texture});
    return texture;
}

/// `is_mask`: the alpha of a picture counts if it has any.
NumberPick TexturesOfMaterial::add(const NumberTexture& number, ImageCache& images, bool is_mask) {
    NumberPick pick;
    pick.at_zero = static_cast<float>(number.range.x);
    pick.at_one = static_cast<float>(number.range.y);
    const auto* picture = std::get_if<ImageTexture>(&number.pattern);
    if (picture == nullptr) {
        pick.texture = add(number.pattern, images, false);
        return pick;
    }
    ImageTexture image = *picture;
    pick.channel = image.channel;
    if (pick.channel == PictureChannel::automatic) {
        const bool has_alpha = is_mask && images.file(image.file, image.is_linear)->has_alpha();
        pick.channel = has_alpha ? PictureChannel::alpha : PictureChannel::luminance;
    }
    image.is_linear = image.is_linear || pick.channel != PictureChannel::alpha;
    // Of a mask the colours of what it cuts out may be known already.
    pick.texture = add_picture(image, images, pick.channel == PictureChannel::alpha);
    return pick;
}

NumberPick TexturesOfMaterial::add(const NumberSource& number, ImageCache& images, bool is_mask) {
    if (const NumberTexture* varying = number.texture()) {
        return add(*varying, images, is_mask);
    }
    NumberPick pick;
    pick.at_zero = static_cast<float>(std::clamp(number.constant_or(0), 0.0, 1.0));
    return pick;
}

void TexturesOfMaterial::add_relief(const Relief& relief, ImageCache& images) {
    if (const auto* normals = std::get_if<NormalPicture>(&relief)) {
        numbers_.relief.kind = ReliefParameters::Kind::slopes;
        numbers_.relief.texture = add(Texture(*normals, images));
        numbers_.relief.strength = static_cast<float>(normals->strength);
        return;
    }
    const auto* height = std::get_if<HeightTexture>(&relief);
    const auto* picture =
        height == nullptr ? nullptr : std::get_if<ImageTexture>(&height->number.pattern);
    if (picture != nullptr) {
        const PictureChannel channel = picture->channel == PictureChannel::automatic
                                           ? PictureChannel::luminance
                                           : picture->channel;
        const Vec2& range = height->number.range;
        numbers_.relief.kind = ReliefParameters::Kind::slopes;
        numbers_.relief.texture = add(Texture(*picture, channel, images));
        numbers_.relief.strength = static_cast<float>(height->depth * (range.y - range.x));
    }
}

/// The heights of other textures: of their own, since they are evaluated at three places.
void TexturesOfMaterial::add_differences(const NumberTexture& number, ImageCache& images) {
    const std::vector<Picture> others = std::move(pictures_);
    pictures_.clear();
    numbers_.relief.first = static_cast<std::int32_t>(list_.size());
    numbers_.relief.height = add(number, images, false);
    numbers_.relief.last = static_cast<std::int32_t>(list_.size());
    pictures_ = others;
}

TexturesOfMaterial::TexturesOfMaterial(const StandardMaterial& material, ImageCache& images) {
    numbers_.base = add(material.base, images, material.opacity.texture() != nullptr);
    const auto parameters = textured_parameters(material);
    for (std::size_t k = 0; k < kTexturedNumbers; ++k) {
        numbers_.numbers[k] = add(*parameters[k].number, images, false);
        numbers_.varies = numbers_.varies || numbers_.numbers[k].texture >= 0;
    }
    add_relief(material.relief, images);
    numbers_.of_surface = static_cast<std::int32_t>(list_.size());
    const auto* height = std::get_if<HeightTexture>(&material.relief);
    if (height != nullptr && numbers_.relief.kind == ReliefParameters::Kind::none) {
        numbers_.relief.kind = ReliefParameters::Kind::differences;
        numbers_.relief.strength = static_cast<float>(height->depth);
        add_differences(height->number, images);
    }
    if (!std::holds_alternative<Vec3>(material.emission)) {
        numbers_.emission = add(material.emission, images, false);
        numbers_.emission_strength = static_cast<float>(material.emission_strength);
    }
    numbers_.opacity = add(material.opacity, images, true);
    finish(material.bump);
}

TexturesOfMaterial::TexturesOfMaterial(const PhongMaterial& material, ImageCache& images) {
    numbers_.base = add(material.diffuse, images, false);
    numbers_.of_surface = static_cast<std::int32_t>(list_.size());
    numbers_.opacity.at_zero = 1;
    finish(0);
}

void TexturesOfMaterial::finish(double bump) {
    if (numbers_.relief.kind == ReliefParameters::Kind::none && bump > 0 &&
        base().kind == TextureKind::cloth) {
        numbers_.relief.kind = ReliefParameters::Kind::own;
        numbers_.relief.strength = static_cast<float>(std::min(bump, 1.0));
    }
    for (const TextureData& texture : list_) {
        numbers_.needs = numbers_.needs + needs_of(texture);
    }
    const bool has_slopes = numbers_.relief.kind == ReliefParameters::Kind::slopes;
    if (numbers_.relief.kind == ReliefParameters::Kind::differences) {
        numbers_.needs.sides = numbers_.needs.axes = true;
    }
    numbers_.varies = numbers_.varies || has_slopes;
    numbers_.only_base = !numbers_.varies && base().kind != TextureKind::mix &&
                         numbers_.relief.kind != ReliefParameters::Kind::differences;
    numbers_.count = static_cast<std::int32_t>(list_.size());
}

}  // namespace carom::render
