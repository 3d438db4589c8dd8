// The light that falls on surfaces far from a table, computed once for all frames.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathBox.h>

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

    /// Surfaces change from near to far over so wide a band at the sides of the near box, m.
    static constexpr float kBand = 0.4F;

    explicit FarGrid(const FarRegion& region);

    /// From the region's box, m.
    [[nodiscard]] float distance(const V3f& position) const;
    /// What is not in this box is far: the region's box, wider by its distance on all sides.
    [[nodiscard]] const Imath::Box3f& near() const { return near_; }
    [[nodiscard]] bool is_far(const V3f& position) const { return !near_.intersects(position); }
    /// Whether a surface there counts as far for the share `part` of all paths, [0, 1]: within the
    /// band at the sides of the box, it does for ever more of them.
    [[nodiscard]] bool counts_as_far(const V3f& position, float part) const {
        const V3f in(part * kBand, part * kBand, 0);
        return !Imath::Box3f(near_.min + in, near_.max - in).intersects(position);
    }
    /// The distance from the origin at which a ray leaves that box; 0 if it does not meet it.
    [[nodiscard]] float way_out(const V3f& origin, const V3f& direction) const;
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
    Imath::Box3f near_;
    float cell_, growth_;
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
    static constexpr int kColumns = 256;  // of the panorama; half as many rows

    /// `cells`: sorted by key, each once. `panorama`: radiance of far surfaces and the environment
    /// and lamps as seen from the table, as the picture of an environment.
    FarLight(const FarRegion& region, std::vector<Cell> cells,
             std::vector<SharedExponent> panorama);

    [[nodiscard]] const FarGrid& grid() const { return grid_; }
    /// On an object's surface, W/m^2, interpolated between cells; `normal`: unit, on the side from
    /// which the light comes. Where no cell is within five, the mean of the object, or of all.
    [[nodiscard]] V3f irradiance(std::uint32_t object, const V3f& position,
                                 const V3f& normal) const;
    /// What scattered light finds beyond the near box.
    [[nodiscard]] const std::shared_ptr<const Environment>& surroundings() const {
        return surroundings_;
    }
    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
    [[nodiscard]] const std::vector<SharedExponent>& panorama() const { return panorama_; }

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
    /// The nearest cells around the position, where it is in none.
    void add_around(std::uint32_t object, int face, int level, const V3f& position,
                    Mean& mean) const;
    void add_means();
    void make_table();

    FarGrid grid_;
    std::vector<Cell> cells_;
    std::vector<SharedExponent> panorama_;
    std::vector<std::uint32_t> table_;  // places in cells_, by hash; kNoCell: none
    std::uint64_t mask_ = 0;
    std::vector<V3f> mean_of_object_;
    V3f mean_of_all_{0, 0, 0};
    std::shared_ptr<const Environment> surroundings_;
};

/// The light as bytes, with the number of its inputs.
[[nodiscard]] std::string encoded(const FarLight& light, std::string_view inputs);
/// The light from `encoded`; null if the bytes are damaged, of another version, or of other inputs.
[[nodiscard]] std::shared_ptr<const FarLight> decoded(std::string_view bytes,
                                                      std::string_view inputs,
                                                      const FarRegion& region);

}  // namespace carom::render
