#include "pipeline/store/seal.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
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

constexpr std::array<char, 8> kMark{'c', 'a', 'r', 'o', 'm', 'f', 'r', '1'};
constexpr std::size_t kSealSize = kMark.size() + 4 * sizeof(std::uint64_t);

using Seal = std::array<std::byte, kSealSize>;

Seal make_seal(std::span<const std::byte> contents, const Hash128& key) {
    Hasher hasher;
    hasher.add(std::string_view(kMark.data(), kMark.size())).add(key).add_bytes(contents);
    const Hash128 sum = hasher.finish();
    Seal seal{};
    std::memcpy(seal.data(), kMark.data(), kMark.size());
    std::size_t at = kMark.size();
    for (const std::uint64_t word : {key.high, key.low, sum.high, sum.low}) {
        for (int byte = 0; byte < 8; ++byte) {
            seal[at] = static_cast<std::byte>(word >> (8 * byte));
            ++at;
        }
    }
    return seal;
}

std::vector<std::byte> read_whole(int descriptor, const std::string& path) {
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

}  // namespace

void seal_file(const std::string& path, const Hash128& key) {
    const FileDescriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (!file.is_open()) {
        throw Error(system_problem(path, "the frame cannot be written"));
    }
    const std::vector<std::byte> contents = read_whole(file.get(), path);
    if (!write_all(file.get(), make_seal(contents, key))) {
        throw Error(system_problem(path, "the frame cannot be written"));
    }
    if (::fsync(file.get()) != 0) {
        throw Error(system_problem(path, "the frame cannot be flushed to disk"));
    }
}

namespace {

/// Nothing if there is no such file.
std::optional<std::vector<std::byte>> read_sealed(const std::string& path) {
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) {
        if (errno == ENOENT || errno == ENOTDIR) {
            return std::nullopt;
        }
        throw Error(system_problem(path, "the frame cannot be read"));
    }
    return read_whole(file.get(), path);
}

}  // namespace

SealState check_seal(const std::string& path, const Hash128& key) {
    const std::optional<std::vector<std::byte>> bytes = read_sealed(path);
    if (!bytes) {
        return SealState::missing;
    }
    if (bytes->size() < kSealSize) {
        return SealState::damaged;
    }
    const std::span<const std::byte> whole(*bytes);
    const Seal expected = make_seal(whole.first(bytes->size() - kSealSize), key);
    return std::ranges::equal(whole.last(kSealSize), expected) ? SealState::whole
                                                               : SealState::damaged;
}

std::string damage_text(const std::string& path, const Hash128& key) {
    const std::optional<std::vector<std::byte>> bytes = read_sealed(path);
    if (!bytes) {
        return "it is gone";
    }
    if (bytes->size() < kSealSize) {
        return fmt::format("it has {} bytes, too few for a frame", bytes->size());
    }
    const std::span<const std::byte> whole(*bytes);
    const std::span<const std::byte> seal = whole.last(kSealSize);
    const Seal expected = make_seal(whole.first(bytes->size() - kSealSize), key);
    constexpr std::size_t kKeyEnd = kMark.size() + 2 * sizeof(std::uint64_t);
    if (!std::ranges::equal(seal.first(kMark.size()), std::span(expected).first(kMark.size()))) {
        return "its end is missing or overwritten";
    }
    if (!std::ranges::equal(seal.first(kKeyEnd), std::span(expected).first(kKeyEnd))) {
        return "it is another frame, or its end is overwritten";
    }
    return "its contents have changed since it was written";
}

}  // namespace carom::pipeline
