// The descriptor of an open file, closed when it goes out of scope.
#pragma once

#include <string>
#include <utility>

namespace carom::pipeline {

class FileDescriptor {
  public:
    FileDescriptor() = default;
    explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
    ~FileDescriptor() { reset(); }
    FileDescriptor(FileDescriptor&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        reset();
        descriptor_ = std::exchange(other.descriptor_, -1);
        return *this;
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    [[nodiscard]] int get() const { return descriptor_; }
    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
    [[nodiscard]] int release() { return std::exchange(descriptor_, -1); }
    void reset();

  private:
    int descriptor_ = -1;
};

/// "'path': what failed: the system's reason", where the reason is that of errno. If permission is
/// missing, the text ends with whose file or folder it is that keeps this user out.
[[nodiscard]] std::string system_problem(const std::string& path, const std::string& what);

/// The name of the user whose it is, or his number; empty if it is not known.
[[nodiscard]] std::string name_of_owner(const std::string& path);

/// Creates the folder and its parents, for the group if it lies in a group's folder
/// (core/group_folder.h). Throws Error.
void create_folder(const std::string& path);

}  // namespace carom::pipeline
