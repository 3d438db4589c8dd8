// What proves that a stored file is whole and stands under its own key.
#pragma once

#include <string>

#include "core/hash.h"

namespace carom::pipeline {

/// Appends a mark, the key and a hash of both and of the contents so far, then flushes the file to
/// disk. OpenEXR readers find everything from the front and do not notice. Throws Error.
void seal_file(const std::string& path, const Hash128& key);

enum class SealState { whole, damaged, missing };

/// Throws Error if the file is there but cannot be read.
[[nodiscard]] SealState check_seal(const std::string& path, const Hash128& key);

/// What is wrong with a file that check_seal calls damaged: "it has 12 bytes, too few for a frame".
[[nodiscard]] std::string damage_text(const std::string& path, const Hash128& key);

}  // namespace carom::pipeline
