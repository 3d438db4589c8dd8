#include "pipeline/picture/value_text.h"

#include <algorithm>
#include <array>

#include "core/text.h"

namespace carom::pipeline {
namespace {

constexpr std::array<std::string_view, 4> kFrameValues{"frame", "scene_time", "video_time",
                                                       "playback_speed"};
constexpr std::array<std::string_view, 7> kObjectValues{"speed", "spin", "direction", "distance",
                                                        "x",     "y",    "z"};
constexpr std::array<std::string_view, 2> kPairValues{"angle", "distance"};

template <class Names>
bool has(const Names& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

std::string in_quotes(std::string_view text) {
    return "'" + std::string(text) + "'";
}

std::string listed(std::span<const std::string_view> names) {
    std::string list;
    for (const std::string_view name : names) {
        list += (list.empty() ? "" : ", ") + std::string(name);
    }
    return list;
}

/// What follows the name of a value that does not exist.
std::string known_values() {
    return "; the values are " + listed(kFrameValues) +
           "; of a ball or object, as in {cue.speed}, " + listed(kObjectValues) +
           "; of two, as in {angle cue one}, " + listed(kPairValues);
}

std::vector<std::string> strings_of(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}

TextProblem unknown_value(std::string_view text, std::string_view name,
                          std::span<const std::string_view> known) {
    return {"there is no value " + in_quotes(text), known_values(), std::string(name),
            strings_of(known)};
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t begin = text.find_first_not_of(' ');
        if (begin == std::string_view::npos) {
            break;
        }
        text.remove_prefix(begin);
        const std::size_t end = std::min(text.find(' '), text.size());
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

/// Whether {fmt} accepts it for a number: [sign][0][width][.precision][efg].
bool is_number_format(std::string_view format) {
    const auto skip_digits = [&format](std::size_t most) {
        std::size_t count = 0;
        while (count < format.size() && format[count] >= '0' && format[count] <= '9') {
            ++count;
        }
        const bool is_short = count <= most;
        format.remove_prefix(count);
        return is_short;
    };
    if (format.starts_with('+') || format.starts_with(' ')) {
        format.remove_prefix(1);
    }
    if (!skip_digits(2)) {
        return false;
    }
    if (format.starts_with('.')) {
        format.remove_prefix(1);
        if (format.empty() || format[0] < '0' || format[0] > '9' || !skip_digits(2)) {
            return false;
        }
    }
    if (!format.empty() && (format[0] == 'e' || format[0] == 'f' || format[0] == 'g')) {
        format.remove_prefix(1);
    }
    return format.empty();
}

std::variant<ValueName, TextProblem> parse_name(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    if (words.empty()) {
        return TextProblem{"there is no name between the braces", known_values()};
    }
    if (words.size() == 3 && has(kPairValues, words[0])) {
        return PairValue{words[0], words[1], words[2]};
    }
    if (words.size() > 1) {
        if (has(kPairValues, words[0])) {
            return TextProblem{in_quotes(text) + " needs the names of two balls or objects",
                               ", as in {" + words[0] + " cue one}"};
        }
        return unknown_value(text, words[0], kPairValues);
    }
    const std::size_t dot = words[0].find('.');
    if (dot == std::string::npos) {
        if (has(kFrameValues, words[0])) {
            return FrameValue{words[0]};
        }
        return unknown_value(text, words[0], kFrameValues);
    }
    ObjectValue value{words[0].substr(0, dot), words[0].substr(dot + 1)};
    if (has(kObjectValues, value.name)) {
        return value;
    }
    return unknown_value(text, value.name, kObjectValues);
}

std::variant<TextValue, TextProblem> parse_value(std::string_view text) {
    const std::size_t colon = text.find(':');
    TextValue value;
    if (colon != std::string_view::npos) {
        value.format = std::string(text.substr(colon + 1));
        if (!is_number_format(value.format)) {
            return TextProblem{in_quotes(value.format) + " does not say how to write a number",
                               "; write .1f for one decimal place, or 6.2f for a width of 6 and "
                               "two decimal places"};
        }
    }
    std::variant<ValueName, TextProblem> name = parse_name(text.substr(0, colon));
    if (auto* problem = std::get_if<TextProblem>(&name)) {
        return std::move(*problem);
    }
    value.name = std::get<ValueName>(std::move(name));
    return value;
}

}  // namespace

std::span<const std::string_view> frame_value_names() {
    return kFrameValues;
}
std::span<const std::string_view> object_value_names() {
    return kObjectValues;
}
std::span<const std::string_view> pair_value_names() {
    return kPairValues;
}

std::variant<std::vector<TextPiece>, TextProblem> parse_value_text(std::string_view text) {
    std::vector<TextPiece> pieces;
    std::string words;
    const auto end_words = [&] {
        if (!words.empty()) {
            pieces.emplace_back(std::move(words));
            words.clear();
        }
    };
    while (!text.empty()) {
        if (text.starts_with("{{") || text.starts_with("}}")) {
            words += text[0];
            text.remove_prefix(2);
        } else if (text[0] == '}') {
            return TextProblem{"a '}' has no '{' before it", "; write '}}' for the brace itself"};
        } else if (text[0] == '{') {
            const std::size_t end = text.find('}');
            if (end == std::string_view::npos) {
                return TextProblem{"a '{' has no '}' after it",
                                   "; write '{{' for the brace itself"};
            }
            std::variant<TextValue, TextProblem> value = parse_value(text.substr(1, end - 1));
            if (auto* problem = std::get_if<TextProblem>(&value)) {
                return std::move(*problem);
            }
            end_words();
            pieces.emplace_back(std::get<TextValue>(std::move(value)));
            text.remove_prefix(end + 1);
        } else {
            words += text[0];
            text.remove_prefix(1);
        }
    }
    end_words();
    return pieces;
}

std::vector<std::string> objects_of(std::span<const TextPiece> pieces) {
    std::vector<std::string> objects;
    for (const TextPiece& piece : pieces) {
        const auto* value = std::get_if<TextValue>(&piece);
        if (value == nullptr) {
            continue;
        }
        if (const auto* object = std::get_if<ObjectValue>(&value->name)) {
            objects.push_back(object->object);
        } else if (const auto* pair = std::get_if<PairValue>(&value->name)) {
            objects.push_back(pair->first);
            objects.push_back(pair->second);
        }
    }
    return objects;
}

}  // namespace carom::pipeline
