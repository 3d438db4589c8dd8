#include "tests/render/integrator/wave_cases.h"

#include "tests/render/integrator/every_shape.h"

namespace carom::test {
namespace {

using render::StandardMaterial;

StandardMaterial coated(double roughness) {
    StandardMaterial material;
    material.base = Vec3(0.6, 0.1, 0.1);
    material.coat = {1, 1.5, roughness};
    return material;
}

/// A satin highlight, a mirror, half of a rough metal, and a highlight under a smooth coat.
void add_metals(SceneBuilder& builder) {
    StandardMaterial leather;
    leather.base = Vec3(0.3, 0.2, 0.1);
    leather.specular = 0.7;
    leather.roughness = 0.55;
    StandardMaterial mirror;
    mirror.metal = 1;
    mirror.roughness = 0;
    StandardMaterial alloy;
    alloy.metal = 0.5;
    alloy.roughness = 0.4;
    alloy.specular = 0.5;
    StandardMaterial polished = coated(0);
    polished.specular = 1;
    polished.roughness = 0.3;
    builder.material("leather", leather).material("mirror", mirror);
    builder.material("alloy", alloy).material("polished", polished);
    builder.sphere("e", 0.12, Vec3(0.5, 0.1, 0.12), "leather");
    builder.sphere("f", 0.12, Vec3(-0.5, -0.3, 0.12), "mirror");
    builder.sphere("g", 0.12, Vec3(0.4, -0.4, 0.12), "alloy");
    builder.sphere("h", 0.12, Vec3(-0.5, 0.5, 0.12), "polished");
}

/// Rough coats, over a base and over nothing.
void add_lacquer(SceneBuilder& builder) {
    StandardMaterial black = coated(0.4);
    black.base = Vec3(0, 0, 0);
    StandardMaterial satin = coated(0.25);
    satin.specular = 0.5;
    satin.roughness = 0.6;
    satin.sheen = 0.2;
    builder.material("lacquer", coated(0.2)).material("black", black).material("satin", satin);
    builder.sphere("i", 0.12, Vec3(0.5, 0.1, 0.12), "lacquer");
    builder.sphere("j", 0.12, Vec3(-0.5, -0.3, 0.12), "black");
    builder.object("k", render::BoxShape{Vec3(0.3, 0.3, 0.2)}, Vec3(0.4, -0.4, 0.1), "satin");
}

/// A ball with a stripe and a number that moves, and a bent sheet with a pattern.
void add_paint(SceneBuilder& builder) {
    StandardMaterial paint = coated(0);
    paint.base = render::BallTexture{.colour = Vec3(0.1, 0.3, 0.7), .striped = true, .number = 9};
    StandardMaterial wood = coated(0.3);
    wood.base = render::WoodTexture{};
    builder.material("paint", paint).material("wood", wood);
    builder.sphere("nine", 0.13, Vec3(0, 0, 0), "paint", "moving");
    render::MeshShape sheet;
    sheet.vertices = {Vec3(-0.7, -0.6, 0.02), Vec3(-0.3, -0.6, 0.1), Vec3(-0.3, 0, 0.1),
                      Vec3(-0.7, 0, 0.02)};
    sheet.normals = {Vec3(0, 0, 1), Vec3(0.3, 0, 1).normalized(), Vec3(0, 0.2, 1).normalized(),
                     Vec3(0, 0, 1)};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    builder.object("sheet", sheet, Vec3(0, 0, 0), "wood");
}

std::string picture_path() {
    static const PictureFile file;
    return file.path();
}

/// Walls from which most paths scatter eight times, a mirror and glass.
void add_white_room(SceneBuilder& builder) {
    StandardMaterial glass;
    glass.transmission = 1;
    StandardMaterial mirror;
    mirror.metal = 1;
    mirror.roughness = 0;
    StandardMaterial grey_green = coated(0.3);
    grey_green.base = Vec3(0.5, 0.8, 0.6);
    builder.diffuse("white", 0.9).material("glass", glass).material("mirror", mirror);
    builder.material("lacquer", grey_green);
    builder.object("back", render::BoxShape{Vec3(2, 0.1, 1)}, Vec3(0, 0.8, 0.4), "white");
    builder.object("left", render::BoxShape{Vec3(0.1, 2, 1)}, Vec3(-0.8, 0, 0.4), "lacquer");
    builder.object("right", render::BoxShape{Vec3(0.1, 2, 1)}, Vec3(0.8, 0, 0.4), "white");
    builder.object("floor", render::BoxShape{Vec3(2, 2, 0.02)}, Vec3(0, 0, 0), "white");
    builder.sphere("clear", 0.12, Vec3(0.4, -0.4, 0.12), "glass");
    builder.sphere("shiny", 0.12, Vec3(-0.5, -0.3, 0.12), "mirror");
}

/// All shapes, with the same texture.
void add_shapes(SceneBuilder& builder, Placement placement, const render::ColourSource& texture) {
    StandardMaterial material = coated(0);
    material.base = texture;
    builder.material("pattern", material);
    add_every_shape(builder, placement, "pattern");
}

void add_shape_cases(std::vector<WaveCase>& cases) {
    render::ImageTexture image;
    image.file = picture_path();
    render::WoodTexture wood;
    render::CheckerTexture checker;
    const std::pair<const char*, render::ColourSource> textures[] = {
        {"Image", image}, {"Checker", checker}, {"Wood", wood}};
    const std::pair<const char*, Placement> placements[] = {{"UprightShapes", Placement::upright},
                                                            {"TurnedShapes", Placement::turned},
                                                            {"MovingShapes", Placement::moving}};
    for (const auto& [texture_name, texture] : textures) {
        for (const auto& [placement_name, placement] : placements) {
            cases.push_back({std::string(placement_name) + "With" + texture_name,
                             [texture = texture, placement = placement](SceneBuilder& builder) {
                                 add_lights(builder);
                                 add_shapes(builder, placement, texture);
                             }});
        }
    }
}

/// Every shape emits light.
void add_glowing_cases(std::vector<WaveCase>& cases) {
    const std::pair<const char*, Placement> placements[] = {{"Upright", Placement::upright},
                                                            {"Turned", Placement::turned},
                                                            {"Moving", Placement::moving}};
    for (const auto& [name, placement] : placements) {
        cases.push_back({std::string("Glowing") + name + "Shapes",
                         [placement = placement](SceneBuilder& builder) {
                             StandardMaterial glowing;
                             glowing.emission = Vec3(0.5, 0.4, 0.1);
                             builder.material("glowing", glowing);
                             builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6);
                             add_every_shape(builder, placement, "glowing");
                         }});
    }
}

}  // namespace

