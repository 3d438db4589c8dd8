#include "sim/timeline/bake_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <sys/stat.h>

#include "sim/timeline/atomic_file.h"
#include "sim/timeline/bake_format.h"
#include "sim/timeline/error.h"

namespace carom::sim {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail_to_read(const std::string& path) {
    throw Error("cannot read '" + path + "': " + std::strerror(errno));
}

std::vector<std::byte> read_up_to(std::FILE* file, std::size_t size, const std::string& path) {
    std::vector<std::byte> bytes(size);
    bytes.resize(std::fread(bytes.data(), 1, size, file));
    if (std::ferror(file) != 0)
        fail_to_read(path);
    return bytes;
}

}  // namespace

void write_bake(const Bake& bake, const std::string& path) {
    write_file_atomically(path, encode_bake(bake));
}

Bake read_bake(const std::string& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file)
        fail_to_read(path);
    struct stat status {};
    if (::fstat(::fileno(file.get()), &status) != 0)
        fail_to_read(path);
    // A bake has a size of its own and fits into memory; a pipe or a film is not one.
    const auto size = static_cast<std::size_t>(status.st_size);
    const bool can_be_bake = S_ISREG(status.st_mode) && size <= kLargestContent + 4096;
    if (!can_be_bake && !S_ISDIR(status.st_mode))
        throw Error("'" + path + "' is not a carom bake");
    return decode_bake(read_up_to(file.get(), size, path), path);
}

}  // namespace carom::sim
