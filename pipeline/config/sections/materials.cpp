#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

using render::ColourSource;
using render::MaterialDescription;
using render::PhongMaterial;
using render::StandardMaterial;

constexpr double kBrightest = 1e9;

ValueType<render::NumberSource> fraction() {
    ValueType<render::NumberSource> result = convert<render::NumberSource>(
        number(between(0, 1)), [](double value) { return render::NumberSource(value); });
    result.show = [](const render::NumberSource& source) {
        return number().show(source.constant_or(0));
    };
    return result;
}

const MapSpec<render::Coat>& coat_spec() {
    static const MapSpec<render::Coat> spec = [] {
        MapSpec<render::Coat> s("coat", "A clear layer on top.", {1.0, 1.5, 0.0});
        s.key("weight", &render::Coat::weight, fraction(), "weight of the coat; 0: no coat");
        s.key("ior", &render::Coat::ior, number(between(1, 3)), "index of refraction");
        s.key("roughness", &render::Coat::roughness, fraction(), "roughness; 0: a mirror");
        return s;
    }();
    return spec;
}

const MapSpec<render::ImageTexture>& image_spec() {
    static const MapSpec<render::ImageTexture> spec = [] {
        MapSpec<render::ImageTexture> s("image", "A picture, placed by the surface's uv.");
        s.key("file", &render::ImageTexture::file, file(FileKind::texture), "the picture")
            .required();
        s.key("scale", &render::ImageTexture::scale, vector2(Dimension::none, above_up_to(0, 1e4)),
              "numbers of repetitions along u and v");
        s.key("size", &render::ImageTexture::size, vector2(Dimension::length, above_up_to(0, 1e4)),
              "instead of `scale`: width and height of the picture on flat shapes, on cylinders "
              "and, around the equator, on spheres");
        s.key("offset", &render::ImageTexture::offset, vector2(Dimension::none),
              "translation of the picture along u and v, in widths and heights of the picture");
        s.key(
            "rotate",
            [](render::ImageTexture& image) -> double& { return image.placement.rotation; },
            angle(),
            "rotation of the picture, counter-clockwise about the corner where u and v are 0");
        s.key("is_linear", &render::ImageTexture::is_linear, boolean(),
              "whether the values of the picture are linear, whatever its file says. Otherwise "
              "integers are sRGB-encoded unless the file names another gamma, and floating-point "
              "numbers are linear");
        s.key("background", &render::ImageTexture::background, colour(between(0, 1)),
              "colour that is seen where the picture is transparent. The default is 0.8, with a "
              "warning");
        s.at_most_one_of({"scale", "size"});
        s.check([](Reader& reader, const Node& node, render::ImageTexture& image) {
            if (image.background) {
                reader.set_background(node.find("file")->value);
            }
        });
        return s;
    }();
    return spec;
}

const MapSpec<render::ClothTexture>& cloth_spec() {
    static const MapSpec<render::ClothTexture> spec = [] {
        MapSpec<render::ClothTexture> s("cloth", "Woven cloth with a nap.");
        s.key("colour", &render::ClothTexture::colour, colour(between(0, 1)), "mean albedo");
        s.key("thread", &render::ClothTexture::thread, length(inside(0, 1)),
              "spacing of the weave");
        s.key("variation", &render::ClothTexture::variation, number(between(0, 1)),
              "relative variation of the colour");
        return s;
    }();
    return spec;
}

const MapSpec<render::WoodTexture>& wood_spec() {
    static const MapSpec<render::WoodTexture> spec = [] {
        MapSpec<render::WoodTexture> s("wood", "Wood with rings along a grain.");
        s.key("light", &render::WoodTexture::light, colour(between(0, 1)),
              "colour of the early wood");
        s.key("dark", &render::WoodTexture::dark, colour(between(0, 1)), "colour of the late wood");
        s.key("ring", &render::WoodTexture::ring, length(inside(0, 10)),
              "mean spacing of the rings");
        s.key("grain", &render::WoodTexture::grain, vector3(Dimension::none),
              "direction of the grain in the object's axes");
        s.check([](Reader& reader, const Node& node, render::WoodTexture& wood) {
            if (wood.grain.length() < 1e-9) {
                reader.error(node.find("grain")->value.place,
                             "'grain' must not be the zero vector");
            }
        });
        return s;
    }();
    return spec;
}

const MapSpec<render::CheckerTexture>& checker_spec() {
    static const MapSpec<render::CheckerTexture> spec = [] {
        MapSpec<render::CheckerTexture> s("checker", "Squares of two colours.");
        s.key("even", &render::CheckerTexture::even, colour(between(0, 1)), "first colour");
        s.key("odd", &render::CheckerTexture::odd, colour(between(0, 1)), "second colour");
        s.key("size", &render::CheckerTexture::size, length(inside(0, 1000)),
              "edge length of a square");
        return s;
    }();
    return spec;
}

ValueType<render::ImageTexture> image() {
    const auto by_file =
        convert<render::ImageTexture>(file(FileKind::texture), [](std::string path) {
            render::ImageTexture texture;
            texture.file = std::move(path);
            return texture;
        });
    return any_of<render::ImageTexture>({{is_scalar, by_file}, {is_map, record(image_spec())}});
}

