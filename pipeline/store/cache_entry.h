// The entries of the cache: finished frames, noisy ones for the denoiser, samples of frames that
// were stopped, bakes, and answers of solvers.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/hash.h"
#include "pipeline/store/claim_times.h"

namespace carom::pipeline {

struct CacheEntry {
    enum class Kind {
        frame,
        bake,
        answer,  // of a solver
        sums,    // of a frame that was stopped
        light,   // of the far surfaces of a scene
        noisy,   // a frame before it was denoised, with what only the denoiser reads
    };
    Kind kind = Kind::frame;
    std::string path;
    Hash128 key;  // a frame's key, a bake's physics hash or a question's hash: the file's name
    std::uint64_t bytes = 0;
    std::chrono::system_clock::time_point last_used;
};

/// The key that 32 lower-case hexadecimal digits stand for.
[[nodiscard]] std::optional<Hash128> parse_key(const std::string& digits);

/// The ending of the name of a noisy frame.
inline constexpr const char* kNoisyExtension = ".noisy";

/// The ending of the name of the light of a scene's far surfaces (job/far_light.h).
inline constexpr const char* kFarLightExtension = ".light";

/// A file about a frame in the folder of the frames, and the files of a frame and of a bake.
[[nodiscard]] std::string file_about(const Hash128& key, const std::string& frames_folder,
                                     const char* extension);
[[nodiscard]] std::string frame_file(const std::string& cache_folder, const Hash128& key);
[[nodiscard]] std::string answers_folder(const std::string& cache_folder);
[[nodiscard]] std::string bake_file(const std::string& cache_folder, const Hash128& key);

/// All entries, the least recently used one first. Files with other names and files that are being
/// written are not entries. A folder that does not exist has no entries. Throws Error if the folder
/// cannot be read.
[[nodiscard]] std::vector<CacheEntry> list_cache(const std::string& folder);

/// Sets the modification time of a file of the cache to now, which marks it as used. A failure is
/// ignored, so that a read-only cache works, too.
void mark_used(const std::string& path);

/// Removes claims and half-written frames that killed processes of this machine left in the folder
/// of the frames. Locks may not be seen by other machines, so that each removes its own.
void remove_leftovers(const std::string& frames_folder, const ClaimTimes& times = {});

/// Removes the entry, and the file of warnings that older versions of carom kept beside a bake.
/// False if the entry could not be removed.
[[nodiscard]] bool remove_entry(const CacheEntry& entry);

}  // namespace carom::pipeline
