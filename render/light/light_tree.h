// A tree over many lights, or over the faces of one.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/geometry/constants.h"
#include "render/light/light_constants.h"

namespace carom::render {

/// Where light comes from, and whereto: it leaves the box in directions within `reach` of a normal
/// that is within `spread` of the unit `axis` (rad).
struct LightBounds {
    Imath::Box3f box;
    V3f axis{0, 0, 1};
    float spread = kPi;
    float reach = 0.5f * kPi;
    float strength = 0;  // luminance times area, as seen along a normal

    /// Of both.
    [[nodiscard]] LightBounds with(const LightBounds& other) const;
};

/// A tree that splits lights where the sum over both halves of strength, surface and cone of
/// directions is least (Conty Estevez and Kulla 2018, "Importance sampling of many lights with
/// adaptive tree splitting", section 4). Why this tree: its bounds are 0 only where nothing
/// arrives, so that no light is lost; it knows nothing of the receiver's material, which later
/// trees of spherical Gaussians do (Tokuyoshi et al. 2024, "Hierarchical light sampling with
/// accurate spherical Gaussian lighting") at several times the arithmetic of a node, and gloss is
/// found by scattering here. Nodes have many children instead of two: the estimates of large nodes
/// near a place, which are vague, are never asked for. The root has most, as all lanes of a vector
/// share them, and all samples of a vertex; stratified samples (make_wave_scene.cpp) stand for
/// adaptive splitting, which sends another number of rays from each vertex. Immutable.
class LightTree {
  public:
    LightTree() = default;
    /// Lights without strength are left out.
    explicit LightTree(const std::vector<LightBounds>& lights);

    [[nodiscard]] bool exists() const { return !numbers_.empty(); }
    /// Of all lights; the tree must exist.
    [[nodiscard]] const LightBounds& bounds() const { return bounds_; }
    /// For kernels/light_tree.h; valid as long as the tree is.
    [[nodiscard]] LightTreeData data() const;

  private:
    struct Entry {
        LightBounds bounds;
        std::int32_t light;
    };
    struct Group {
        std::span<Entry> entries;
        LightBounds bounds;
    };
    [[nodiscard]] static Group group_of(std::span<Entry> entries);
    [[nodiscard]] static std::pair<Group, Group> halves(const Group& group);
    void add(const Group& group, const Entry* first, std::int32_t parent);
    void build(std::size_t node, const Group& group, const Entry* first, std::size_t most_children);

    LightBounds bounds_;
    std::vector<float> numbers_;  // of the nodes
    std::vector<float> strength_before_;
    std::vector<std::int32_t> first_child_, children_, first_light_, last_light_, parents_, lights_,
        leaf_of_light_;
    bool shines_all_around_ = false;
};

}  // namespace carom::render
