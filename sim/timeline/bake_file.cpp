#include "sim/timeline/bake_file.h"

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/file_reader.h"
#include "sim/timeline/bake_format.h"

namespace carom::sim {

void write_bake(const Bake& bake, const std::string& path) {
    write_file_atomically(path, encode_bake(bake));
}

Bake read_bake(const std::string& path) {
    FileReader file(path);
    // A bake has a known size and fits into memory, unlike a pipe or a film.
    const std::optional<std::size_t> size = file.size();
    if (!size || *size > kLargestContent + 4096) {
        throw Error("'" + path + "' is not a carom bake");
    }
    std::vector<std::byte> bytes(*size);
    bytes.resize(file.read(bytes));
    return decode_bake(bytes, path);
}

}  // namespace carom::sim
