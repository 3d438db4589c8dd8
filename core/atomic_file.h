// Atomic writing of files: a file gets its name only when it is complete.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace carom {

/// Who may read and write a file. One that is replaced keeps its permissions, except in a group's
/// folder with of_folder.
enum class FileAccess {
    of_user,    // as the user's mask says
    of_folder,  // if the folder is a group's (group_folder.h), the group; else as the mask says
};

/// Writes `bytes` to a temporary file beside `path`, flushes it to disk and renames it to `path`.
/// If `path` is a link, its target is replaced. Throws Error with the system's reason and leaves no
/// temporary file.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes,
                           FileAccess access = FileAccess::of_user);

/// The same for bytes that come in pieces. Without finish(), the destructor removes the temporary
/// file.
class AtomicWriter {
  public:
    /// Makes the temporary file. Throws Error as write_file_atomically does, as all functions do.
    explicit AtomicWriter(const std::string& path, FileAccess access = FileAccess::of_user);
    ~AtomicWriter();
    AtomicWriter(const AtomicWriter&) = delete;
    AtomicWriter& operator=(const AtomicWriter&) = delete;
    AtomicWriter(AtomicWriter&&) = delete;
    AtomicWriter& operator=(AtomicWriter&&) = delete;

    /// Appends bytes.
    void write(std::span<const std::byte> bytes);

    /// Flushes the file to disk and gives it its name. Nothing is written after that.
    void finish();

  private:
    std::string path_;  // as given by the caller
    FileAccess access_;
    std::string target_;  // the final name
    std::string name_;    // the temporary one
    int descriptor_ = -1;
    bool is_renamed_ = false;
};

/// The final name of a file for `path`: the target of its links, which need not exist. Throws Error
/// if that is a pipe, a device or a socket, which must not be replaced by a file, or if the links
/// form a cycle.
[[nodiscard]] std::string replaceable_file(const std::string& path);

}  // namespace carom
