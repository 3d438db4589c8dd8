// The light that falls on surfaces far from a table, computed once for all frames.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/geometry/ray.h"
#include "render/light/environment.h"
#include "render/light/shared_exponent.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// The cells into which far surfaces are divided: cubes of a grid, apart for each object and for
/// the six directions in which surfaces may mainly face. The grid's side doubles with the distance
/// (FarRegion::cell and cell_growth).
class FarGrid {
  public:
    static constexpr int kMostLevel = 7;
    static constexpr std::uint32_t kMostObjects = 0xffff;

    explicit FarGrid(const FarRegion& region);

    /// From the region's box, m.
    [[nodiscard]] float distance(const V3f& position) const;
    /// Whether what is at this distance, m, or place is far.
    [[nodiscard]] bool is_far(float distance) const { return distance > distance_; }
    [[nodiscard]] bool is_far(const V3f& position) const { return is_far(distance(position)); }
    /// The logarithm to base 2 of the side of cells there, in units of FarRegion::cell.
    [[nodiscard]] int level(float distance) const;
    [[nodiscard]] float side(int level) const { return cell_ * static_cast<float>(1 << level); }

    /// A cell's number. `face`: 2 x axis, and 1 more if the normal is against the axis; `place`: in
    /// the level's grid.
    [[nodiscard]] static std::uint64_t key(std::uint32_t object, int face, int level,
                                           const Imath::V3i& place);
    /// The key of the cell at (x, y, z) + `step` of that of `key`.
    [[nodiscard]] static std::uint64_t neighbour(std::uint64_t key, int x, int y, int z);
    [[nodiscard]] static std::uint32_t object_of(std::uint64_t key) {
        return static_cast<std::uint32_t>(key >> 48);
    }
    /// The cell that contains the position, at a level.
    [[nodiscard]] Imath::V3i place(const V3f& position, int level) const;
    /// The face of a unit normal.
    [[nodiscard]] static int face(const V3f& normal);

  private:
    V3f centre_, half_size_;
    float distance_, cell_, growth_;
};

/// Irradiance by cell. Immutable. Objects are numbered as in the scene, without those that follow
/// tracks.
///
/// Irradiance, not what surfaces reflect, is kept (as by Ward, Rubinstein and Clear 1988, "A ray
/// tracing solution for diffuse interreflection"), so that their textures stay as sharp as they
/// are. Cells need no coordinates on the surfaces: Binder, Fricke and Keller 2019 ("Massively
/// parallel path space filtering") sort vertices into such cells by a hash.
class FarLight {
  public:
    struct Cell {
        std::uint64_t key = 0;      // FarGrid
        SharedExponent irradiance;  // W/m^2

        bool operator==(const Cell& other) const {
            return key == other.key && irradiance.bits() == other.irradiance.bits();
        }
    };
    static constexpr int kColumns = 128;  // of the brightness by direction; half as many rows

    /// `cells`: sorted by key, each once. `brightness`: of far surfaces and the environment as seen
    /// from the table, as the picture of an environment; lamps are left out.
    FarLight(const FarRegion& region, std::vector<Cell> cells, std::vector<float> brightness);

    [[nodiscard]] const FarGrid& grid() const { return grid_; }
    /// On an object's surface, W/m^2, interpolated between cells; `normal`: unit, on the side from
    /// which the light comes. Where no cell is near, the mean of the object, or of all.
    [[nodiscard]] V3f irradiance(std::uint32_t object, const V3f& position,
                                 const V3f& normal) const;
    /// Its directions are sampled in search of far surfaces.
    [[nodiscard]] const std::shared_ptr<const Environment>& directions() const {
        return directions_;
    }
    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
    [[nodiscard]] const std::vector<float>& brightness() const { return brightness_; }

  private:
    struct Mean {
        V3f sum{0, 0, 0};
        float weight = 0;
        void add(const V3f& value, float of) {
            sum += of * value;
            weight += of;
        }
        [[nodiscard]] V3f value() const { return sum / weight; }
    };
    [[nodiscard]] const SharedExponent* find(std::uint64_t key) const;
    void add_face(std::uint64_t object, int face, int level, const V3f& position, float weight,
                  Mean& mean) const;
    void add_means();
    void make_table();

    FarGrid grid_;
    std::vector<Cell> cells_;
    std::vector<float> brightness_;
    std::vector<std::uint32_t> table_;  // places in cells_, by hash; kNoCell: none
    std::uint64_t mask_ = 0;
    std::vector<V3f> mean_of_object_;
    V3f mean_of_all_{0, 0, 0};
    std::shared_ptr<const Environment> directions_;
};

/// The light as bytes, with the number of its inputs.
[[nodiscard]] std::string encoded(const FarLight& light, std::string_view inputs);
/// The light from `encoded`; null if the bytes are damaged, of another version, or of other inputs.
[[nodiscard]] std::shared_ptr<const FarLight> decoded(std::string_view bytes,
                                                      std::string_view inputs,
                                                      const FarRegion& region);

}  // namespace carom::render
