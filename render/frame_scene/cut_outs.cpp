#include "render/frame_scene/cut_outs.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "render/frame_scene/frame_scene.h"

namespace carom::render {
namespace {

/// A ray goes on behind a surface that it passed: farther than the distances of the same hit by
/// different code differ.
constexpr float kBehind = 1 + 0x1p-20f;

std::uint32_t mixed(std::uint32_t hash, std::uint32_t next) {
    // Of MurmurHash3 (Appleby 2011): a block, and its finaliser.
    hash ^= next * 0xcc9e2d51U;
    hash = std::rotl(hash, 13) * 5 + 0xe6546b64U;
    hash ^= hash >> 16U;
    hash *= 0x85ebca6bU;
    hash ^= hash >> 13U;
    hash *= 0xc2b2ae35U;
    return hash ^ hash >> 16U;
}

/// In [0, 1).
float number_of(const Ray& ray, const Hit& hit) {
    std::uint32_t hash = mixed(hit.object, hit.primitive);
    for (int k = 0; k < 3; ++k) {
        hash = mixed(hash, std::bit_cast<std::uint32_t>(ray.origin[k]));
        hash = mixed(hash, std::bit_cast<std::uint32_t>(ray.direction[k]));
    }
    hash = mixed(hash, std::bit_cast<std::uint32_t>(ray.time));
    // A closed surface is met twice.
    hash = mixed(hash, std::bit_cast<std::uint32_t>(hit.t));
    return static_cast<float>(hash >> 8U) * 0x1p-24f;
}

}  // namespace

bool CutOutStructure::passes(const Ray& ray, const Hit& hit) const {
    const std::uint32_t material = scene_.material(hit.object);
    if (material == kNoMaterial || !cut_outs_.is_cut_out(material)) {
        return false;
    }
    return number_of(ray, hit) >= cut_outs_.opacity(scene_.surface_at(ray, hit));
}

/// Whether the ray reaches what is cut out. Its slab test (Kay and Kajiya 1986) takes NaN, of rays
/// within a slab's plane, as a hit.
bool CutOutStructure::may_pass(const Ray& ray) const {
    float enters = ray.t_min;
    float leaves = ray.t_max;
    for (int k = 0; k < 3; ++k) {
        const float a = (bounds_.min[k] - ray.origin[k]) / ray.direction[k];
        const float b = (bounds_.max[k] - ray.origin[k]) / ray.direction[k];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    return !(enters > leaves * kBehind);
}

/// The nearest hit of the ray that meets a surface, from its t_min on.
bool CutOutStructure::next_hit(Ray ray, Hit& hit) const {
    Hit found;
    while (whole_.closest_hit(ray, found)) {
        if (!passes(ray, found)) {
            hit = found;
            return true;
        }
        ray.t_min = std::max(found.t * kBehind, ray.t_min);
        found = Hit{};
    }
    return false;
}

bool CutOutStructure::closest_hit(const Ray& ray, Hit& hit) const {
    return next_hit(ray, hit);
}

bool CutOutStructure::any_hit(const Ray& ray) const {
    Hit hit;
    return whole_.any_hit(ray) && (!may_pass(ray) || next_hit(ray, hit));
}

void CutOutStructure::closest_hits(const RayBatch& rays, Hit* hits) const {
    whole_.closest_hits(rays, hits);
    for (int i = 0; i < rays.count; ++i) {
        if (hits[i].object == kNoObject) {
            continue;
        }
        Ray ray = rays.ray(i, kInfinity);
        if (!passes(ray, hits[i])) {
            continue;
        }
        ray.t_min = hits[i].t * kBehind;
        hits[i] = Hit{};
        static_cast<void>(next_hit(ray, hits[i]));
    }
}

void CutOutStructure::test_occlusion(const RayBatch& rays, float* t_max) const {
    const std::vector<float> before(t_max, t_max + rays.count);
    whole_.test_occlusion(rays, t_max);
    for (int i = 0; i < rays.count; ++i) {
        const float end = before[static_cast<std::size_t>(i)];
        if (!(end > 0) || t_max[i] > 0) {
            continue;
        }
        const Ray ray = rays.ray(i, end);
        Hit hit;
        if (may_pass(ray) && !next_hit(ray, hit)) {
            t_max[i] = end;
        }
    }
}

}  // namespace carom::render
