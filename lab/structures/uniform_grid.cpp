#include "lab/structures/uniform_grid.h"

namespace carom::render {
namespace {

constexpr double kCellsPerShape = 4;
constexpr double kMostPerAxis = 512;

}  // namespace

UniformGrid::UniformGrid(const Primitives& primitives, const StructureSizes& sizes) {
    const std::vector<Imath::Box3f> boxes = swept_boxes(primitives);
    for (const Imath::Box3f& box : boxes) {
        bounds_.extendBy(box);
    }
    if (boxes.empty()) {
        return;
    }
    const Vec3 size(bounds_.size());
    const double volume = std::max(size.x * size.y * size.z, 1e-30);
    const double density = sizes.grid_density > 0 ? sizes.grid_density : kCellsPerShape;
    const double edge = std::cbrt(volume / (density * static_cast<double>(boxes.size())));
    std::size_t cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        count_[k] = static_cast<int>(std::clamp(size[axis] / edge, 1.0, kMostPerAxis));
        edge_[k] = std::max(size[axis], 1e-30) / count_[k];
        cells *= static_cast<std::size_t>(count_[k]);
    }
    // Two passes: the first counts the shapes of each cell, the second lists them.
    first_.assign(cells + 1, 0);
    const auto for_each_cell = [&](const Imath::Box3f& box, const auto& work) {
        std::array<int, 3> low{};
        std::array<int, 3> high{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            low[k] = index_of(axis, static_cast<double>(box.min[axis]));
            high[k] = index_of(axis, static_cast<double>(box.max[axis]));
        }
        for (int z = low[2]; z <= high[2]; ++z) {
            for (int y = low[1]; y <= high[1]; ++y) {
                for (int x = low[0]; x <= high[0]; ++x) {
                    work(cell_at({x, y, z}));
                }
            }
        }
    };
    for (const Imath::Box3f& box : boxes) {
        for_each_cell(box, [&](std::size_t cell) { first_[cell + 1] += 1; });
    }
    for (std::size_t cell = 0; cell < cells; ++cell) {
        first_[cell + 1] += first_[cell];
    }
    shapes_.resize(first_.back());
    std::vector<std::uint32_t> filled(first_.begin(), first_.end() - 1);
    for (std::uint32_t shape = 0; shape < boxes.size(); ++shape) {
        for_each_cell(boxes[shape], [&](std::size_t cell) { shapes_[filled[cell]++] = shape; });
    }
}

}  // namespace carom::render
