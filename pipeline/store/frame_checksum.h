// A checksum at the end of a stored frame, which proves that the file is intact and belongs to its
// key.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/hash.h"

namespace carom::pipeline {

/// Appends a magic number, the key, and a hash of both and of the contents, then flushes the file
/// to disk. OpenEXR readers find everything from the front and ignore what follows. Throws Error.
void append_checksum(const std::string& path, const Hash128& key);

/// Writes a file with these contents and what append_checksum() appends. Throws Error.
void write_with_checksum(const std::string& path, std::span<const std::byte> contents,
                         const Hash128& key);

enum class FrameFileState {
    intact,
    damaged,
    missing,
    unreadable,  // another user's and not for this one: to whom wants the frame it is missing
};

/// Throws Error if the file exists but cannot be read for another reason.
[[nodiscard]] FrameFileState verify_checksum(const std::string& path, const Hash128& key);

/// What a file whose checksum is correct contains before its checksum.
struct CheckedContents {
    FrameFileState state = FrameFileState::missing;
    std::vector<std::byte> bytes{};  // if it is intact
};
/// Throws Error if the file exists but cannot be read for another reason.
[[nodiscard]] CheckedContents read_checked(const std::string& path, const Hash128& key);

/// What is wrong with a file that verify_checksum calls damaged: "it has 12 bytes, too few for a
/// frame".
[[nodiscard]] std::string describe_damage(const std::string& path, const Hash128& key);

}  // namespace carom::pipeline
