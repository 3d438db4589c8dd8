#include "pipeline/shot/table_scene.h"

#include <string>
#include <utility>

#include "pipeline/shot/default_look.h"

namespace carom::pipeline {

namespace {

render::ObjectDescription make_object(const sim::billiards::Surface& surface) {
    render::MeshShape mesh;
    mesh.vertices = surface.vertices;
    mesh.normals = surface.normals;
    mesh.uv = surface.uv;
    mesh.triangles = surface.triangles;
    render::ObjectDescription object;
    object.name = "table/" + surface.name;
    object.shape = std::move(mesh);
    object.material = std::string(material_of(surface.part));
    return object;
}

}  // namespace

void add_table(render::SceneDescription& scene, const sim::billiards::TableMeasures& measures,
               const sim::billiards::TableGeometry& geometry) {
    for (const sim::billiards::Surface& surface : geometry.surfaces) {
        scene.objects.push_back(make_object(surface));
    }
    if (!measures.has_cushions) {
        return;
    }
    render::ObjectDescription floor;
    floor.name = "table/floor";
    floor.shape = render::PlaneShape{};
    floor.world_from_object.setTranslation(Vec3(0, 0, -measures.height));
    floor.material = "floor";
    scene.objects.push_back(std::move(floor));
}

}  // namespace carom::pipeline
