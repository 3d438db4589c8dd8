// What an answer carries: bytes in memory, or a part of a file that is read as it is sent.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "pipeline/server/byte_range.h"

namespace carom::server {

class Body {
  public:
    /// Nothing.
    Body() = default;
    explicit Body(std::shared_ptr<const std::string> bytes);
    /// The regular file at this path; empty if there is none that can be read.
    [[nodiscard]] static std::optional<Body> open(const std::string& path);

    /// All that there is, whatever part is selected.
    [[nodiscard]] std::uint64_t whole_size() const { return size_; }

    /// Only this part of it, which must be inside, will be read. At first it is all.
    void select(ByteRange range) { left_ = range; }
    [[nodiscard]] std::uint64_t bytes_left() const { return left_.end - left_.begin; }

    /// Reads the next bytes of the selected part into `bytes` and returns their number. 0: at the
    /// end, or if the file became shorter or cannot be read any more.
    [[nodiscard]] std::size_t read(std::span<char> bytes);

  private:
    class OpenFile;

    std::shared_ptr<const std::string> bytes_;
    std::shared_ptr<const OpenFile> file_;
    std::uint64_t size_ = 0;
    ByteRange left_;
};

}  // namespace carom::server
