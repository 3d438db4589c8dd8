#include "render/acceleration/triangle_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "render/acceleration/embree_handles.h"
#include "render/acceleration/safe_ray.h"

namespace carom::render {

struct TriangleScene::Data {
    // Members are destroyed from the last to the first: the scene before its device.
    std::shared_ptr<const EmbreeDevice> device;
    std::vector<std::uint32_t> objects;  // by Embree's geometry ID
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
    commit_on_this_thread(*data_->device, data_->scene.get());
}

TriangleScene::~TriangleScene() = default;

std::size_t TriangleScene::bytes() const {
    return data_->device->bytes();
}

bool TriangleScene::closest_hit(const Ray& ray, Hit& hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    query.ray = to_embree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data_->scene.get(), &context, &query);
    // Embree's interval is closed, that of closest_hit open.
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
    return query.tfar < 0;  // Embree marks an occluded ray with minus infinity
}

PacketMask TriangleScene::any_hits(const ShadowRayPacket& packet, PacketMask asked) const {
    static_assert(ShadowRayPacket::kMost == 8);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRay8 query{};
    alignas(32) int valid[ShadowRayPacket::kMost];
    for (int i = 0; i < ShadowRayPacket::kMost; ++i) {
        valid[i] = (asked >> i & 1u) != 0 ? -1 : 0;
        query.org_x[i] = packet.origin.x;
        query.org_y[i] = packet.origin.y;
        query.org_z[i] = packet.origin.z;
        query.time[i] = packet.time;
        query.mask[i] = ~0u;
    }
    std::copy_n(packet.direction[0], ShadowRayPacket::kMost, query.dir_x);
    std::copy_n(packet.direction[1], ShadowRayPacket::kMost, query.dir_y);
    std::copy_n(packet.direction[2], ShadowRayPacket::kMost, query.dir_z);
    std::copy_n(packet.t_max, ShadowRayPacket::kMost, query.tfar);
    rtcOccluded8(valid, data_->scene.get(), &context, &query);
    PacketMask hits = 0;
    for (int i = 0; i < packet.count; ++i) {
        hits |= valid[i] != 0 && query.tfar[i] < 0 ? PacketMask{1} << i : 0;
    }
    return hits;
}

// Collects the rays to be tested into packets of eight.
void TriangleScene::test_occlusion(const RayBatch& rays, float* t_max) const {
    constexpr int kPacket = 8;
    RTCRay8 query{};
    alignas(32) int valid[kPacket];
    int index[kPacket];
    int count = 0;
    const auto ask = [&] {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (int i = 0; i < kPacket; ++i) {
            valid[i] = i < count ? -1 : 0;
        }
        rtcOccluded8(valid, data_->scene.get(), &context, &query);
        for (int i = 0; i < count; ++i) {
            t_max[index[i]] = query.tfar[i] < 0 ? 0 : t_max[index[i]];
        }
        count = 0;
    };
    for (int i = 0; i < rays.count; ++i) {
        if (t_max[i] <= 0 || !is_traceable(rays.ray(i, t_max[i]))) {
            continue;
        }
        index[count] = i;
        query.org_x[count] = rays.origin[0][i];
        query.org_y[count] = rays.origin[1][i];
        query.org_z[count] = rays.origin[2][i];
        query.dir_x[count] = rays.direction[0][i];
        query.dir_y[count] = rays.direction[1][i];
        query.dir_z[count] = rays.direction[2][i];
        query.tnear[count] = 0;
        query.tfar[count] = t_max[i];
        query.time[count] = rays.time[i];
        query.mask[count] = ~0u;
        count += 1;
        if (count == kPacket) {
            ask();
        }
    }
    if (count > 0) {
        ask();
    }
}

std::shared_ptr<const EmbreeDevice> make_embree_device() {
    return std::make_shared<const EmbreeDevice>();
}

}  // namespace carom::render
