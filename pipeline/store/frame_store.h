// A store of finished frames on disk, each in a file that is named after its key.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/hash.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/claims.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/partial_file.h"
#include "render/film/film.h"
#include "render/film/image_file.h"

namespace carom::pipeline {

/// What a user of the store may do with it.
enum class StoreAccess {
    read_and_write,
    only_read,  // nothing in the folder is changed, not even the times of files; what cannot be
                // read, as in the folder of another user, counts as not stored
};

/// A folder of EXR files, one per key. Several threads and processes may share it.
///   FOLDER/ab/abcdef....exr   finished frames, sorted by the first two digits of the key
///   FOLDER/ab/abcdef....noisy frames before they were denoised, with what the denoiser reads
///   FOLDER/ab/abcdef....sums  samples of frames that were stopped (sums_file.h)
///   FOLDER/partial/           files being written; leftovers of killed writers are removed
///   FOLDER/locks/             claims (claims.h)
class FrameStore {
  public:
    /// Called for a stored frame that turned out to be damaged, before its file is removed. The
    /// arguments are the file and a sentence without its full stop: "its contents have changed
    /// since it was written". Any thread that uses the store may call it.
    using DamageObserver = std::function<void(const std::string& path, const std::string& damage)>;

    /// Creates the folder if need be; throws CacheUnusable if that fails. With `only_read` the
    /// folder need not exist; damaged frames stay then, and claim() and write() must not be called.
    explicit FrameStore(std::string folder, DamageObserver on_damage = {}, ClaimTimes times = {},
                        StoreAccess access = StoreAccess::read_and_write);

    /// Whether a file exists for the key (it may still turn out to be damaged). One that this user
    /// may not read counts nowhere here as stored, and is replaced when the frame is written.
    [[nodiscard]] bool contains(const Hash128& key) const;

    /// The size of the file for the key; 0 if there is none. The file is opened, because network
    /// file systems look at the server's file only then.
    [[nodiscard]] std::uint64_t size_bytes(const Hash128& key) const;

    /// Whether the file for the key exists and its checksum is correct. The file is read to its end
    /// but not decoded. Throws Error if it cannot be read.
    [[nodiscard]] bool is_intact(const Hash128& key) const;

    /// Removes the frame if it exists and is damaged.
    void remove_if_damaged(const Hash128& key) const;

    /// Marks the frame, if it exists, as used now, so that it will be among the last to be pruned.
    void mark_used(const Hash128& key) const;

    /// The frame, or nothing if it is not stored. A damaged file is removed and counts as not
    /// stored. Throws Error if it cannot be read.
    [[nodiscard]] std::optional<render::Film> read(const Hash128& key) const;

    /// Writes the frame under a temporary name, flushes it to disk and renames it. Throws Error.
    void write(const Hash128& key, const render::Film& film,
               const render::ImageMetadata& metadata) const;

    /// The noisy frame: the picture with this key before it was denoised, with the denoiser's
    /// channels. The same promises as those of read(); nothing but the denoiser needs it, so it may
    /// be removed at any time (prune_cache).
    [[nodiscard]] std::optional<render::Film> read_noisy(const Hash128& key) const;

    /// Writes a noisy frame, as write() does. `film`: as render::as_stored returns it.
    void write_noisy(const Hash128& key, const render::Film& film) const;

    /// The size of the noisy frame's file; 0 if there is none.
    [[nodiscard]] std::uint64_t noisy_size_bytes(const Hash128& key) const;

    /// The right to render this frame, or nothing if another process has claimed it or finished it
    /// on another machine. The store must outlive it. Throws CacheUnusable if the claim cannot be
    /// made or read.
    [[nodiscard]] std::optional<Claim> claim(const Hash128& key) const;

    /// Who has claimed the frame, as Claims::holder() says it.
    [[nodiscard]] std::string claim_holder(const Hash128& key) const {
        return claims_->holder(key.to_string());
    }

    /// Removes the claims on a frame that all machines see.
    void forget_claims(const Hash128& key) const { claims_->forget(key.to_string()); }

    [[nodiscard]] bool may_write() const { return access_ != StoreAccess::only_read; }
    [[nodiscard]] std::string path_of(const Hash128& key) const;
    /// The path of another file about the frame.
    [[nodiscard]] std::string file_of(const Hash128& key, const char* extension) const;
    /// A file about the frame, to be written. Throws Error if it cannot be made.
    [[nodiscard]] PartialFile begin_file(const Hash128& key) const;

  private:
    /// read_checked of a file of this store.
    [[nodiscard]] CheckedContents checked(const std::string& path, const Hash128& key) const;
    void discard(const std::string& path, const std::string& damage) const;
    /// What `decode()` makes of an intact file; nothing if it is missing. A damaged file is
    /// discarded.
    template <class Decode>
    [[nodiscard]] std::optional<render::Film> decoded(const std::string& path, const Hash128& key,
                                                      FrameFileState state,
                                                      const Decode& decode) const;

    std::string folder_;
    StoreAccess access_;
    DamageObserver on_damage_;
    std::unique_ptr<Claims> claims_;
};

}  // namespace carom::pipeline
