// Reads a file. Failures throw an Error that names the file and the system's reason.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace carom {

class FileReader {
  public:
    explicit FileReader(std::string path);
    ~FileReader();
    FileReader(const FileReader&) = delete;
    FileReader& operator=(const FileReader&) = delete;
    FileReader(FileReader&&) = delete;
    FileReader& operator=(FileReader&&) = delete;

    /// The size of a regular file; empty for pipes, devices and the like.
    [[nodiscard]] std::optional<std::size_t> size() const;

    /// Fills `bytes` up to the end of the file; returns the number of bytes read.
    [[nodiscard]] std::size_t read(std::span<std::byte> bytes);

  private:
    [[noreturn]] void fail() const;

    std::string path_;
    int descriptor_ = -1;
};

}  // namespace carom
