// A file of the store that is being written.
#pragma once

#include <string>

#include "pipeline/store/lock_file.h"

namespace carom::pipeline {

/// A file with a name of its own in a folder for such files. It is locked, so that no process takes
/// it for a leftover of a killed writer, and removed unless it was renamed.
class PartialFile {
  public:
    /// Creates it; `key` becomes a part of its name. Throws Error.
    PartialFile(const std::string& folder, const std::string& key);
    ~PartialFile();
    PartialFile(PartialFile&& other) noexcept;
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;
    PartialFile& operator=(PartialFile&&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

    /// Gives it its final name, and makes the folder for it. Throws Error.
    void rename_to(const std::string& final_path);

  private:
    std::string path_;
    LockAttempt lock_;
};

}  // namespace carom::pipeline
