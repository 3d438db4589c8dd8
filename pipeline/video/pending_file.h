// A file that grows under a temporary name and appears under its own when it is whole.
#pragma once

#include <string>

namespace carom::pipeline {

/// For writers that need a path of their own to write to; whoever has the bytes at hand uses
/// sim/timeline/atomic_file.h.
///
/// The temporary file stands hidden in the target's folder and is locked (flock) as long as this
/// object lives. One that a killed process left behind is no longer locked and is removed when the
/// same target is written again.
class PendingFile {
  public:
    /// Creates the temporary file, empty. Throws Error naming `target` and the system's reason.
    explicit PendingFile(std::string target);
    /// Removes the temporary file unless commit() was reached.
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where to write: same folder and same extension as the target.
    [[nodiscard]] const std::string& temporary_path() const { return temporary_path_; }
    [[nodiscard]] const std::string& target() const { return target_; }

    /// Flushes what was written to disk and puts it in the target's place in one step; a link
    /// stays, and leads to it. The file must have been closed by its writer. Throws Error; then the
    /// target is what it was.
    void commit();

  private:
    void create();
    void remove_leftovers() const;
    void discard() noexcept;

    std::string target_;  // as its user calls it
    std::string file_;    // the file that is replaced: where links lead
    std::string temporary_path_;
    int lock_descriptor_ = -1;
};

}  // namespace carom::pipeline
