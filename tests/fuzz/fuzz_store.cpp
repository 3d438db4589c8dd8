// Fuzzes the frame store. A file with any bytes must be read as a frame or count as missing. With a
// correct checksum the bytes are passed to the EXR reader and to that of noisy frames. The folder
// may contain files of any name.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/frame_store.h"

namespace {

using namespace carom;
using namespace carom::pipeline;

constexpr Hash128 kKey{0x0123456789abcdef, 0xfedcba9876543210};

void require(bool condition, const char* what) {
    if (condition) {
        return;
    }
    std::fprintf(stderr, "an accepted frame: %s\n", what);
    std::abort();
}

std::string make_folder() {
    std::string folder = std::filesystem::temp_directory_path() / "carom_fuzz_XXXXXX";
    if (::mkdtemp(folder.data()) == nullptr) {
        std::abort();
    }
    return folder;
}

void put(const std::filesystem::path& path, const std::uint8_t* data, std::size_t size,
         bool with_checksum) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    if (with_checksum) {
        append_checksum(path, kKey);
    }
}

void read(const FrameStore& store) {
    const auto film = store.read(kKey);
    require(film.has_value() == store.contains(kKey), "a damaged file was not removed");
    if (!film) {
        return;
    }
    require(film->width > 0 && film->height > 0, "empty");
}

void read_noisy(const FrameStore& store) {
    const auto film = store.read_noisy(kKey);
    require(film.has_value() == (store.noisy_size_bytes(kKey) > 0),
            "a damaged noisy frame was not removed");
    if (film) {
        require(film->rgba.size() == 4ULL * film->width * film->height, "of another size");
    }
}

/// Uses the first line as the name of a file among the frames.
void list(const std::string& folder, const FrameStore& store, const std::uint8_t* data,
          std::size_t size) {
    std::string name(data, std::find(data, data + std::min<std::size_t>(size, 60), '\n'));
    if (name.empty() || name.find_first_of(std::string("/\0", 2)) != std::string::npos ||
        name[0] == '.') {
        return;
    }
    const std::filesystem::path path =
        std::filesystem::path(store.path_of(kKey)).parent_path() / name;
    std::ofstream(path) << "x";
    for (const CacheEntry& entry : list_cache(folder)) {
        require(std::filesystem::exists(entry.path), "listed, but missing");
    }
    std::filesystem::remove(path);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string folder = make_folder();
    static const FrameStore store(folder);
    for (const bool with_checksum : {false, true}) {
        put(store.path_of(kKey), data, size, with_checksum);
        put(store.file_of(kKey, kNoisyExtension), data, size, with_checksum);
        try {
            read(store);
            read_noisy(store);
        } catch (const Error& error) {
            std::fprintf(stderr, "a file was not recognised as damaged: %s\n", error.what());
            std::abort();
        }
    }
    list(folder, store, data, size);
    return 0;
}
