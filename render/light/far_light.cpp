#include "render/light/far_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assert.h"
#include "core/splitmix.h"

namespace carom::render {
namespace {

constexpr int kPlaceBits = 14;
constexpr int kLevelBits = 3;
constexpr int kFaceBits = 3;
constexpr std::int64_t kMiddle = std::int64_t{1} << (kPlaceBits - 1);
constexpr std::uint64_t kPlaceMask = (std::uint64_t{1} << kPlaceBits) - 1;
constexpr std::uint32_t kNoCell = 0xffffffff;
/// Surfaces that face between two axes have a share of both: linear in the normal's part along the
/// axis, from this on.
constexpr float kLeastOfAxis = 0.5F;

std::uint64_t place_bits(int place) {
    return static_cast<std::uint64_t>(
               std::clamp<std::int64_t>(place + kMiddle, 0, 2 * kMiddle - 1)) &
           kPlaceMask;
}

}  // namespace

FarGrid::FarGrid(const FarRegion& region)
    : centre_(0.5 * (region.low + region.high)),
      half_size_(0.5 * (region.high - region.low)),
      near_(V3f(region.low) - V3f(static_cast<float>(region.distance)),
            V3f(region.high) + V3f(static_cast<float>(region.distance))),
      cell_(static_cast<float>(region.cell)),
      growth_(static_cast<float>(region.cell_growth)) {}

float FarGrid::distance(const V3f& position) const {
    const V3f d = position - centre_;
    const V3f outside(std::max(std::abs(d.x) - half_size_.x, 0.0F),
                      std::max(std::abs(d.y) - half_size_.y, 0.0F),
                      std::max(std::abs(d.z) - half_size_.z, 0.0F));
    return outside.length();
}

float FarGrid::way_out(const V3f& origin, const V3f& direction) const {
    float in = 0;
    float out = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < near_.min[axis] || origin[axis] > near_.max[axis]) {
                return 0;
            }
            continue;
        }
        const float a = (near_.min[axis] - origin[axis]) / direction[axis];
        const float b = (near_.max[axis] - origin[axis]) / direction[axis];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in < out ? out : 0;
}

int FarGrid::level(float distance) const {
    const float wanted = growth_ * distance;
    int level = 0;
    while (level < kMostLevel && side(level + 1) <= wanted) {
        level += 1;
    }
    return level;
}

std::uint64_t FarGrid::key(std::uint32_t object, int face, int level, const Imath::V3i& place) {
    std::uint64_t key = object;
    key = key << kFaceBits | static_cast<std::uint64_t>(face);
    key = key << kLevelBits | static_cast<std::uint64_t>(level);
    key = key << kPlaceBits | place_bits(place.z);
    key = key << kPlaceBits | place_bits(place.y);
    return key << kPlaceBits | place_bits(place.x);
}

std::uint64_t FarGrid::neighbour(std::uint64_t key, int x, int y, int z) {
    // Steps beyond the grid's end lead to other cells, which are as good as none.
    return key + static_cast<std::uint64_t>(std::int64_t{x} + (std::int64_t{y} << kPlaceBits) +
                                            (std::int64_t{z} << 2 * kPlaceBits));
}

Imath::V3i FarGrid::place(const V3f& position, int level) const {
    const V3f scaled = position / side(level);
    return {static_cast<int>(std::floor(scaled.x)), static_cast<int>(std::floor(scaled.y)),
            static_cast<int>(std::floor(scaled.z))};
}

int FarGrid::face(const V3f& normal) {
    const V3f size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    return 2 * axis + (normal[axis] < 0 ? 1 : 0);
}

namespace {

LinearImage picture_of(const std::vector<SharedExponent>& panorama) {
    LinearImage image{FarLight::kColumns, FarLight::kColumns / 2, {}};
    for (const SharedExponent& pixel : panorama) {
        image.pixels.push_back(pixel.value());
    }
    return image;
}

}  // namespace

FarLight::FarLight(const FarRegion& region, std::vector<Cell> cells,
                   std::vector<SharedExponent> panorama)
    : grid_(region),
      cells_(std::move(cells)),
      panorama_(std::move(panorama)),
      surroundings_(std::make_shared<const Environment>(picture_of(panorama_))) {
    CAROM_ASSERT(panorama_.size() == std::size_t{kColumns} * kColumns / 2);
    make_table();
    add_means();
}

