#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/shot/default_look.h"

namespace carom::pipeline::config {

namespace {

/// The built-in materials, with the look's own laid over them by name.
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

/// Only what is seen: a frame's key must not change with a material that nothing has.
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

void add_lights(Builder& builder) {
    std::vector<render::LightDescription>& lights = builder.shot.scene.lights;
    const std::optional<sim::billiards::TableMeasures>& table = builder.shot.world.table;
    if (builder.file.lights.empty()) {
        lights = default_lights(table ? &*table : nullptr);
        return;
    }
    const Named<LightSection>* environment = nullptr;
    for (const Named<LightSection>& given : builder.file.lights) {
        if (given.value.environment && environment != nullptr) {
            builder.reader.error(given.place, "light '" + given.name +
                                                  "' is a second environment; the first is '" +
                                                  environment->name + "'");
        } else if (given.value.environment) {
            environment = &given;
        }
        render::LightDescription light = to_light(given.value);
        light.name = given.name;
        lights.push_back(std::move(light));
    }
}

bool is_black(const Vec3& colour) {
    return colour == Vec3(0, 0, 0);
}

void check_ray_tree(Builder& builder) {
    bool reflects = false;
    bool refracts = false;
    for (const render::MaterialDescription& material : builder.shot.scene.materials) {
        const render::StandardMaterial& surface = material.surface;
        const bool transmits = material.phong && !is_black(material.phong->transmittance);
        refracts = refracts || transmits;
        reflects = reflects || transmits ||
                   (material.phong ? !is_black(material.phong->reflectance)
                                   : surface.metal > 0 || surface.coat.weight > 0);
    }
    const double rays =
        render::rays_per_camera_ray(builder.file.render.settings.distributed,
                                    builder.shot.scene.lights.size(), reflects, refracts);
    if (rays > render::kMostRaysPerCameraRay) {
        std::ostringstream text;
        text << "one camera ray could branch into " << rays << " rays; at most "
             << render::kMostRaysPerCameraRay
             << " are possible: lower 'recursion_limit' or the samples of 'distributed'";
        builder.reader.error(builder.place_of({"render", "distributed"}), text.str());
    }
}

}  // namespace

void build_look(Builder& builder) {
    add_used_materials(builder);
    add_lights(builder);
    if (builder.file.render.settings.integrator == render::IntegratorKind::distributed) {
        check_ray_tree(builder);
    }
}

}  // namespace carom::pipeline::config
