// A film of several shots as the text of its file.
#pragma once

#include <functional>
#include <string>

#include "pipeline/sequence/sequence.h"

namespace carom::pipeline {

/// The text of a file that load_sequence() reads as the same film, if the shots' files have the
/// shots as they are now. `file_of`: the name of the file of the shot of a part, by its index.
[[nodiscard]] std::string sequence_text(const Sequence& sequence,
                                        const std::function<std::string(std::size_t)>& file_of);

}  // namespace carom::pipeline