void FarLight::make_table() {
    std::size_t size = 16;
    while (size < 2 * cells_.size()) {
        size *= 2;
    }
    mask_ = size - 1;
    table_.assign(size, kNoCell);
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
        std::uint64_t slot = split_mix(cells_[i].key) & mask_;
        while (table_[slot] != kNoCell) {
            slot = (slot + 1) & mask_;
        }
        table_[slot] = i;
    }
}

void FarLight::add_means() {
    std::vector<Mean> means;
    Mean all;
    for (const Cell& cell : cells_) {
        const std::uint32_t object = FarGrid::object_of(cell.key);
        means.resize(std::max<std::size_t>(means.size(), object + 1));
        means[object].add(cell.irradiance.value(), 1);
        all.add(cell.irradiance.value(), 1);
    }
    mean_of_all_ = all.weight > 0 ? all.value() : V3f(0);
    for (const Mean& mean : means) {
        mean_of_object_.push_back(mean.weight > 0 ? mean.value() : mean_of_all_);
    }
}

const SharedExponent* FarLight::find(std::uint64_t key) const {
    for (std::uint64_t slot = split_mix(key) & mask_; table_[slot] != kNoCell;
         slot = (slot + 1) & mask_) {
        if (cells_[table_[slot]].key == key) {
            return &cells_[table_[slot]].irradiance;
        }
    }
    return nullptr;
}

/// Trilinear between the centres of the cells that exist.
void FarLight::add_face(std::uint64_t object, int face, int level, const V3f& position,
                        float weight, Mean& mean) const {
    const float side = grid_.side(level);
    const V3f corner = position - V3f(side / 2);
    const Imath::V3i place = grid_.place(corner, level);
    const V3f part = corner / side - V3f(place);
    const std::uint64_t first =
        FarGrid::key(static_cast<std::uint32_t>(object), face, level, place);
    for (int k = 0; k < 8; ++k) {
        const Imath::V3i step(k & 1, k >> 1 & 1, k >> 2);
        const float share = (step.x == 1 ? part.x : 1 - part.x) *
                            (step.y == 1 ? part.y : 1 - part.y) *
                            (step.z == 1 ? part.z : 1 - part.z);
        const SharedExponent* cell = find(FarGrid::neighbour(first, step.x, step.y, step.z));
        if (cell != nullptr && share > 0) {
            mean.add(cell->value(), weight * share);
        }
    }
}

V3f FarLight::irradiance(std::uint32_t object, const V3f& position, const V3f& normal) const {
    constexpr int kFurther[] = {0, 1, -1, 2};  // levels
    const int own = grid_.level(grid_.distance(position));
    Mean mean;
    for (const int further : kFurther) {
        const int level = own + further;
        for (int axis = 0; axis < 3 && level >= 0 && level <= FarGrid::kMostLevel; ++axis) {
            const float weight = std::abs(normal[axis]) - kLeastOfAxis;
            if (weight > 0) {
                add_face(object, 2 * axis + (normal[axis] < 0 ? 1 : 0), level, position, weight,
                         mean);
            }
        }
        if (mean.weight > 0) {
            return mean.value();
        }
    }
    add_around(object, FarGrid::face(normal), own, position, mean);
    if (mean.weight > 0) {
        return mean.value();
    }
    return object < mean_of_object_.size() ? mean_of_object_[object] : mean_of_all_;
}

void FarLight::add_around(std::uint32_t object, int face, int level, const V3f& position,
                          Mean& mean) const {
    constexpr int kFarthest = 5;  // cells
    const std::uint64_t own = FarGrid::key(object, face, level, grid_.place(position, level));
    for (int reach = 1; reach <= kFarthest && !(mean.weight > 0); ++reach) {
        for (int z = -reach; z <= reach; ++z) {
            for (int y = -reach; y <= reach; ++y) {
                for (int x = -reach; x <= reach; ++x) {
                    const SharedExponent* cell = find(FarGrid::neighbour(own, x, y, z));
                    if (cell != nullptr) {
                        mean.add(cell->value(), 1);
                    }
                }
            }
        }
    }
}

}  // namespace carom::render
