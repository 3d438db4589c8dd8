#include "render/acceleration/triangle_scene.h"

#include <utility>
#include <vector>

#include "render/acceleration/embree_handles.h"

namespace carom::render {

struct TriangleScene::Data {
    // The device outlives the scene: members are destroyed from the last to the first.
    std::shared_ptr<const EmbreeDevice> device;
    std::vector<std::uint32_t> objects;  // by Embree's geometry number
    SceneHandle scene;
};

TriangleScene::TriangleScene(std::shared_ptr<const EmbreeDevice> device,
                             std::span<const MeshEntry> meshes)
    : data_(std::make_unique<Data>()) {
    data_->device = std::move(device);
    data_->scene.reset(rtcNewScene(data_->device->get()));
    data_->device->check("making a scene");
    for (const MeshEntry& entry : meshes) {
        const GeometryHandle geometry = make_triangle_geometry(*data_->device, *entry.mesh);
        rtcAttachGeometryByID(data_->scene.get(), geometry.get(),
                              static_cast<unsigned>(data_->objects.size()));
        data_->objects.push_back(entry.object);
    }
    commit_alone(*data_->device, data_->scene.get());
}

TriangleScene::~TriangleScene() = default;

bool TriangleScene::closest_hit(const Ray& ray, Hit& hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    query.ray = to_embree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data_->scene.get(), &context, &query);
    // Embree's interval is closed, ours is open.
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID || !(query.ray.tfar < ray.t_max) ||
        !(query.ray.tfar > ray.t_min)) {
        return false;
    }
    hit = {query.ray.tfar, data_->objects[query.hit.geomID], query.hit.primID, query.hit.u,
           query.hit.v};
    return true;
}

bool TriangleScene::any_hit(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = to_embree(ray);
    rtcOccluded1(data_->scene.get(), &context, &query);
    return query.tfar < 0;  // Embree's mark: minus infinity
}

std::shared_ptr<const EmbreeDevice> make_embree_device() {
    return std::make_shared<const EmbreeDevice>();
}

}  // namespace carom::render
