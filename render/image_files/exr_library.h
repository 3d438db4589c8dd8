// What all uses of OpenEXR share.
#pragma once

#include <string>

namespace carom::render {

/// Lets OpenEXR compress and decompress on several threads. Its threads belong to the whole
/// process; the first call starts them.
void use_exr_threads();

/// An error text of OpenEXR as one line without a line break at its end.
[[nodiscard]] std::string exr_reason(std::string library_text);

}  // namespace carom::render
