// The bake on disk: FlatBuffers (bake.fbs) with identifier, schema version and content hash.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/hash.h"
#include "sim/timeline/timeline.h"

namespace carom::sim {

/// A file that the shot refers to (mesh, texture, environment).
struct Asset {
    std::string path;  // absolute, as resolved when the shot was read
    Hash128 content_hash;

    bool operator==(const Asset&) const = default;
};

/// A timeline and where it came from. `shot_text` and `assets` let `carom render FILE.bake` film it
/// alone; they are outside the physics hash.
struct Bake {
    Timeline timeline;
    Hash128 physics_hash;   // of the world description it was baked from (sim/physics_hash.h)
    std::string shot_text;  // the resolved shot, YAML
    std::vector<Asset> assets;

    bool operator==(const Bake&) const = default;
};

/// The file's bytes; the same bake gives the same bytes.
[[nodiscard]] std::vector<std::byte> encode_bake(const Bake& bake);

/// Reads what encode_bake wrote. A truncated, damaged or foreign buffer is refused with an Error
/// that names `origin` and says what is wrong; nothing in the buffer is trusted.
[[nodiscard]] Bake decode_bake(std::span<const std::byte> bytes, const std::string& origin);

/// Written to a temporary name beside `path`, flushed to disk, renamed. Throws Error.
void write_bake(const Bake& bake, const std::string& path);
[[nodiscard]] Bake read_bake(const std::string& path);

/// So many bytes of a file tell whether it is a bake.
inline constexpr std::size_t kBakeHeadBytes = 8;

/// Whether the first bytes of a file, kBakeHeadBytes or more, are those of a bake.
[[nodiscard]] bool has_bake_identifier(std::span<const std::byte> head);

}  // namespace carom::sim
