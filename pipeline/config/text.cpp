#include "pipeline/config/text.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/text.h"
#include "core/utf8.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kLongestQuote = 60;  // bytes

struct SpaceName {
    std::string_view character;
    std::string_view name;
};

// Names of the Unicode Character Database, in words for a sentence.
constexpr std::array kOddSpaces{
    SpaceName{"\u00A0", "a no-break space (U+00A0)"},
    SpaceName{"\u2007", "a figure space (U+2007)"},
    SpaceName{"\u2009", "a thin space (U+2009)"},
    SpaceName{"\u202F", "a narrow no-break space (U+202F)"},
    SpaceName{"\u3000", "an ideographic space (U+3000)"},
};

}  // namespace

std::string quote(std::string_view text) {
    if (text.size() <= kLongestQuote) {
        return "'" + std::string(text) + "'";
    }
    std::size_t end = kLongestQuote;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
        --end;
    }
    return "'" + std::string(text.substr(0, end)) + "...'";
}

std::vector<std::string> quoted(std::span<const std::string> words) {
    std::vector<std::string> result;
    result.reserve(words.size());
    for (const std::string& word : words) {
        result.push_back("'" + word + "'");
    }
    return result;
}

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> known) {
    std::optional<std::string> nearest;
    std::size_t smallest = 0;
    for (const std::string& candidate : known) {
        const std::size_t longer = std::max(name.size(), candidate.size());
        const std::size_t shorter = std::min(name.size(), candidate.size());
        const std::size_t bound = std::max<std::size_t>(1, longer / 3);
        if (longer - shorter > bound || shorter == 0) {
            continue;
        }
        const std::size_t distance = edit_distance(name, candidate);
        if (distance <= bound && distance < longer && (!nearest || distance < smallest)) {
            nearest = candidate;
            smallest = distance;
        }
    }
    return nearest;
}

Message hint(std::string_view name, std::span<const std::string> known) {
    const std::optional<std::string> nearest = nearest_name(name, known);
    return nearest ? Message(" (did you mean '" + *nearest + "'?)", *nearest) : Message();
}

std::optional<OddSpace> find_odd_space(std::string_view text) {
    std::optional<OddSpace> first;
    for (const SpaceName& space : kOddSpaces) {
        const std::size_t offset = text.find(space.character);
        if (offset != std::string_view::npos && (!first || offset < first->offset)) {
            first = {offset, space.character.size(), std::string(space.name)};
        }
    }
    return first;
}

std::size_t find_invalid_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const Utf8Character next = first_character(text.substr(i));
        if (!next || next.letter == 0) {
            return i;
        }
        i += next.bytes;
    }
    return std::string_view::npos;
}

}  // namespace carom::pipeline::config
