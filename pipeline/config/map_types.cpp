#include "pipeline/config/map_types.h"

#include <algorithm>
#include <string_view>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kMaxNameLength = 64;

/// "a ball", "an object"
std::string with_article(const std::string& noun) {
    const bool has_vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
    return (has_vowel ? "an " : "a ") + noun;
}

}  // namespace

bool check_name(Reader& reader, const std::string& name, const Place& place,
                const std::string& noun) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    };
    const bool starts_well = !name.empty() && is_allowed(name[0]) && name[0] != '-' &&
                             !(name[0] >= '0' && name[0] <= '9');
    if (!starts_well || name.size() > kMaxNameLength ||
        !std::all_of(name.begin(), name.end(), is_allowed)) {
        reader.error(place, quote(name) + " cannot be the name of " + with_article(noun) +
                                "; a name is a letter or _, then letters, digits, _ and -, at most "
                                "64 characters in all");
        return false;
    }
    static const std::vector<std::string> kReserved{"all", "auto", "none", "true", "false", "null"};
    if (std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end()) {
        reader.error(place, quote(name) + " is a reserved word and cannot be the name of " +
                                with_article(noun));
        return false;
    }
    return true;
}

}  // namespace carom::pipeline::config
