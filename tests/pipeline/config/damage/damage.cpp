#include "tests/pipeline/config/damage/damage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <string_view>
#include <vector>

namespace carom::testing {

namespace {

bool is_indentation(const std::string& text, std::size_t i) {
    const std::size_t start = i == 0 ? 0 : text.rfind('\n', i - 1) + 1;
    return text[i] == ' ' && text.find_first_not_of(' ', start) > i;
}

/// Whether a letter follows a number: "57.15 mm", "3 m/s".
bool is_unit(const std::string& text, std::size_t i) {
    if (std::isalpha(static_cast<unsigned char>(text[i])) == 0 && text[i] != '/') {
        return false;
    }
    const std::string_view unit_characters = "abcdefghijklmnopqrstuvwxyzHN/^";
    const std::size_t before = text.find_last_not_of(unit_characters, i);
    return before != std::string::npos && before > 0 && text[before] == ' ' &&
           std::isdigit(static_cast<unsigned char>(text[before - 1])) != 0;
}

struct Kind {
    const char* name;
    std::string characters;  // to insert
    std::function<bool(const std::string&, std::size_t)> holds;
};

const std::vector<Kind>& kinds() {
    const auto any_of = [](const std::string& characters) {
        return [characters](const std::string& text, std::size_t i) {
            return characters.find(text[i]) != std::string::npos;
        };
    };
    static const std::vector<Kind> all{
        {"quote", "'\"", any_of("'\"")},  {"bracket", "[]{}", any_of("[]{}")},
        {"colon", ":", any_of(":")},      {"comma", ",", any_of(",")},
        {"dash", "-", any_of("-")},       {"indentation", " \t", is_indentation},
        {"line end", "\n", any_of("\n")}, {"unit", "mskgdeinrptoc/", is_unit},
    };
    return all;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// The indentation of a line that is not empty; -1 for others.
int indent_of(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first == std::string::npos || line[first] == '#' ? -1 : static_cast<int>(first);
}

void find_construct(const std::string& text, Damage& damage) {
    const std::vector<std::string> lines = lines_of(text);
    const int count = static_cast<int>(lines.size());
    const int at = std::min(damage.line, count) - 1;
    const int own = indent_of(lines[at]);
    int first = at;
    while (first > 0 && (indent_of(lines[first]) < 0 || indent_of(lines[first]) >= own)) {
        --first;
    }
    const int parent = indent_of(lines[first]);
    int last = at + 1;
    while (last < count && (indent_of(lines[last]) < 0 || indent_of(lines[last]) > parent)) {
        ++last;
    }
    for (int line = first, indent = own; line >= 0; --line) {
        if (indent_of(lines[line]) >= 0 && indent_of(lines[line]) < indent) {
            indent = indent_of(lines[line]);
            damage.enclosing.push_back(lines[line]);
        }
    }
    damage.old_line = lines[at];
    damage.new_line = lines_of(damage.text)[at];
    damage.first_line = first + 1;
    damage.last_line = own <= 0 ? count : std::min(last + 1, count);
}

std::vector<std::size_t> places_of(const Kind& kind, const std::string& text) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (kind.holds(text, i)) {
            places.push_back(i);
        }
    }
    return places;
}

std::size_t line_start_near(const std::string& text, std::size_t at) {
    const std::size_t end = text.rfind('\n', at == 0 ? 0 : at - 1);
    return end == std::string::npos ? 0 : end + 1;
}

}  // namespace

Damage damage(const std::string& text, Dice& dice) {
    const Kind& kind =
        kinds()[static_cast<std::size_t>(dice.below(static_cast<int>(kinds().size())))];
    const std::vector<std::size_t> places = places_of(kind, text);
    const int action = places.empty() ? 1 : dice.below(3);  // delete, insert, replace
    std::size_t at = static_cast<std::size_t>(dice.below(static_cast<int>(text.size())));
    const bool is_unit_kind = kind.characters.size() > 4;
    if (action != 1 || (is_unit_kind && !places.empty())) {
        at = places[static_cast<std::size_t>(dice.below(static_cast<int>(places.size())))];
    } else if (kind.characters.starts_with(' ')) {
        at = line_start_near(text, at);
    }
    const std::string all = "'\"[]{}:,- \t";
    const std::string& from = action == 2 && !is_unit_kind ? all : kind.characters;
    const char put = from[static_cast<std::size_t>(dice.below(static_cast<int>(from.size())))];
    Damage result;
    result.text = text;
    result.text.replace(at, action == 1 ? 0 : 1, action == 0 ? 0 : 1, put);
    result.line = 1 + static_cast<int>(std::count(
                          text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    static constexpr std::array kActions{"deleted", "inserted", "replaced"};
    result.what = std::string(kind.name) + " " + kActions[static_cast<std::size_t>(action)] +
                  (action == 0   ? ""
                   : put == '\n' ? " with a line end"
                                 : std::string(" with ") + put);
    find_construct(text, result);
    result.last_line += action == 1 && put == '\n' ? 1 : 0;
    return result;
}

}  // namespace carom::testing
