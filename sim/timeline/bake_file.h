// The bake file: FlatBuffers (bake.fbs) with identifier, schema version and content hash.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/hash.h"
#include "sim/timeline/timeline.h"

namespace carom::sim {

/// A file to which the shot refers (mesh, texture, environment).
struct Asset {
    std::string path;  // absolute, as resolved when the shot was read
    Hash128 content_hash;

    bool operator==(const Asset&) const = default;
};

/// A timeline and its origin. With `shot_text` and `assets`, `carom render FILE.bake` needs no
/// other file; they are not part of the physics hash.
struct Bake {
    Timeline timeline;
    Hash128 physics_hash;   // of the world description (sim/bake.h)
    std::string shot_text;  // the resolved shot, YAML
    std::vector<Asset> assets;

    bool operator==(const Bake&) const = default;
};

/// The file's bytes; the same bake gives the same bytes.
[[nodiscard]] std::vector<std::byte> encode_bake(const Bake& bake);

/// The bake was written in another version of the format, by an older or newer carom. It may be
/// whole, but cannot be read.
class OtherBakeVersion : public Error {
  public:
    using Error::Error;
};

/// Decodes the bytes of encode_bake. Rejects a truncated, damaged or foreign buffer with an Error
/// that names `origin` and the problem (OtherBakeVersion if that is the version); nothing in the
/// buffer is trusted.
[[nodiscard]] Bake decode_bake(std::span<const std::byte> bytes, const std::string& origin);

/// Writes to a temporary name beside `path`, flushes to disk and renames. Throws Error.
void write_bake(const Bake& bake, const std::string& path);
[[nodiscard]] Bake read_bake(const std::string& path);

/// Number of bytes at the beginning of a file that identify a bake.
inline constexpr std::size_t kBakeHeadBytes = 8;

/// True if the first bytes of a file, kBakeHeadBytes or more, are those of a bake.
[[nodiscard]] bool has_bake_identifier(std::span<const std::byte> head);

}  // namespace carom::sim