void add_table(SceneBuilder& builder) {
    builder.diffuse("cloth", 0.3).material("ball", coated(0));
    builder.object("table", render::BoxShape{Vec3(2, 2, 0.2)}, Vec3(0, 0, -0.1), "cloth");
    builder.object("rail", render::BoxShape{Vec3(0.2, 2, 0.3)}, Vec3(1, 0, 0), "cloth");
    builder.sphere("still", 0.1, Vec3(0.2, 0.3, 0.1), "ball");
    builder.sphere("resting", 0.1, Vec3(0, 0, 0), "ball", "resting");
    builder.sphere("moving", 0.1, Vec3(0, 0, 0), "ball", "moving");
}

std::vector<sim::Track> table_tracks() {
    std::vector<sim::Track> tracks = tracks_of_every_shape(kWaveShutter);
    tracks.push_back(resting_track("resting", Vec3(-0.3, 0.2, 0.1)));
    tracks.push_back(
        straight_track("moving", Vec3(-0.1, -0.2, 0.1), Vec3(0.2, -0.1, 0.1), 0, kWaveShutter));
    return tracks;
}

void add_lights(SceneBuilder& builder) {
    builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6).bulb(Vec3(-0.6, 0.5, 0.8), 0.04, 40);
    builder.environment(0.2);
}

