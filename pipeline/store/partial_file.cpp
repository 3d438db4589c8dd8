#include "pipeline/store/partial_file.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/claim_note.h"

namespace carom::pipeline {
namespace {

/// Unique among all writers that now run.
std::string new_name(const std::string& key) {
    static std::atomic<std::uint64_t> count{0};
    return fmt::format("{}{}-{}-{}", host_prefix(), key, ::getpid(), ++count);
}

}  // namespace

PartialFile::PartialFile(const std::string& folder, const std::string& key)
    : path_(folder + "/" + new_name(key)), lock_(try_lock(path_)) {
    // No other writer uses this name. Only remove_abandoned_files may lock it for a moment.
    while (lock_.state == LockState::busy) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        lock_ = try_lock(path_);
    }
}

PartialFile::PartialFile(PartialFile&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::move(other.lock_)) {}

PartialFile::~PartialFile() {
    if (!path_.empty()) {
        ::unlink(path_.c_str());
    }
}

void PartialFile::rename_to(const std::string& final_path) {
    create_folder(std::filesystem::path(final_path).parent_path().string());
    if (std::rename(path_.c_str(), final_path.c_str()) != 0) {
        throw Error(system_problem(final_path, "the finished frame cannot be moved here"));
    }
    path_.clear();
}

}  // namespace carom::pipeline
