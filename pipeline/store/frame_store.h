// Finished frames on disk, under their keys.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/hash.h"
#include "pipeline/store/cache_folder.h"
#include "render/film/film.h"
#include "render/film/image_file.h"

namespace carom::pipeline {

/// Held while a frame is being rendered; releases its lock when destroyed (also when the process
/// is killed).
class FrameClaim {
  public:
    FrameClaim(int lock_descriptor, std::string path);
    ~FrameClaim();
    FrameClaim(FrameClaim&& other) noexcept;
    FrameClaim& operator=(FrameClaim&& other) noexcept;
    FrameClaim(const FrameClaim&) = delete;
    FrameClaim& operator=(const FrameClaim&) = delete;

  private:
    int lock_descriptor_ = -1;
    std::string path_;
};

/// A folder of EXR files, one per key. Several threads and processes may share it.
///   FOLDER/ab/abcdef....exr   whole frames, by the first two digits of the key
///   FOLDER/partial/           frames being written; what killed writers left is removed
///   FOLDER/locks/             claims
class FrameStore {
  public:
    /// Hears of a stored frame that turned out to be damaged, before its file is removed: the file
    /// and a sentence without its full stop, "its contents have changed since it was written". Any
    /// thread that uses the store may call it.
    using DamageObserver = std::function<void(const std::string& path, const std::string& damage)>;

    /// Creates the folder if need be; throws Error if that fails.
    explicit FrameStore(std::string folder, DamageObserver on_damage = {});

    /// Whether claims keep other processes off; false where the file system has no locks. Every
    /// claim is granted then, and the same frame may be rendered twice.
    [[nodiscard]] bool can_claim() const { return can_claim_; }

    /// Whether a file stands under the key (it may still turn out to be damaged).
    [[nodiscard]] bool contains(const Hash128& key) const;

    /// Whether the file under the key is whole, read to its end but not decoded. Throws Error if
    /// the folder cannot be read.
    [[nodiscard]] bool holds_whole(const Hash128& key) const;

    /// Removes the frame, if it is there and damaged.
    void discard_damaged(const Hash128& key) const;

    /// Notes that the frame, if it is there, is used now: it will be among the last to be pruned.
    void mark_used(const Hash128& key) const;

    /// The frame, or nothing if there is none. A damaged file is removed and counts as none. Throws
    /// Error if the folder cannot be read.
    [[nodiscard]] std::optional<render::Film> read(const Hash128& key) const;

    /// Under a temporary name, flushed, renamed. Throws Error.
    void write(const Hash128& key, const render::Film& film,
               const render::ImageMetadata& metadata) const;

    /// The right to render this frame, or nothing if another process holds it now.
    [[nodiscard]] std::optional<FrameClaim> claim(const Hash128& key) const;

    [[nodiscard]] std::string path_of(const Hash128& key) const;

  private:
    void discard(const std::string& path, const std::string& damage) const;

    std::string folder_;
    DamageObserver on_damage_;
    bool can_claim_ = true;
};

}  // namespace carom::pipeline