void add_mixed_materials(SceneBuilder& builder) {
    StandardMaterial nap;
    nap.base = Vec3(0.1, 0.3, 0.2);
    nap.sheen = 0.3;
    builder.material("nap", nap);
    builder.object("bed", render::BoxShape{Vec3(1, 1, 0.02)}, Vec3(0, 0, 0), "nap");
    add_lacquer(builder);
    add_paint(builder);
    render::ImageTexture image;
    image.file = picture_path();
    add_shapes(builder, Placement::turned, image);
}

std::vector<WaveCase> wave_cases() {
    const auto with_lights = [](const std::function<void(SceneBuilder&)>& more) {
        return [more](SceneBuilder& builder) {
            add_lights(builder);
            more(builder);
        };
    };
    std::vector<WaveCase> cases;
    cases.push_back({"LampBulbAndSky", with_lights([](SceneBuilder&) {})});
    cases.push_back({"NoLightAtAll", [](SceneBuilder&) {}});
    cases.push_back({"ManyLamps", [](SceneBuilder& builder) {
                         for (int i = 0; i < 6; ++i) {
                             builder.lamp(Vec3(0.3 * i - 0.8, 0, 1 + 0.1 * i), 0.1, 0.3, 4);
                         }
                     }});
    cases.push_back({"LightsWithoutSurface", with_lights([](SceneBuilder& builder) {
                         render::PointLight point;
                         point.position = Vec3(0.4, -0.4, 0.7);
                         point.intensity = Vec3(0.4, 0.5, 0.6);
                         builder.scene.lights.push_back({"point", point});
                     })});
    cases.push_back(
        {"LightsWithoutFalloff", [](SceneBuilder& builder) {
             add_lights(builder);
             for (render::LightDescription& light : builder.scene.lights) {
                 if (auto* lamp = std::get_if<render::RectangleLight>(&light.light)) {
                     lamp->falloff = render::Falloff::none;
                 } else if (auto* bulb = std::get_if<render::SphereLight>(&light.light)) {
                     bulb->falloff = render::Falloff::none;
                 }
             }
             builder.scene.lights.push_back(
                 {"point",
                  render::PointLight{Vec3(0.4, -0.4, 0.7), Vec3(1, 2, 3), render::Falloff::none}});
         }});
    cases.push_back({"SkyWithSun", [](SceneBuilder& builder) {
                         render::EnvironmentLight sky;
                         sky.sky = render::Sky{};
                         sky.radiance = Vec3(1e-5, 1e-5, 1e-5);
                         builder.scene.lights.push_back({"sky", sky});
                         builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6);
                     }});
    cases.push_back({"OtherMaterials", with_lights([](SceneBuilder& builder) {
                         StandardMaterial glass;
                         glass.transmission = 1;
                         StandardMaterial chrome;
                         chrome.metal = 1;
                         chrome.roughness = 0.2;
                         StandardMaterial glowing;
                         glowing.emission = Vec3(0.5, 0.4, 0.1);
                         builder.material("glass", glass).material("chrome", chrome);
                         builder.material("lacquer", coated(0.2)).material("glowing", glowing);
                         builder.sphere("a", 0.12, Vec3(0.5, 0.1, 0.12), "glass");
                         builder.sphere("b", 0.12, Vec3(-0.5, -0.3, 0.12), "chrome");
                         builder.sphere("c", 0.12, Vec3(0.4, -0.4, 0.12), "lacquer");
                         builder.sphere("d", 0.06, Vec3(-0.5, 0.5, 0.06), "glowing");
                     })});
    cases.push_back({"TurnedAndTextured", with_lights([](SceneBuilder& builder) {
                         StandardMaterial painted = coated(0);
                         painted.base = render::CheckerTexture{};
                         builder.material("painted", painted);
                         builder.object("tile", render::RectangleShape{Vec2(0.4, 0.4)},
                                        Vec3(-0.4, -0.4, 0.02), "painted");
                         builder.sphere("globe", 0.15, Vec3(0.3, -0.4, 0.15), "painted");
                     })});
    cases.push_back({"ClothAndVelvet", with_lights([](SceneBuilder& builder) {
                         StandardMaterial cloth;
                         cloth.base = render::ClothTexture{};
                         cloth.sheen = 0.3;
                         cloth.sheen_colour = Vec3(0.4, 0.8, 0.7);
                         cloth.bump = 0.5;
                         StandardMaterial velvet = coated(0);
                         velvet.sheen = 0.8;
                         StandardMaterial dust = cloth;
                         dust.base = Vec3(0, 0, 0);
                         builder.material("nap", cloth).material("velvet", velvet);
                         builder.material("dust", dust);
                         builder.object("bed", render::BoxShape{Vec3(1, 1, 0.02)},
                                        Vec3(-0.5, 0.2, 0), "nap");
                         builder.sphere("pillow", 0.15, Vec3(0.3, -0.4, 0.15), "velvet");
                         builder.sphere("soot", 0.1, Vec3(-0.3, -0.5, 0.1), "dust");
                     })});
    cases.push_back(
        {"HighlightsAndMetals", with_lights([](SceneBuilder& builder) { add_metals(builder); })});
    cases.push_back({"LacquerUnderASky", [](SceneBuilder& builder) {
                         render::EnvironmentLight sky;
                         sky.sky = render::Sky{};
                         sky.radiance = Vec3(1e-5, 1e-5, 1e-5);
                         builder.scene.lights.push_back({"sky", sky});
                         builder.lamp(Vec3(0, 0, 1.5), 0.4, 0.2, 6);
                         add_lacquer(builder);
                     }});
    cases.push_back(
        {"PaintAndMeshes", with_lights([](SceneBuilder& builder) { add_paint(builder); })});
    cases.push_back({"ClearGlass",
                     with_lights([](SceneBuilder& builder) {
                         StandardMaterial glass;
                         glass.transmission = 1;
                         glass.roughness = 0;
                         builder.material("clear", glass);
                         builder.scene.lights.push_back(
                             {"point", render::PointLight{Vec3(0.4, 0.5, 0.9), Vec3(1, 1, 1)}});
                         builder.bulb(Vec3(-0.2, 0.6, 1.2), 0.01, 300);
                         builder.sphere("lens", 0.12, Vec3(0.3, -0.4, 0.16), "clear");
                         builder.sphere("rolling lens", 0.1, Vec3(0, 0, 0), "clear", "moving");
                     }),
                     {.max_bounces = 4}});
    cases.push_back({"DisksAndShades", [](SceneBuilder& builder) {
                         render::DiskLight disk;
                         disk.centre = Vec3(0.4, 0.3, 1.2);
                         disk.normal = Vec3(0.28, 0, -0.96);
                         disk.radiance = Vec3(9, 8, 7);
                         disk.beam = 2.5;
                         render::ShadeLight shade;
                         shade.centre = Vec3(-0.3, -0.2, 1);
                         shade.shape = {0.2, 0.05, 0.24, 0.6};
                         shade.disk_radius = 0.07;
                         shade.depth = 0.16;
                         shade.radiance = Vec3(40, 38, 30);
                         builder.scene.lights.push_back({"disk", disk});
                         builder.scene.lights.push_back({"shade", shade});
                         add_metals(builder);
                     }});
    cases.push_back({"EightBounces", with_lights([](SceneBuilder&) {}), {.max_bounces = 8}});
    cases.push_back({"WhiteRoomWithRoulette", with_lights(add_white_room), {.max_bounces = 8}});
    cases.push_back({"DirectLightOnly", with_lights([](SceneBuilder&) {}), {.max_bounces = 0}});
    cases.push_back({"NoSplit", with_lights([](SceneBuilder&) {}), {.split_vertices = 0}});
    cases.push_back({"NoCaustics", with_lights([](SceneBuilder&) {}), {.caustics = false}});
    cases.push_back({"Clamped", with_lights([](SceneBuilder&) {}), {.clamp = 0.2f}});
    add_shape_cases(cases);
    add_glowing_cases(cases);
    return cases;
}

}  // namespace carom::test
