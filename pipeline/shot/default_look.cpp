#include "pipeline/shot/default_look.h"

#include <utility>

namespace carom::pipeline {

namespace {

using render::ColourSource;
using render::MaterialDescription;
using render::StandardMaterial;

StandardMaterial matt(ColourSource base, double roughness) {
    StandardMaterial material;
    material.base = std::move(base);
    material.roughness = roughness;
    return material;
}

StandardMaterial cloth() {
    StandardMaterial material = matt(render::ClothTexture{}, 0.9);
    material.sheen = 0.25;
    material.sheen_colour = {0.5, 0.8, 0.7};
    material.bump = 0.4;
    return material;
}

StandardMaterial varnished_wood(const Vec3& grain = {1, 0, 0}) {
    render::WoodTexture wood;
    wood.grain = grain;
    StandardMaterial material = matt(wood, 0.5);
    material.coat = {0.7, 1.5, 0.12};
    return material;
}

StandardMaterial polished(ColourSource base) {
    StandardMaterial material = matt(std::move(base), 0.5);
    material.coat = {1.0, 1.5, 0.0};
    return material;
}

/// Cast phenolic resin: n of 1.6 (bakelite: 1.63), and the fine scratches of play as a haze around
/// the mirror image.
StandardMaterial resin() {
    StandardMaterial material = matt(Vec3(0.8, 0.8, 0.8), 0.1);
    material.specular = 0.35;
    material.coat = {1.0, 1.6, 0.0};
    return material;
}

StandardMaterial brushed_metal(const Vec3& base) {
    StandardMaterial material = matt(base, 0.25);
    material.metal = 1;
    return material;
}

StandardMaterial lacquered(const Vec3& base, double roughness) {
    StandardMaterial material = matt(base, 0.5);
    material.coat = {0.8, 1.5, roughness};
    return material;
}

std::vector<MaterialDescription> make_materials() {
    StandardMaterial leather = matt(Vec3(0.012, 0.010, 0.009), 0.6);
    leather.specular = 0.4;
    return {
        {"cloth", cloth()},
        {"cushion", cloth()},
        {"rail", varnished_wood()},
        {"casting", brushed_metal(Vec3(0.30, 0.27, 0.23))},
        {"pocket_liner", leather},
        {"pocket_floor", matt(Vec3(0.006, 0.006, 0.006), 0.9)},
        {"stitch", matt(Vec3(0.42, 0.34, 0.22), 0.8)},
        {"net", matt(Vec3(0.55, 0.52, 0.45), 0.9)},
        {"apron", varnished_wood()},
        {"leg", varnished_wood({0, 0, 1})},
        {"sight", polished(Vec3(0.75, 0.72, 0.64))},
        {"name_plate", brushed_metal(Vec3(0.72, 0.55, 0.26))},
        {"line", matt(Vec3(0.60, 0.60, 0.55), 0.9)},  // tailor's chalk
        {"spot", matt(Vec3(0.012, 0.012, 0.012), 0.9)},
        {"floor", matt(Vec3(0.035, 0.030, 0.027), 0.7)},
        {"ball", resin()},
        {"stick_tip", matt(Vec3(0.05, 0.11, 0.17), 0.9)},  // chalked
        {"stick_ferrule", lacquered(Vec3(0.78, 0.75, 0.68), 0.1)},
        {"stick_shaft", lacquered(Vec3(0.58, 0.42, 0.24), 0.15)},
        {"stick_joint", brushed_metal(Vec3(0.72, 0.70, 0.66))},
        {"stick_butt", lacquered(Vec3(0.07, 0.022, 0.014), 0.05)},
        {"stick_wrap", matt(Vec3(0.03, 0.03, 0.032), 0.8)},
        {"stick_bumper", matt(Vec3(0.012, 0.012, 0.012), 0.7)},
        {"lamp_shade", lacquered(Vec3(0.016, 0.085, 0.046), 0.06)},  // green enamel
        {"lamp_housing", brushed_metal(Vec3(0.60, 0.60, 0.62))},
        {"plain", matt(Vec3(0.5, 0.5, 0.5), 0.5)},
    };
}

}  // namespace

const std::vector<MaterialDescription>& default_materials() {
    static const std::vector<MaterialDescription> materials = make_materials();
    return materials;
}

std::string_view material_of(sim::billiards::SurfacePart part) {
    using sim::billiards::SurfacePart;
    switch (part) {
        case SurfacePart::cloth:
            return "cloth";
        case SurfacePart::cushion:
            return "cushion";
        case SurfacePart::rail:
            return "rail";
        case SurfacePart::casting:
            return "casting";
        case SurfacePart::pocket_liner:
            return "pocket_liner";
        case SurfacePart::pocket_floor:
            return "pocket_floor";
        case SurfacePart::stitch:
            return "stitch";
        case SurfacePart::net:
            return "net";
        case SurfacePart::apron:
            return "apron";
        case SurfacePart::leg:
            return "leg";
        case SurfacePart::sight:
            return "sight";
        case SurfacePart::name_plate:
            return "name_plate";
        case SurfacePart::line:
            return "line";
        case SurfacePart::spot:
            return "spot";
    }
    return "plain";
}

std::vector<render::LightDescription> default_lights(const sim::billiards::TableMeasures* table) {
    const bool has_edges = table != nullptr && table->has_cushions;
    const double length = has_edges ? table->length : 2.0;
    const double width = has_edges ? table->width : 1.0;
    render::RectangleLight lamp;
    lamp.centre = {0, 0, 1.1};
    lamp.edge_u = {0.35 * length, 0, 0};
    lamp.edge_v = {0, 0.2 * width, 0};
    lamp.normal = {0, 0, -1};
    lamp.radiance = {9.0, 8.5, 7.6};
    render::EnvironmentLight room;
    room.radiance = {0.055, 0.060, 0.070};
    return {{"lamp", lamp}, {"room", room}};
}

}  // namespace carom::pipeline
