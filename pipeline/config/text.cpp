#include "pipeline/config/text.h"

#include <algorithm>
#include <array>
#include <cstdint>

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

/// Distance of the optimal string alignment, three rows at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        row[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before_last, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

/// Length of the UTF-8 sequence that starts with `lead`; 0 if none does.
std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) {
        return lead == 0 ? 0 : 1;
    }
    if (lead >= 0xC2 && lead <= 0xDF) {
        return 2;
    }
    if (lead >= 0xE0 && lead <= 0xEF) {
        return 3;
    }
    return lead >= 0xF0 && lead <= 0xF4 ? 4 : 0;
}

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

std::string join(std::span<const std::string> words, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) {
            text += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
        }
        text += words[i];
    }
    return text;
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

std::string hint(std::string_view name, std::span<const std::string> known) {
    const std::optional<std::string> nearest = nearest_name(name, known);
    return nearest ? " (did you mean '" + *nearest + "'?)" : std::string();
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
    std::size_t i = 0;
    while (i < text.size()) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = sequence_length(lead);
        if (length == 0 || i + length > text.size()) {
            return i;
        }
        std::uint32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            if ((next & 0xC0U) != 0x80U) {
                return i;
            }
            code = (code << 6U) | (next & 0x3FU);
        }
        const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
        if (overlong || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) {
            return i;
        }
        i += length;
    }
    return std::string_view::npos;
}

}  // namespace carom::pipeline::config
