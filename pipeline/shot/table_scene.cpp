#include "pipeline/shot/table_scene.h"

#include <string>
#include <utility>

#include "pipeline/shot/default_look.h"

namespace carom::pipeline {

namespace {

/// The object's x axis along the grain, its z axis upwards.
Mat44 world_from_board(const sim::billiards::Board& board) {
    const Vec3& along = board.grain;
    const Vec3 across = Vec3(0, 0, 1).cross(along);
    Mat44 matrix(along.x, along.y, along.z, 0, across.x, across.y, across.z, 0, 0, 0, 1, 0, 0, 0, 0,
                 1);
    matrix[3][0] = board.origin.x;
    matrix[3][1] = board.origin.y;
    matrix[3][2] = board.origin.z;
    return matrix;
}

/// Wood is a texture in the object's axes, so a board is an object in those of its trunk.
void cut_from_trunk(render::MeshShape& mesh, const sim::billiards::Board& board) {
    const Vec3& along = board.grain;
    const Vec3 across = Vec3(0, 0, 1).cross(along);
    const auto in_board = [&](const Vec3& v) { return Vec3(v.dot(along), v.dot(across), v.z); };
    for (Vec3& vertex : mesh.vertices) {
        vertex = in_board(vertex - board.origin);
    }
    for (Vec3& normal : mesh.normals) {
        normal = in_board(normal);
    }
}

render::ObjectDescription make_object(const sim::billiards::Surface& surface) {
    render::MeshShape mesh;
    mesh.vertices = surface.vertices;
    mesh.normals = surface.normals;
    mesh.uv = surface.uv;
    mesh.triangles = surface.triangles;
    render::ObjectDescription object;
    if (surface.board) {
        cut_from_trunk(mesh, *surface.board);
        object.world_from_object = world_from_board(*surface.board);
    }
    object.name = "table/" + surface.name;
    object.shape = std::move(mesh);
    object.material = std::string(material_of(surface.part));
    return object;
}

}  // namespace

void add_table(render::SceneDescription& scene, const sim::billiards::TableMeasures& measures,
               const std::vector<sim::billiards::Surface>& surfaces) {
    for (const sim::billiards::Surface& surface : surfaces) {
        scene.objects.push_back(make_object(surface));
    }
    if (!measures.has_cushions) {
        return;
    }
    render::ObjectDescription floor;
    floor.name = kFloorName;
    floor.shape = render::PlaneShape{};
    floor.world_from_object.setTranslation(Vec3(0, 0, -measures.height));
    floor.material = "floor";
    scene.objects.push_back(std::move(floor));
}

}  // namespace carom::pipeline
