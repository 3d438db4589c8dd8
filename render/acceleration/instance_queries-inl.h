// Queries of trees of instances: each leaf is a mesh, whose own tree is searched with the rays in
// its axes. Included once per instruction set.
#include "render/acceleration/instance_tree.h"
#include "render/acceleration/triangle_queries-inl.h"
#include "render/geometry/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Rays in the axes of a mesh. Distances stay what they are, the lengths of directions do not.
template <class L>
HWY_INLINE RayOf<L> in_mesh(const MeshInstance& instance, RayOf<L> ray, ValueOf<L> time) {
    if (instance.motion) {
        ray = pose_at<L>(instance.motion->pieces(), time).in_body(ray);
    }
    return instance.mesh_from_body ? affine_of<L>(*instance.mesh_from_body).ray(ray) : ray;
}

HWY_INLINE Ray in_mesh(const MeshInstance& instance, const Ray& ray) {
    using L = ScalarLanes<float>;
    const RayOf<L> line =
        in_mesh<L>(instance, {all_of<L>(ray.origin), all_of<L>(ray.direction)}, L::all(ray.time));
    Ray local = ray;
    local.origin = V3f(line.origin.x, line.origin.y, line.origin.z);
    local.direction = V3f(line.direction.x, line.direction.y, line.direction.z);
    return local;
}

/// Searches an instance's mesh with one of its queries. What is in the mesh counts from where the
/// ray enters the instance's box, so that the order in which instances are visited cannot matter.
template <Order kOrder, class Query>
void search_mesh(const SingleRay::Entry& entry, const float& limit, const Query& query,
                 const TriangleTree& mesh) {
    using L = ScalarLanes<float>;
    const V3f& origin = query.line.ray.origin;
    const V3f& direction = query.line.ray.direction;
    const SingleRay line(
        box_lines<L>({origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}),
        entry.enter, 0, limit);
    traverse<kOrder>(mesh.tree, line, {entry.enter, 0}, query);
}

/// The nearest hit of one ray.
struct ClosestInstanceOfRay {
    const InstanceTree& tree;
    Ray ray;
    NearestOfRay nearest;

    HWY_INLINE bool operator()(std::uint32_t leaf, const SingleRay::Entry& entry) const {
        const MeshInstance& instance = tree.instances[leaf];
        const NumberedTree mesh{*instance.mesh, static_cast<std::int32_t>(instance.object)};
        search_mesh<Order::nearest_first>(
            entry, nearest.limit, ClosestOfRay{mesh, SingleLine(in_mesh(instance, ray)), nearest},
            mesh.tree);
        return false;
    }
};

/// Occlusion of one ray, whose limit becomes -1.
struct AnyInstanceOfRay {
    const InstanceTree& tree;
    Ray ray;
    float& limit;

    HWY_INLINE bool operator()(std::uint32_t leaf, const SingleRay::Entry& entry) const {
        const MeshInstance& instance = tree.instances[leaf];
        search_mesh<Order::any>(entry, limit,
                                AnyOfRay{*instance.mesh, SingleLine(in_mesh(instance, ray)), limit},
                                *instance.mesh);
        return limit < 0;
    }
};

/// What both queries of packets share.
struct InstancePacketQuery {
    const InstanceTree& tree;
    PacketRays& rays;

    [[nodiscard]] HWY_INLINE Ray ray(int i) const {
        Ray ray = one_of(rays, i).ray;
        ray.time = rays.time[i];
        return ray;
    }

    /// Searches an instance's mesh with the query that `make(mesh, local_rays)` gives.
    template <class Make>
    HWY_INLINE void search(std::uint32_t leaf, const PacketRays::Entry& entry,
                           const Make& make) const {
        using L = PacketLanes;
        const PacketTag d;
        const MeshInstance& instance = tree.instances[leaf];
        const RayOf<L> line =
            in_mesh<L>(instance, {load_vector(rays.origin), load_vector(rays.direction)},
                       hn::Load(d, rays.time));
        PacketRays local;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::Store(line.origin[axis], d, local.origin[axis]);
            hn::Store(line.direction[axis], d, local.direction[axis]);
        }
        hn::Store(hn::Load(d, entry.enter), d, local.start);
        hn::Store(hn::Load(d, rays.limit), d, local.limit);
        local.prepare();
        const NumberedTree mesh{*instance.mesh, static_cast<std::int32_t>(instance.object)};
        const auto query = make(mesh, local);
        traverse<decltype(query)::kOrder>(mesh.tree.tree, local, local.root(), query);
        hn::Store(hn::Load(d, local.limit), d, rays.limit);
    }
};

/// Nearest hits of a packet; distances are the rays' limits.
struct ClosestInstanceOfPacket : InstancePacketQuery {
    PacketHits& hits;

    [[nodiscard]] HWY_INLINE ClosestInstanceOfRay of_one(int i) const {
        return {tree, ray(i), hits.of_one(i, rays.limit[i])};
    }
    HWY_INLINE bool operator()(std::uint32_t leaf, const PacketRays::Entry& entry) const {
        search(leaf, entry, [&](const NumberedTree& mesh, PacketRays& local) HWY_ATTR {
            return ClosestOfPacket{{mesh, local}, hits};
        });
        return false;
    }
};

/// Occlusion of a packet: limits become -1.
struct AnyInstanceOfPacket : InstancePacketQuery {
    [[nodiscard]] HWY_INLINE AnyInstanceOfRay of_one(int i) const {
        return {tree, ray(i), rays.limit[i]};
    }
    HWY_INLINE bool operator()(std::uint32_t leaf, const PacketRays::Entry& entry) const {
        search(leaf, entry, [](const NumberedTree& mesh, PacketRays& local) HWY_ATTR {
            return AnyOfPacket{{mesh, local}};
        });
        return false;
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
