#include "pipeline/config/map_types.h"

#include <algorithm>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kLongestName = 64;

}  // namespace

bool check_name(Reader& reader, const std::string& name, const Place& place,
                const std::string& noun) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    };
    const bool starts_well = !name.empty() && is_allowed(name[0]) && name[0] != '-' &&
                             !(name[0] >= '0' && name[0] <= '9');
    if (!starts_well || name.size() > kLongestName ||
        !std::all_of(name.begin(), name.end(), is_allowed)) {
        reader.error(place, quote(name) + " cannot be the name of a " + noun +
                                ": a letter, then letters, digits, _ and -, at most 64 in all");
        return false;
    }
    static const std::vector<std::string> kReserved{"all", "auto", "none", "true", "false", "null"};
    if (std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end()) {
        reader.error(place,
                     quote(name) + " has a meaning of its own and cannot be the name of a " + noun);
        return false;
    }
    return true;
}

}  // namespace carom::pipeline::config
