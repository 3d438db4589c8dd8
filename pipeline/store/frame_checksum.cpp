#include "pipeline/store/frame_checksum.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/write_all.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {
namespace {

constexpr std::array<char, 8> kMagic{'c', 'a', 'r', 'o', 'm', 'f', 'r', '1'};
constexpr std::size_t kTrailerSize = kMagic.size() + 4 * sizeof(std::uint64_t);

/// The magic number, the key and the hash, as they are appended.
using Trailer = std::array<std::byte, kTrailerSize>;

Trailer make_trailer(std::span<const std::byte> contents, const Hash128& key) {
    Hasher hasher;
    hasher.add(std::string_view(kMagic.data(), kMagic.size())).add(key).add_bytes(contents);
    const Hash128 sum = hasher.finish();
    Trailer trailer{};
    std::memcpy(trailer.data(), kMagic.data(), kMagic.size());
    std::size_t at = kMagic.size();
    for (const std::uint64_t word : {key.high, key.low, sum.high, sum.low}) {
        for (int byte = 0; byte < 8; ++byte) {
            trailer[at] = static_cast<std::byte>(word >> (8 * byte));
            ++at;
        }
    }
    return trailer;
}

std::vector<std::byte> read_all(int descriptor, const std::string& path) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) {
        throw Error(system_problem(path, "the frame cannot be read"));
    }
    std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::read(descriptor, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno != EINTR) {
            throw Error(system_problem(path, "the frame cannot be read"));
        }
        if (count == 0) {
            bytes.resize(done);
        }
        done += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    return bytes;
}

/// Appends the trailer and flushes the file.
void finish(const FileDescriptor& file, const std::string& path, const Trailer& trailer) {
    if (!write_all(file.get(), trailer)) {
        throw Error(system_problem(path, "the frame cannot be written"));
    }
    if (::fsync(file.get()) != 0) {
        throw Error(system_problem(path, "the frame cannot be flushed to disk"));
    }
}

}  // namespace

void append_checksum(const std::string& path, const Hash128& key) {
    const FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (!file.is_open()) {
        throw Error(system_problem(path, "the frame cannot be written"));
    }
    finish(file, path, make_trailer(read_all(file.get(), path), key));
}

void write_with_checksum(const std::string& path, std::span<const std::byte> contents,
                         const Hash128& key) {
    const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (!file.is_open() || !write_all(file.get(), contents)) {
        throw Error(system_problem(path, "the frame cannot be written"));
    }
    finish(file, path, make_trailer(contents, key));
}

namespace {

/// What is in the file; nothing, and why in `state`, if it is missing or unreadable.
std::optional<std::vector<std::byte>> read_if_possible(const std::string& path,
                                                       FrameFileState& state) {
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.is_open()) {
        return read_all(file.get(), path);
    }
    if (errno == ENOENT || errno == ENOTDIR) {
        state = FrameFileState::missing;
    } else if (errno == EACCES) {
        state = FrameFileState::unreadable;
    } else {
        throw Error(system_problem(path, "the frame cannot be read"));
    }
    return std::nullopt;
}

}  // namespace

FrameFileState verify_checksum(const std::string& path, const Hash128& key) {
    return read_checked(path, key).state;
}

CheckedContents read_checked(const std::string& path, const Hash128& key) {
    FrameFileState state{};
    std::optional<std::vector<std::byte>> bytes = read_if_possible(path, state);
    if (!bytes) {
        return {state};
    }
    if (bytes->size() < kTrailerSize) {
        return {FrameFileState::damaged};
    }
    const std::span<const std::byte> whole(*bytes);
    const Trailer expected = make_trailer(whole.first(bytes->size() - kTrailerSize), key);
    if (!std::ranges::equal(whole.last(kTrailerSize), expected)) {
        return {FrameFileState::damaged};
    }
    bytes->resize(bytes->size() - kTrailerSize);
    return {FrameFileState::intact, std::move(*bytes)};
}

std::string describe_damage(const std::string& path, const Hash128& key) {
    FrameFileState state{};
    const std::optional<std::vector<std::byte>> bytes = read_if_possible(path, state);
    if (!bytes) {
        return state == FrameFileState::missing ? "it no longer exists"
                                                : "it can no longer be read";
    }
    if (bytes->size() < kTrailerSize) {
        return fmt::format("it has {} bytes, too few for a frame", bytes->size());
    }
    const std::span<const std::byte> whole(*bytes);
    const std::span<const std::byte> trailer = whole.last(kTrailerSize);
    const Trailer expected = make_trailer(whole.first(bytes->size() - kTrailerSize), key);
    constexpr std::size_t kKeyEnd = kMagic.size() + 2 * sizeof(std::uint64_t);
    if (!std::ranges::equal(trailer.first(kMagic.size()),
                            std::span(expected).first(kMagic.size()))) {
        return "its checksum is missing or overwritten";
    }
    if (!std::ranges::equal(trailer.first(kKeyEnd), std::span(expected).first(kKeyEnd))) {
        return "it is another frame, or its checksum is overwritten";
    }
    return "its contents have changed since it was written";
}

}  // namespace carom::pipeline
