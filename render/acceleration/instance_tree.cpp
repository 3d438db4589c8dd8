#include "render/acceleration/instance_tree.h"

#include <set>

namespace carom::render {

InstanceTree make_instance_tree(const std::vector<MeshInstance>& instances) {
    InstanceTree result;
    std::vector<MovingBounds> bounds;
    bounds.reserve(instances.size());
    for (const MeshInstance& instance : instances) {
        bounds.push_back({instance.bounds, instance.bounds});
        result.bounds.extendBy(instance.bounds);
    }
    result.tree = build_wide_tree(bounds, 1);
    result.instances.reserve(instances.size());
    for (const WideLeaf& leaf : result.tree.leaves) {
        result.instances.push_back(instances[result.tree.order[leaf.first]]);
    }
    return result;
}

std::size_t bytes_of(const InstanceTree& tree) {
    std::size_t sum = bytes_of(tree.tree) + tree.instances.size() * sizeof(MeshInstance);
    std::set<const TriangleTree*> counted;
    for (const MeshInstance& instance : tree.instances) {
        if (counted.insert(instance.mesh.get()).second) {
            sum += bytes_of(*instance.mesh);
        }
    }
    return sum;
}

}  // namespace carom::render
