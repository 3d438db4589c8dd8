#include "core/printable.h"

#include <cstddef>

namespace carom {

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
        if (byte == 0xC2 && next >= 0x80 && next <= 0x9F) {  // UTF-8 of U+0080 to U+009F
            shown += '?';
            ++i;
        } else if ((byte < 0x20 && byte != '\t') || byte == 0x7F) {
            shown += '?';
        } else {
            shown += text[i];
        }
    }
    return shown;
}

}  // namespace carom
