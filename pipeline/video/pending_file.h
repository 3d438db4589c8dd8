// A file that is written under a temporary name and renamed when it is complete.
#pragma once

#include <string>

namespace carom::pipeline {

/// For writers that need a path to write to. If the bytes are in memory, use core/atomic_file.h.
///
/// The temporary file is a hidden file in the target's folder and is locked (flock) during the
/// lifetime of this object. A temporary file of a killed process is no longer locked; it is removed
/// when the same target is written again.
class PendingFile {
  public:
    /// Creates an empty temporary file. Throws Error naming `target` and the system's reason.
    explicit PendingFile(std::string target);
    /// Removes the temporary file unless commit() succeeded.
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// The path to write to, in the same folder and with the same extension as the target.
    [[nodiscard]] const std::string& temporary_path() const { return temporary_path_; }
    [[nodiscard]] const std::string& target() const { return target_; }

    /// Flushes the file to disk and replaces the target in one step. If the target is a symbolic
    /// link, the file it points to is replaced. The writer must have closed the file. Throws Error;
    /// then the target is unchanged.
    void commit();

  private:
    void create();
    void remove_leftovers() const;
    void discard() noexcept;

    std::string target_;  // as the user names it
    std::string file_;    // the file that is replaced, with symbolic links resolved
    std::string temporary_path_;
    int lock_descriptor_ = -1;
};

}  // namespace carom::pipeline
