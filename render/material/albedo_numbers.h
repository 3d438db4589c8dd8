// The albedo tables of materials, as plain data.
#pragma once

namespace carom::render {

/// Numbers in one table.
inline constexpr int kAlbedoNodes = 32;

/// Borrowed: one table of each kind for each material (AlbedoTable).
struct AlbedoNumbers {
    const float* coat = nullptr;
    const float* sheen = nullptr;
    const float* specular = nullptr;
    const float* mirror = nullptr;
};

}  // namespace carom::render
