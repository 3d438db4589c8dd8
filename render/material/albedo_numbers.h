// The albedo tables of materials, as plain data.
#pragma once

#include <array>
#include <cstddef>

namespace carom::render {

/// Numbers in one table.
inline constexpr int kAlbedoNodes = 32;

/// Tables of a kind, of roughnesses from 0 to 1 in equal steps, if a material's roughness varies.
inline constexpr int kAlbedoSlices = 16;

/// Borrowed: one table of each kind for each material (AlbedoTable).
struct AlbedoNumbers {
    const float* coat = nullptr;
    const float* sheen = nullptr;
    const float* specular = nullptr;
    const float* mirror = nullptr;
    // Of rough glass, by the viewer's side (GlassConstants).
    const float* reflected_outside = nullptr;
    const float* reflected_inside = nullptr;
    const float* kept_outside = nullptr;
    const float* kept_inside = nullptr;
    // Of the lobes of a phong surface.
    const float* highlight = nullptr;
    const float* mirrored = nullptr;
    const float* through = nullptr;

    /// Of tables that lie `stride` numbers apart, in the order of `each`.
    [[nodiscard]] static AlbedoNumbers in_rows(const float* first, std::ptrdiff_t stride) {
        const auto row = [&](int kind) { return first + kind * stride; };
        return {row(0), row(1), row(2), row(3), row(4), row(5),
                row(6), row(7), row(8), row(9), row(10)};
    }

    /// All of them, always in the same order.
    template <class Numbers>
    [[nodiscard]] static auto each(Numbers& numbers) {
        return std::array{&numbers.coat,
                          &numbers.sheen,
                          &numbers.specular,
                          &numbers.mirror,
                          &numbers.reflected_outside,
                          &numbers.reflected_inside,
                          &numbers.kept_outside,
                          &numbers.kept_inside,
                          &numbers.highlight,
                          &numbers.mirrored,
                          &numbers.through};
    }
};
inline constexpr std::size_t kAlbedoKinds = sizeof(AlbedoNumbers) / sizeof(const float*);

}  // namespace carom::render
