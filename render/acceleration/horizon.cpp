#include "render/acceleration/horizon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Imath/ImathBox.h>

#include "render/geometry/ray.h"

namespace carom::render {
namespace {

constexpr std::size_t kFewTriangles = 1000;
constexpr float kCells = 1536;  // about
/// Cells: by how much triangles and cells are taken to be larger, for the rounding of coordinates.
constexpr float kMargin = 1e-3f;

template <class Visit>
void for_each_triangle(std::span<const MeshEntry> meshes, const Visit& visit) {
    for (const MeshEntry& entry : meshes) {
        for (const auto& corners : entry.mesh->triangles) {
            Imath::Box3f box;
            for (const auto corner : corners) {
                box.extendBy(V3f(entry.mesh->vertices[corner]));
            }
            visit(box);
        }
    }
}

Horizon empty_map(const Imath::Box3f& box) {
    const V3f size = box.size();
    Horizon map;
    if (!(size.x > 0 && size.y > 0)) {
        return map;
    }
    map.x = box.min.x;
    map.y = box.min.y;
    map.cells_per_metre = std::sqrt(kCells / (size.x * size.y));
    const float most = kCells;  // of a very long row
    map.width = static_cast<int>(std::min(std::floor(size.x * map.cells_per_metre) + 1, most));
    map.height = static_cast<int>(std::min(std::floor(size.y * map.cells_per_metre) + 1, most));
    map.cells_per_metre = std::min({map.cells_per_metre, static_cast<float>(map.width) / size.x,
                                    static_cast<float>(map.height) / size.y});
    map.top.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                   box.min.z);
    return map;
}

void raise(Horizon& map, const Imath::Box3f& box) {
    const auto cell = [&](float place, float corner, float margin, int count) {
        const float at = std::floor((place - corner) * map.cells_per_metre + margin);
        return static_cast<int>(std::clamp(at, 0.f, static_cast<float>(count - 1)));
    };
    const int x_end = cell(box.max.x, map.x, kMargin, map.width);
    const int y_end = cell(box.max.y, map.y, kMargin, map.height);
    for (int y = cell(box.min.y, map.y, -kMargin, map.height); y <= y_end; ++y) {
        for (int x = cell(box.min.x, map.x, -kMargin, map.width); x <= x_end; ++x) {
            float& top = map.top[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                                 static_cast<std::size_t>(x)];
            top = std::max(top, box.max.z);
        }
    }
}

/// Squared distances, in cells, of a cell from those that are 0, 1, 2 ... rows or columns away.
std::vector<float> squared_gaps(int count) {
    std::vector<float> gaps(static_cast<std::size_t>(count));
    for (std::size_t i = 2; i < gaps.size(); ++i) {
        const float gap = static_cast<float>(i - 1) - kMargin;
        gaps[i] = gap * gap;
    }
    return gaps;
}

/// The largest squared slope from a cell to what stands in a row `gap2` away from it.
float slope2_to_row(const float* row, int width, int x, float top, float gap2,
                    const std::vector<float>& gaps) {
    float steepest = 0;
    for (int other = 0; other < width; ++other) {
        const float rise = std::max(row[other] - top, 0.f);
        const float distance2 = gap2 + gaps[static_cast<std::size_t>(std::abs(other - x))];
        const float slope2 = rise > 0 ? rise * rise / distance2 : 0.f;
        steepest = std::max(steepest, slope2);
    }
    return steepest;
}

void find_slopes(Horizon& map) {
    const std::vector<float> gaps = squared_gaps(std::max(map.width, map.height));
    const float per_metre2 = map.cells_per_metre * map.cells_per_metre;
    map.slope2.reserve(map.top.size());
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const float top = map.top[map.slope2.size()];
            float steepest = 0;
            for (int other = 0; other < map.height; ++other) {
                const float* row = map.top.data() + static_cast<std::ptrdiff_t>(other) * map.width;
                const float gap2 = gaps[static_cast<std::size_t>(std::abs(other - y))];
                steepest = std::max(steepest, slope2_to_row(row, map.width, x, top, gap2, gaps));
            }
            map.slope2.push_back(steepest * per_metre2 * (1 + kMargin) + kMargin * kMargin);
        }
    }
}

}  // namespace

Horizon make_horizon(std::span<const MeshEntry> meshes) {
    Imath::Box3f all;
    std::size_t count = 0;
    for_each_triangle(meshes, [&](const Imath::Box3f& box) {
        all.extendBy(box);
        count += 1;
    });
    if (count < kFewTriangles) {
        return {};
    }
    Horizon map = empty_map(all);
    if (map.width > 0) {
        for_each_triangle(meshes, [&](const Imath::Box3f& box) { raise(map, box); });
        find_slopes(map);
    }
    return map;
}

}  // namespace carom::render
