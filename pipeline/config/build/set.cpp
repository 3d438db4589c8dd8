#include <algorithm>

#include <Imath/ImathBox.h>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

/// Around the table, or a small one around the origin without a table.
render::FarRegion region_of(const Builder& builder, const SetSection& section) {
    render::FarRegion region;
    region.distance = section.near;
    region.cell = section.cell;
    region.samples = section.samples;
    region.file = section.light;
    if (builder.shot.world.table) {
        const sim::billiards::TableMeasures& table = *builder.shot.world.table;
        const double edge = table.cushion_width + table.rail_width;
        region.high = Vec3(table.length / 2 + edge, table.width / 2 + edge, table.rail_height);
        region.low = Vec3(-region.high.x, -region.high.y, -table.height);
    }
    return region;
}

bool shines(const render::SceneDescription& scene, const std::string& material) {
    const auto found =
        std::ranges::find(scene.materials, material, &render::MaterialDescription::name);
    if (found == scene.materials.end()) {
        return false;
    }
    const auto* constant = std::get_if<Vec3>(&found->surface.emission);
    return found->phong ? found->phong->emission != Vec3(0, 0, 0)
                        : constant == nullptr || *constant != Vec3(0, 0, 0);
}

/// As FarGrid (render/light/far_light.h) has it.
bool is_far(const render::FarRegion& region, const Vec3& place) {
    const Vec3 around(region.distance);
    return !Imath::Box3d(region.low - around, region.high + around).intersects(place);
}

/// The room's light does not follow what moves.
void refuse_moving_lamps(Builder& builder, const render::FarRegion& region) {
    for (const Named<ObjectSection>& object : builder.file.objects) {
        const std::string& material = object.value.material.value_or("");
        if (object.value.motion && shines(builder.shot.scene, material) &&
            is_far(region, object.value.at)) {
            builder.reader.error(
                builder.place_of({"objects", object.name, "motion"}),
                "object " + quote(object.name) +
                    " shines and moves, which the light of the set's far surfaces cannot follow; "
                    "it is computed once. With a larger 'near' of the set the object is not far");
        }
    }
}

}  // namespace

void build_set(Builder& builder) {
    if (!builder.file.set) {
        return;
    }
    const render::FarRegion region = region_of(builder, *builder.file.set);
    builder.shot.scene.far = region;
    refuse_moving_lamps(builder, region);
}

}  // namespace carom::pipeline::config
