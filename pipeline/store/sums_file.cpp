// A file has the number of samples, then the sums in pieces, each after its length in bytes (8
// bytes, as the machine stores them), then the length 0 and a hash of the key, the number and all
// pieces. So neither writing nor reading needs a second copy of the sums in memory.
#include "pipeline/store/sums_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {
namespace {

constexpr const char* kExtension = ".sums";
constexpr std::uint64_t kLongestPiece = std::uint64_t{1} << 26;

template <class Value>
std::span<const std::byte> bytes_of(const Value& value) {
    return std::as_bytes(std::span(&value, 1));
}

class Reader {
  public:
    Reader(const std::string& path, const Hash128& key) : file_(path, std::ios::binary) {
        hasher_.add(key);
        std::uint64_t samples = 0;
        is_end_ = !read(samples);
        hasher_.add_bytes(bytes_of(samples));
    }

    /// Fills `bytes` with what comes next.
    bool fill(std::span<std::byte> bytes) {
        while (!bytes.empty()) {
            if (at_ == piece_.size() && !next_piece()) {
                return false;
            }
            const std::size_t count = std::min(bytes.size(), piece_.size() - at_);
            std::memcpy(bytes.data(), piece_.data() + at_, count);
            at_ += count;
            bytes = bytes.subspan(count);
        }
        return true;
    }

    /// Whether all was read and is what was written.
    bool is_intact() {
        if (at_ != piece_.size() || next_piece()) {
            return false;
        }
        Hash128 sum;
        return is_end_ && read(sum.high) && read(sum.low) && sum == hasher_.finish();
    }

  private:
    template <class Value>
    bool read(Value& value) {
        return static_cast<bool>(file_.read(reinterpret_cast<char*>(&value), sizeof(value)));
    }

    bool next_piece() {
        std::uint64_t length = 0;
        if (is_end_ || !read(length) || length > kLongestPiece) {
            return false;
        }
        is_end_ = length == 0;
        at_ = 0;
        piece_.resize(length);
        if (!file_.read(reinterpret_cast<char*>(piece_.data()),
                        static_cast<std::streamsize>(length))) {
            return false;
        }
        hasher_.add_bytes(piece_);
        return !is_end_;
    }

    std::ifstream file_;
    Hasher hasher_;
    std::vector<std::byte> piece_;
    std::size_t at_ = 0;
    bool is_end_ = false;
};

}  // namespace

void write_sums(const FrameStore& store, const Hash128& key, const render::FrameSums& sums) {
    PartialFile partial = store.begin_file(key);
    const FileDescriptor file(::open(partial.path().c_str(), O_WRONLY | O_CLOEXEC));
    const auto write = [&](std::span<const std::byte> bytes) {
        if (!file.is_open() || !write_all(file.get(), bytes)) {
            throw Error(system_problem(partial.path(), "the sums of a frame cannot be written"));
        }
    };
    Hasher hasher;
    hasher.add(key);
    const std::uint64_t samples = sums.samples();
    write(bytes_of(samples));
    hasher.add_bytes(bytes_of(samples));
    const auto write_piece = [&](std::span<const std::byte> piece) {
        write(bytes_of(std::uint64_t{piece.size()}));
        write(piece);
        hasher.add_bytes(piece);
    };
    sums.save(write_piece);
    write_piece({});
    const Hash128 sum = hasher.finish();
    write(bytes_of(sum.high));
    write(bytes_of(sum.low));
    if (::fsync(file.get()) != 0) {
        throw Error(
            system_problem(partial.path(), "the sums of a frame cannot be flushed to disk"));
    }
    partial.rename_to(store.file_of(key, kExtension));
}

render::FrameSums read_sums(const FrameStore& store, const Hash128& key, std::size_t pixels) {
    Reader reader(store.file_of(key, kExtension), key);
    std::optional<render::FrameSums> sums = render::FrameSums::load(
        [&](std::span<std::byte> bytes) { return reader.fill(bytes); }, pixels);
    return sums && reader.is_intact() ? std::move(*sums) : render::FrameSums();
}

std::uint64_t stored_samples(const FrameStore& store, const Hash128& key) {
    std::ifstream file(store.file_of(key, kExtension), std::ios::binary);
    std::uint64_t samples = 0;
    return file.read(reinterpret_cast<char*>(&samples), sizeof(samples)) ? samples : 0;
}

void remove_sums(const FrameStore& store, const Hash128& key) {
    ::unlink(store.file_of(key, kExtension).c_str());
}

}  // namespace carom::pipeline
