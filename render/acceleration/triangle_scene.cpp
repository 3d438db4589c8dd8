#include "render/acceleration/triangle_scene.h"

#include <algorithm>

namespace carom::render {

TriangleScene::TriangleScene(std::span<const MeshEntry> meshes)
    : kernels_(best_triangle_batch_kernels()), tree_(make_triangle_tree(meshes)) {}

bool TriangleScene::closest_hit(const Ray& ray, Hit& hit) const {
    return kernels_.closest_of_ray(tree_, ray, hit);
}

bool TriangleScene::any_hit(const Ray& ray) const {
    return kernels_.any_of_ray(tree_, ray);
}

PacketMask TriangleScene::any_hits(const ShadowRayPacket& packet, PacketMask asked) const {
    constexpr int kRoom = ShadowRayPacket::kMost + RayBatch::kBeyond;
    float origin[3][kRoom];
    float direction[3][kRoom] = {};
    float time[kRoom];
    float t_max[kRoom] = {};
    RayBatch rays{packet.count, {}, {}, time, RayKind::shadow};
    std::fill_n(time, kRoom, packet.time);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::fill_n(origin[axis], kRoom, packet.origin[static_cast<int>(axis)]);
        std::copy_n(packet.direction[axis], ShadowRayPacket::kMost, direction[axis]);
        rays.origin[axis] = origin[axis];
        rays.direction[axis] = direction[axis];
    }
    for (int i = 0; i < packet.count; ++i) {
        t_max[i] = (asked >> i & 1u) != 0 ? packet.t_max[i] : 0;
    }
    kernels_.occlude(tree_, rays, t_max);
    PacketMask hits = 0;
    for (int i = 0; i < packet.count; ++i) {
        const bool is_asked = (asked >> i & 1u) != 0;
        hits |= is_asked && t_max[i] == 0 ? PacketMask{1} << i : 0;
    }
    return hits;
}

void TriangleScene::closest_hits(const RayBatch& rays, const HitArrays& hits) const {
    kernels_.closest(tree_, rays, hits);
}

void TriangleScene::test_occlusion(const RayBatch& rays, float* t_max) const {
    kernels_.occlude(tree_, rays, t_max);
}

}  // namespace carom::render
