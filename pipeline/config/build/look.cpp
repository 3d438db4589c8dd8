#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/shot/default_look.h"
#include "render/scene/scene_problems.h"

namespace carom::pipeline::config {

namespace {

/// The default materials, with those of the look added or replaced by name.
std::vector<render::MaterialDescription> all_materials(const ShotFile& file) {
    std::vector<render::MaterialDescription> materials = default_materials();
    for (const Named<render::MaterialDescription>& given : file.materials) {
        const auto known = std::find_if(
            materials.begin(), materials.end(),
            [&](const render::MaterialDescription& m) { return m.name == given.name; });
        if (known == materials.end()) {
            materials.push_back(given.value);
            materials.back().name = given.name;
        } else {
            *known = given.value;
            known->name = given.name;
        }
    }
    return materials;
}

/// Adds only materials that an object uses, so that an unused one does not change a frame's key.
void add_used_materials(Builder& builder) {
    render::SceneDescription& scene = builder.shot.scene;
    std::set<std::string> used;
    for (const render::ObjectDescription& object : scene.objects) {
        used.insert(object.material);
    }
    for (render::MaterialDescription& material : all_materials(builder.file)) {
        builder.materials.insert(material.name);
        if (used.count(material.name) != 0) {
            scene.materials.push_back(std::move(material));
        }
    }
    std::sort(scene.materials.begin(), scene.materials.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
}

/// Tells the cloths of the table where its cushions are, which wear depends on.
void lay_cloth(Builder& builder) {
    const std::optional<sim::billiards::TableMeasures>& table = builder.shot.world.table;
    if (!table || table->kind == sim::billiards::TableKind::cloth) {
        return;
    }
    std::set<std::string> of_table;
    for (const render::ObjectDescription& object : builder.shot.scene.objects) {
        if (object.name.starts_with("table/")) {
            of_table.insert(object.material);
        }
    }
    for (render::MaterialDescription& material : builder.shot.scene.materials) {
        auto* cloth = std::get_if<render::ClothTexture>(&material.surface.base);
        if (cloth != nullptr && cloth->wear > 0 && of_table.count(material.name) != 0) {
            cloth->bed = Vec2(table->length, table->width) / 2;
        }
    }
}

void add_lights(Builder& builder) {
    std::vector<render::LightDescription>& lights = builder.shot.scene.lights;
    const std::optional<sim::billiards::TableMeasures>& table = builder.shot.world.table;
    if (builder.file.lights.empty()) {
        lights = default_lights(table ? &*table : nullptr);
        return;
    }
    for (const Named<Lamp>& given : builder.file.lights) {
        if (given.value.light) {
            lights.push_back(*given.value.light);
            lights.back().name = given.name;
        }
    }
}

/// Lamps are seen, and their materials can be replaced as those of other objects.
void add_parts_of_lamps(Builder& builder) {
    render::SceneDescription& scene = builder.shot.scene;
    for (const Named<Lamp>& given : builder.file.lights) {
        Lamp lamp = given.value;
        name_parts(lamp, given.name);
        std::ranges::move(lamp.parts, std::back_inserter(scene.objects));
        std::ranges::move(lamp.materials, std::back_inserter(scene.materials));
    }
}

}  // namespace

void build_look(Builder& builder) {
    add_parts_of_lamps(builder);
    add_used_materials(builder);
    lay_cloth(builder);
    add_lights(builder);
    const render::SceneDescription& scene = builder.shot.scene;
    const render::RenderSettings& settings = builder.file.render.settings;
    for (const Diagnostic& problem : render::find_problems(scene.lights)) {
        builder.report(problem);
    }
    if (settings.integrator == render::IntegratorKind::distributed) {
        for (const Diagnostic& problem :
             render::find_problems(settings.distributed, render::ray_branches(scene))) {
            builder.report(problem);
        }
    }
}

}  // namespace carom::pipeline::config