const MapSpec<ColourSource>& texture_spec() {
    static const MapSpec<ColourSource> spec = [] {
        MapSpec<ColourSource> s("texture", "A colour that varies over the surface.");
        const auto store = [](ColourSource& source, auto texture) { source = std::move(texture); };
        s.set("image", image(), store, "a picture: the name of its file, or a map");
        s.set("cloth", record(cloth_spec()), store, "woven cloth");
        s.set("wood", record(wood_spec()), store, "wood");
        s.set("checker", record(checker_spec()), store, "squares of two colours");
        s.set("ball", record(ball_texture_spec()), store, "a billiard ball");
        s.exactly_one_of({"image", "cloth", "wood", "checker", "ball"});
        return s;
    }();
    return spec;
}

ValueType<ColourSource> colour_source(const Range& range) {
    const auto constant =
        convert<ColourSource>(colour(range), [](const Vec3& c) -> ColourSource { return c; });
    ValueType<ColourSource> result = any_of<ColourSource>(
        {{is_map, record(texture_spec())}, {[](const Node&) { return true; }, constant}});
    result.show = [](const ColourSource& source) {
        const Vec3* colour = std::get_if<Vec3>(&source);
        return colour == nullptr ? std::string() : vector3(Dimension::none).show(*colour);
    };
    return result;
}

const MapSpec<StandardMaterial>& standard_spec() {
    static const MapSpec<StandardMaterial> spec = [] {
        MapSpec<StandardMaterial> s(
            "standard",
            "Layers from the bottom to the top: diffuse base, metal or glass, sheen, coat.");
        s.key("base", &StandardMaterial::base, colour_source(between(0, 1)), "colour or a texture");
        s.key("metal", &StandardMaterial::metal, fraction(),
              "1: the base is the reflectance of a metal");
        s.key("roughness", &StandardMaterial::roughness, fraction(),
              "roughness of the base's highlight, and of glass: 0 is clear, a higher value is "
              "frosted");
        s.key("specular", &StandardMaterial::specular, fraction(),
              "weight of the base's own dielectric highlight");
        s.key("transmission", &StandardMaterial::transmission, number(between(0, 1)),
              "fraction of the base that is glass, which fills the volume of a closed surface");
        s.key("ior", &StandardMaterial::ior, number(between(1, 3)),
              "index of refraction of the glass");
        s.key("transmission_colour", &StandardMaterial::transmission_colour, colour(between(0, 1)),
              "fraction of light that remains after `transmission_depth` of glass");
        s.key("transmission_depth", &StandardMaterial::transmission_depth, length(between(0, 1000)),
              "distance at which the transmission colour is reached; 0: the colour is applied at "
              "each surface");
        s.key("sheen", &StandardMaterial::sheen, fraction(),
              "weight of the reflection at grazing angles, as in cloth");
        s.key("sheen_colour", &StandardMaterial::sheen_colour, colour(between(0, 1)),
              "colour of the sheen");
        s.key("bump", &StandardMaterial::bump, number(between(0, 1)),
              "strength of the texture's own relief");
        s.key("emission", &StandardMaterial::emission, colour_source(between(0, kBrightest)),
              "radiance of the surface's front in W/(m^2 sr), which makes it a light");
        s.key("coat", &StandardMaterial::coat, record(coat_spec()), "a clear layer on top");
        return s;
    }();
    return spec;
}

const MapSpec<PhongMaterial>& phong_spec() {
    static const MapSpec<PhongMaterial> spec = [] {
        MapSpec<PhongMaterial> s(
            "phong", "The classic Phong material. `path` scales its fractions down to a sum of 1.");
        const auto fraction = colour(between(0, 1));
        const auto spread = angle(between(0, render::kWidestPhongSpread));
        s.key("ambient", &PhongMaterial::ambient, fraction,
              "colour under the ambient light. The default is that of `diffuse`");
        s.key("diffuse", &PhongMaterial::diffuse, colour_source(between(0, 1)),
              "colour or a texture");
        s.key("specular", &PhongMaterial::specular, fraction, "colour of the highlights");
        s.key("shininess", &PhongMaterial::shininess, number(between(0, 1e6)),
              "exponent of the highlights: a higher value is sharper");
        s.key("reflectance", &PhongMaterial::reflectance, fraction,
              "fraction of light that is mirrored");
        s.key("reflectance_spread", &PhongMaterial::reflectance_spread, spread,
              "standard deviation of reflection rays from the mirror direction");
        s.key("transmittance", &PhongMaterial::transmittance, fraction,
              "fraction of light that is transmitted");
        s.key("transmittance_spread", &PhongMaterial::transmittance_spread, spread,
              "standard deviation of refraction rays from the refracted direction");
        s.key("index", &PhongMaterial::index, number(between(0.1, 10)),
              "index of refraction of the inside divided by that of the outside");
        s.key("emission", &PhongMaterial::emission, colour(between(0, kBrightest)),
              "radiance of the surface's front in W/(m^2 sr), which makes it a light");
        return s;
    }();
    return spec;
}

}  // namespace

const MapSpec<MaterialDescription>& material_spec() {
    static const MapSpec<MaterialDescription> spec = [] {
        MapSpec<MaterialDescription> s("material",
                                       "A material of a surface, referred to by its name.");
        s.set(
            "standard", record(standard_spec()),
            [](MaterialDescription& material, StandardMaterial value) {
                material.surface = std::move(value);
            },
            "the layered material");
        s.set(
            "phong", record(phong_spec()),
            [](MaterialDescription& material, PhongMaterial value) {
                material.phong = std::move(value);
            },
            "the classic Phong material");
        s.exactly_one_of({"standard", "phong"});
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
