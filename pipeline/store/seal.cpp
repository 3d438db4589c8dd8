#include "pipeline/store/seal.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "pipeline/store/file_descriptor.h"
#include "sim/timeline/error.h"
#include "sim/timeline/write_all.h"

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

SealState check_seal(const std::string& path, const Hash128& key) {
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) {
        if (errno == ENOENT || errno == ENOTDIR) {
            return SealState::missing;
        }
        throw Error(system_problem(path, "the frame cannot be read"));
    }
    const std::vector<std::byte> bytes = read_whole(file.get(), path);
    if (bytes.size() < kSealSize) {
        return SealState::damaged;
    }
    const std::span<const std::byte> whole(bytes);
    const Seal expected = make_seal(whole.first(bytes.size() - kSealSize), key);
    return std::ranges::equal(whole.last(kSealSize), expected) ? SealState::whole
                                                               : SealState::damaged;
}

}  // namespace carom::pipeline
