// Textures of every kind, and random points to look them up at.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include "core/error.h"
#include "render/texture/texture.h"
#include "tests/render/statistics.h"

namespace carom::test {

/// Random values, every eighth of an EXR file below the smallest normal half float, and those of
/// other files in [0, 1]. The file is to be removed.
inline std::string write_random_picture(int width, int height, int channels = 3,
                                        OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT) {
    const bool is_float = type == OIIO::TypeDesc::FLOAT;
    const std::string path =
        (std::filesystem::temp_directory_path() /
         ("carom_every_texture_" + std::to_string(getpid()) + "_" + type.c_str() + "_" +
          std::to_string(channels) + (is_float ? ".exr" : ".png")))
            .string();
    TestRandom random(5);
    std::vector<float> values(static_cast<std::size_t>(width * height * channels));
    for (float& value : values) {
        value = random.unit();
        value *= !is_float ? 1.0f : random.next() % 8 == 0 ? 6e-5f : 2.0f;
    }
    const auto file = OIIO::ImageOutput::create(path);
    if (!file || !file->open(path, OIIO::ImageSpec(width, height, channels, type)) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !file->close()) {
        throw Error("cannot write '" + path + "'");
    }
    return path;
}

struct NamedTexture {
    std::string name;
    render::Texture texture;
};

/// At least one texture of every kind. Made once, because cloth takes long.
inline const std::vector<NamedTexture>& every_texture() {
    static const std::vector<NamedTexture> all = [] {
        render::ImageCache images;
        std::vector<NamedTexture> made;
        const auto add = [&](const std::string& name, const render::ColourSource& source) {
            made.push_back({name, render::Texture(source, images)});
        };
        add("constant", Vec3(0.1, 0.2, 0.3));

        render::ImageTexture image;
        image.file = write_random_picture(37, 22);
        image.scale = Vec2(3, 0.7);
        image.offset = Vec2(0.2, -0.4);
        image.placement.rotation = 0.3;
        add("image by uv", image);
        image.size = Vec2(0.4, 0.25);
        add("image by size", image);
        std::filesystem::remove(image.file);
        // Of integers, in every way in which their finest level is kept.
        const auto add_integers = [&](const std::string& name, int channels, OIIO::TypeDesc type) {
            image.file = write_random_picture(37, 22, channels, type);
            add(name, image);
            std::filesystem::remove(image.file);
        };
        add_integers("grey of 8 bits", 1, OIIO::TypeDesc::UINT8);
        add_integers("grey of 16 bits", 1, OIIO::TypeDesc::UINT16);
        add_integers("colours of 8 bits", 3, OIIO::TypeDesc::UINT8);
        add_integers("colours of 16 bits", 3, OIIO::TypeDesc::UINT16);
        add_integers("transparent grey", 2, OIIO::TypeDesc::UINT8);
        add_integers("transparent colours", 4, OIIO::TypeDesc::UINT16);
        image.size.reset();
        image.tint = Vec3(0.5, 0.7, 0.9);
        for (const auto& [name, mapping] :
             {std::pair("planar image", render::Mapping::planar),
              std::pair("image around a box", render::Mapping::box),
              std::pair("image around a sphere", render::Mapping::spherical)}) {
            image.placement = {mapping, Vec3(0.2, -0.5, 0.8), 0.3};
            add_integers(name, 3, OIIO::TypeDesc::UINT8);
        }

        render::BallTexture ball;
        ball.colour = Vec3(0.8, 0.1, 0.05);
        add("plain ball", ball);
        ball.number = 8;
        add("ball with a number", ball);
        ball.number = 66;
        ball.striped = true;
        ball.spots = 6;
        add("striped ball with spots", ball);

        render::ClothTexture cloth;
        add("cloth", cloth);
        cloth.variation = 1.5;
        cloth.thread = 0.002;
        add("coarse cloth", cloth);

        render::WoodTexture wood;
        add("wood", wood);
        wood.grain = Vec3(0.3, 0.9, -0.2);
        wood.ring = 0.004;
        add("oblique wood", wood);

        render::CheckerTexture checker;
        add("checker", checker);
        checker.placement = {render::Mapping::uv, Vec3(0, 0, 1), 0.4};
        add("checker by uv", checker);
        cloth.placement = {render::Mapping::box, Vec3(0, 0, 1), -0.7};
        add("turned cloth around a box", cloth);
        wood.placement = {render::Mapping::own, Vec3(0, 0, 1), 1.1};
        add("turned wood", wood);
        cloth = {};
        cloth.wear = 0.7;
        cloth.seed = 3;
        add("worn cloth", cloth);
        cloth.bed = Vec2(1.27, 0.635);
        add("worn cloth of a table", cloth);
        render::SmudgesTexture smudges;
        add("smudges", smudges);
        return made;
    }();
    return all;
}

/// A point within 2 m; every third is near the origin, as points of a ball are.
inline render::SurfacePoint random_texture_point(TestRandom& random) {
    render::SurfacePoint point;
    const float reach = random.next() % 3 == 0 ? 0.03f : 2.0f;
    const auto within = [&](float most) { return random.between(-most, most); };
    point.object_position = {within(reach), within(reach), within(reach)};
    // Drawn in separate statements: compilers evaluate the arguments of a call in different orders.
    render::V3f normal;
    for (const int axis : {2, 1, 0}) {
        normal[axis] = within(1);
    }
    if (random.next() % 4 == 0) {
        normal[static_cast<int>(random.next() % 3)] = 0;
    }
    normal.x += normal.length2() > 0 ? 0.0f : 1.0f;
    point.geometric_normal = normal.normalized();
    point.uv = {within(3), within(3)};
    const float per_metre = random.between(0.1f, 5.0f);
    point.u_gradient = render::V3f(per_metre, 0.1f, -0.3f * per_metre);
    point.v_gradient = render::V3f(-0.2f, 0.7f * per_metre, per_metre);
    point.uv_metres = {random.between(0.1f, 5.0f), random.between(0.1f, 5.0f)};
    return point;
}

/// From 0 to beyond the size of everything, with the same share of every order of magnitude.
inline float random_footprint(TestRandom& random) {
    if (random.next() % 8 == 0) {
        return 0;
    }
    const int exponent = static_cast<int>(random.next() % 20) - 17;
    return std::ldexp(random.between(1, 2), exponent);
}

}  // namespace carom::test
