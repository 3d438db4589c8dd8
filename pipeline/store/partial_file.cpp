#include "pipeline/store/partial_file.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/claim_note.h"

namespace carom::pipeline {
PartialFile::PartialFile(const std::string& folder, const std::string& key)
    : path_(fmt::format("{}/{}{}-{}", folder, host_prefix(), key, new_claim_process())),
      lock_(lock_own_file(path_)) {}

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
