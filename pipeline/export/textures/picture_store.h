// Pictures of files for exports: each is read once.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/hash.h"
#include "core/lru_cache.h"
#include "pipeline/export/textures/picture_file.h"

namespace carom::pipeline {

struct EncodedPicture;

/// Keeps what it read of files and what was made of them. Files are known by their path, time and
/// size. All functions may be called from any thread and throw Error if a file cannot be read.
class PictureStore {
  public:
    struct Limits {
        int most_side = kAnySide;       // of a picture, in pixels; larger ones are made smaller
        bool skips_unreadable = false;  // textures whose picture cannot be read are left out
    };
    static constexpr int kAnySide = 8192;  // of pictures that are made

    PictureStore() : PictureStore(Limits{}) {}
    explicit PictureStore(const Limits& limits) : limits_(limits) {}

    [[nodiscard]] const Limits& limits() const { return limits_; }

    [[nodiscard]] PictureFacts facts(const std::string& path);

    /// The picture, perhaps made smaller.
    [[nodiscard]] std::shared_ptr<const render::RawPicture> picture(const std::string& path);

    /// Whether it is larger than it may be.
    [[nodiscard]] bool is_too_large(const PictureFacts& facts) const;

    /// What `make` returned for that hash.
    [[nodiscard]] std::shared_ptr<const EncodedPicture> made(
        const Hash128& hash, const std::function<EncodedPicture()>& make);

  private:
    struct Stored;
    [[nodiscard]] std::shared_ptr<const Stored> stored(const std::string& path);

    Limits limits_;
    LruCache<Hash128, Stored> pictures_{8};
    LruCache<Hash128, PictureFacts> facts_{512};
    LruCache<Hash128, EncodedPicture> made_{32};
};

}  // namespace carom::pipeline
