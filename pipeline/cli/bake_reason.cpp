#include "pipeline/cli/bake_reason.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/text.h"
#include "pipeline/config/changed_keys.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/file_descriptor.h"
#include "sim/bake.h"

namespace carom::cli {

namespace {

namespace fs = std::filesystem;

std::string record_path(const std::string& shot_path, const std::string& cache_folder) {
    std::error_code code;
    const fs::path canonical = fs::canonical(shot_path, code);
    const std::string name = code ? shot_path : canonical.string();
    const std::string cache =
        cache_folder.empty() ? pipeline::default_cache_folder() : cache_folder;
    return cache + "/shots/" + hash_bytes(std::as_bytes(std::span(name))).to_string() + ".yaml";
}

/// "a, b, c and 4 more"
std::string shortened(const std::vector<std::string>& keys) {
    constexpr std::size_t kMax = 4;
    const std::string text = join(std::span(keys).first(std::min(kMax, keys.size())), ", ");
    return keys.size() > kMax ? fmt::format("{} and {} more", text, keys.size() - kMax) : text;
}

}  // namespace

BakeReason::BakeReason(const pipeline::Shot& shot, const std::string& shot_path,
                       const std::string& cache_folder)
    : shot_(shot),
      path_(record_path(shot_path, cache_folder)),
      hash_(sim::physics_hash(shot.world).to_string()) {
    std::ifstream record(path_, std::ios::binary);
    std::string mark;
    if (std::getline(record, mark) && mark.starts_with("# physics ")) {
        last_hash_ = mark.substr(std::string("# physics ").size());
        last_text_.assign(std::istreambuf_iterator<char>(record), {});
    }
}

std::string BakeReason::text(pipeline::BakeOrigin origin) const {
    if (origin == pipeline::BakeOrigin::replaced) {
        return "simulated the shot again: the cached bake could not be used";
    }
    if (origin == pipeline::BakeOrigin::outdated) {
        return "simulated the shot again: another version of carom made its cached bake";
    }
    if (origin == pipeline::BakeOrigin::cached) {
        return last_hash_ == hash_ ? "the physics is unchanged: using the cached bake"
                                   : "this physics was simulated before: using the cached bake";
    }
    if (last_hash_.empty()) {
        return "simulated the shot: the cache had no bake of it";
    }
    if (last_hash_ == hash_) {
        return "simulated the shot again: its bake was no longer in the cache";
    }
    const std::vector<std::string> keys =
        pipeline::changed_physics_keys(last_text_, shot_.resolved_text);
    return keys.empty()
               ? "simulated the shot again: carom itself or a file that the physics depends on has "
                 "changed"
               : "simulated the shot again: its physics has changed (" + shortened(keys) + ")";
}

void BakeReason::save_record() const {
    const std::string text = "# physics " + hash_ + "\n" + shot_.resolved_text;
    try {
        pipeline::create_folder(fs::path(path_).parent_path().string());
        write_file_atomically(path_, std::as_bytes(std::span<const char>(text)),
                              FileAccess::of_folder);
    } catch (const Error&) {  // the failure to save the bake was already reported
        return;
    }
}

}  // namespace carom::cli
