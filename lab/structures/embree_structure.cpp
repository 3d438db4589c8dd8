#include "lab/structures/embree_structure.h"

#include <utility>
#include <vector>

#include "lab/structures/embree_user_shapes.h"
#include "render/acceleration/mesh_entry.h"
#include "render/acceleration/safe_ray.h"

namespace carom::render {

std::shared_ptr<const EmbreeDevice> make_embree_device() {
    return std::make_shared<const EmbreeDevice>();
}

struct EmbreeStructure::Data {
    explicit Data(Primitives all) : shapes(std::move(all)) {}

    // Members are destroyed from the last to the first: the scene before what it refers to.
    std::shared_ptr<const EmbreeDevice> device;
    std::vector<std::uint32_t> mesh_objects;  // by Embree's geometry ID
    Primitives shapes;
    SceneHandle scene;

    [[nodiscard]] Hit to_hit(const RTCRayHit& query) const {
        Hit hit{query.ray.tfar, kNoObject, query.hit.primID, query.hit.u, query.hit.v};
        if (query.hit.geomID < mesh_objects.size()) {
            hit.object = mesh_objects[query.hit.geomID];
        } else {
            hit.object = shapes.bounded()[query.hit.primID].object;
            hit.primitive = __builtin_bit_cast(std::uint32_t, query.hit.Ng_x);
        }
        return hit;
    }
};

EmbreeStructure::EmbreeStructure(std::shared_ptr<const EmbreeDevice> device, const ShapeSet& shapes,
                                 std::span<const MeshEntry> meshes)
    : data_(std::make_unique<Data>(Primitives(shapes))) {
    data_->device = std::move(device);
    data_->scene.reset(rtcNewScene(data_->device->get()));
    data_->device->check("making a scene");
    unsigned id = 0;
    for (const MeshEntry& entry : meshes) {
        const GeometryHandle geometry = make_triangle_geometry(*data_->device, *entry.mesh);
        rtcAttachGeometryByID(data_->scene.get(), geometry.get(), id++);
        data_->mesh_objects.push_back(entry.object);
    }
    if (!data_->shapes.bounded().empty()) {
        const GeometryHandle geometry = make_user_geometry(*data_->device, data_->shapes);
        rtcAttachGeometryByID(data_->scene.get(), geometry.get(), id);
    }
    commit_on_this_thread(*data_->device, data_->scene.get());
}

EmbreeStructure::~EmbreeStructure() = default;

std::size_t EmbreeStructure::bytes() const {
    return data_->device->bytes();
}

bool EmbreeStructure::closest_hit(const Ray& ray, Hit& hit) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    QueryContext context;
    rtcInitIntersectContext(&context.embree);
    context.ray = &safe;
    RTCRayHit query;
    query.ray = to_embree(safe);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data_->scene.get(), &context.embree, &query);
    const bool found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID && query.ray.tfar < safe.t_max &&
                       query.ray.tfar > safe.t_min;
    Hit best = found ? data_->to_hit(query) : Hit{safe.t_max, kNoObject, 0, 0, 0};
    data_->shapes.find_closest_plane(safe, best);  // no hierarchy can hold infinite planes
    if (best.object == kNoObject) {
        return false;
    }
    hit = best;
    return true;
}

bool EmbreeStructure::any_hit(const Ray& ray) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    if (data_->shapes.first_plane_hit(safe) < data_->shapes.planes().size()) {
        return true;
    }
    QueryContext context;
    rtcInitIntersectContext(&context.embree);
    context.ray = &safe;
    RTCRay query = to_embree(safe);
    rtcOccluded1(data_->scene.get(), &context.embree, &query);
    return query.tfar < 0;
}

}  // namespace carom::render
