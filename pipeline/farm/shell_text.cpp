#include "pipeline/farm/shell_text.h"

namespace carom::farm {

std::string shell_word(std::string_view text) {
    std::string word = "'";
    for (const char c : text) {
        word += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return word + "'";
}

std::string simple_name(std::string_view text, std::size_t longest) {
    std::string name(text.substr(0, longest));
    for (char& c : name) {
        const bool is_simple = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                               (c >= '0' && c <= '9') || c == '_' || c == '-';
        c = is_simple ? c : '_';
    }
    return name;
}

}  // namespace carom::farm
