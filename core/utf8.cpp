#include "core/utf8.h"

namespace carom {

Utf8Character first_character(std::string_view text) {
    if (text.empty()) {
        return {};
    }
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x80) {
        return {lead, 1};
    }
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) {
        return {};
    }
    char32_t letter = lead & (0xFFU >> (bytes + 1));
    for (const char c : text.substr(1, bytes - 1)) {
        const auto next = static_cast<unsigned char>(c);
        if ((next & 0xC0U) != 0x80U) {
            return {};
        }
        letter = letter << 6U | (next & 0x3FU);
    }
    const bool is_overlong = (bytes == 3 && letter < 0x800) || (bytes == 4 && letter < 0x10000);
    const bool is_surrogate = letter >= 0xD800 && letter <= 0xDFFF;
    if (is_overlong || is_surrogate || letter > 0x10FFFF) {
        return {};
    }
    return {letter, bytes};
}

}  // namespace carom
