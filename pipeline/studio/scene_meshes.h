// The meshes of shots for the view, by the hash of what they show.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/hash.h"
#include "pipeline/export/textures/picture_store.h"
#include "pipeline/shot/shot.h"

namespace carom::studio {

/// Of the shapes, materials and textures, but not of poses and motion.
[[nodiscard]] Hash128 hash_meshes(const pipeline::Shot& shot);

/// Keeps the last few files. All functions may be called from any thread.
class MeshFiles {
  public:
    /// Makes the .glb of the shot if it is not kept. Returns its hash. Throws Error if a mesh file
    /// cannot be read.
    std::string add(const pipeline::Shot& shot);

    /// Whether the .glb of that hash is kept.
    [[nodiscard]] bool has(std::string_view hash) const { return find(hash) != nullptr; }

    /// The .glb of that hash, or null.
    [[nodiscard]] std::shared_ptr<const std::string> find(std::string_view hash) const;

  private:
    struct File {
        std::string hash;
        std::shared_ptr<const std::string> bytes;
    };
    /// Of pictures in the view, a side in pixels.
    static constexpr int kMostPixels = 1024;

    pipeline::PictureStore pictures_{{.most_side = kMostPixels, .skips_unreadable = true}};
    mutable std::mutex mutex_;
    std::deque<File> files_;  // the last used ones at the end
    std::size_t bytes_ = 0;   // of all
};

}  // namespace carom::studio
