#include "pipeline/store/drop_frame.h"

#include <cerrno>
#include <optional>
#include <string>

#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/sums_file.h"

namespace carom::pipeline {
namespace {

/// `is_there`: the picture is, so that a claim on it is that of a process which has finished it, or
/// is about to note that.
std::optional<Claim> claim_to_drop(const FrameStore& store, const Hash128& key, bool is_there) {
    std::optional<Claim> claim = store.claim(key);
    if (!claim && is_there) {
        store.forget_claims(key);
        claim = store.claim(key);
    }
    return claim;
}

void remove_file(const std::string& path) {
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) {
        throw Error(system_problem(path, "the frame cannot be removed"));
    }
}

}  // namespace

bool drop_frame(const FrameStore& store, const Hash128& key, const Hash128& noisy_key) {
    const bool is_stored = store.contains(key);
    const bool is_noisy_stored = store.noisy_size_bytes(noisy_key) > 0;
    if (!is_stored && !is_noisy_stored && stored_samples(store, noisy_key) == 0) {
        return true;
    }
    const std::optional<Claim> claim = claim_to_drop(store, key, is_stored);
    std::optional<Claim> of_noisy;
    if (noisy_key != key) {  // also if the other is not granted: whether it is dead is seen by then
        of_noisy = claim_to_drop(store, noisy_key, is_noisy_stored);
    }
    if (!claim || (noisy_key != key && !of_noisy)) {
        return false;
    }
    remove_sums(store, noisy_key);
    remove_file(store.file_of(noisy_key, kNoisyExtension));
    remove_file(store.path_of(key));
    return true;
}

}  // namespace carom::pipeline
