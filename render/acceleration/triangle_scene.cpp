#include "render/acceleration/triangle_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Imath/ImathBox.h>

namespace carom::render {

namespace {

// The table's, which has a horizon, and one for all that is apart from it: each further tree costs
// every ray a test of its box (with one for each of four lamps a frame of a table takes a tenth
// longer).
constexpr std::size_t kMostTrees = 2;

/// Meshes whose boxes touch, directly or through others.
struct Cluster {
    std::vector<MeshEntry> meshes;
    Imath::Box3f box;
    std::size_t triangles = 0;

    void add(const Cluster& other) {
        meshes.insert(meshes.end(), other.meshes.begin(), other.meshes.end());
        box.extendBy(other.box);
        triangles += other.triangles;
    }
};

Cluster cluster_of(const MeshEntry& entry) {
    Cluster cluster{{entry}, {}, entry.mesh->triangles.size()};
    for (const auto& vertex : entry.mesh->vertices) {
        cluster.box.extendBy(V3f(vertex));
    }
    return cluster;
}

/// The largest first; at most kMostTrees, the last of which has all that is left.
std::vector<Cluster> clusters_of(std::span<const MeshEntry> meshes) {
    std::vector<Cluster> clusters;
    for (const MeshEntry& entry : meshes) {
        Cluster cluster = cluster_of(entry);
        // What the growing box touches may be behind others in the list.
        for (auto other = clusters.begin(); other != clusters.end();) {
            if (other->box.intersects(cluster.box)) {
                other->add(cluster);
                cluster = std::move(*other);
                clusters.erase(other);
                other = clusters.begin();
            } else {
                ++other;
            }
        }
        clusters.push_back(std::move(cluster));
    }
    std::stable_sort(clusters.begin(), clusters.end(),
                     [](const Cluster& a, const Cluster& b) { return a.triangles > b.triangles; });
    while (clusters.size() > kMostTrees) {
        clusters[kMostTrees - 1].add(clusters.back());
        clusters.pop_back();
    }
    return clusters;
}

}  // namespace

TriangleScene::TriangleScene(std::span<const MeshEntry> meshes)
    : kernels_(best_triangle_batch_kernels()) {
    for (const Cluster& cluster : clusters_of(meshes)) {
        trees_.push_back(make_triangle_tree(cluster.meshes));
        trees_.back().horizon = make_horizon(cluster.meshes);
    }
}

std::size_t TriangleScene::bytes() const {
    std::size_t sum = 0;
    for (const TriangleTree& tree : trees_) {
        sum += bytes_of(tree);
    }
    return sum;
}

bool TriangleScene::closest_hit(const Ray& ray, Hit& hit) const {
    Ray remaining = ray;
    bool is_hit = false;
    for (const TriangleTree& tree : trees_) {
        Hit other;
        if (!kernels_.closest_of_ray(tree, remaining, other)) {
            continue;
        }
        const bool is_first =
            !is_hit || other.t < hit.t || (other.t == hit.t && other.object < hit.object);
        if (is_first) {
            hit = other;
            is_hit = true;
            // So that a hit at the same distance is still found.
            remaining.t_max = std::min(ray.t_max, std::nextafter(hit.t, kInfinity));
        }
    }
    return is_hit;
}

bool TriangleScene::any_hit(const Ray& ray) const {
    return std::any_of(trees_.begin(), trees_.end(),
                       [&](const TriangleTree& tree) { return kernels_.any_of_ray(tree, ray); });
}

void TriangleScene::closest_hits(const RayBatch& rays, const HitArrays& hits) const {
    for (const TriangleTree& tree : trees_) {
        kernels_.closest(tree, rays, hits);
    }
}

void TriangleScene::test_occlusion(const RayBatch& rays, float* t_max) const {
    for (const TriangleTree& tree : trees_) {
        kernels_.occlude(tree, rays, t_max);
    }
}

}  // namespace carom::render
