// The fonts of annotations, by file, so that pictures do not depend on the fonts of a machine.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace carom::pipeline {

/// A font of the package fonts-dejavu-core that has a name of its own.
struct NamedFont {
    std::string_view name;
    std::string_view file;
};

/// All of them; the first is the default.
[[nodiscard]] std::span<const NamedFont> named_fonts();

/// The file of the default font.
[[nodiscard]] std::string default_font();

}  // namespace carom::pipeline
