// The albedo tables of materials, as plain data.
#pragma once

#include <array>
#include <cstddef>

namespace carom::render {

/// Numbers in one table.
inline constexpr int kAlbedoNodes = 32;

/// Borrowed: one table of each kind for each material (AlbedoTable).
struct AlbedoNumbers {
    const float* coat = nullptr;
    const float* sheen = nullptr;
    const float* specular = nullptr;
    const float* mirror = nullptr;

    /// All of them, always in the same order.
    [[nodiscard]] static auto each(auto& numbers) {
        return std::array{&numbers.coat, &numbers.sheen, &numbers.specular, &numbers.mirror};
    }
};
inline constexpr std::size_t kAlbedoKinds = sizeof(AlbedoNumbers) / sizeof(const float*);

}  // namespace carom::render
