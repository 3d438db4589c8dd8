// Texts with values in braces: "{cue.speed:.1f} m/s".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace carom::pipeline {

/// A value of a frame: "scene_time".
struct FrameValue {
    std::string name;
};

/// A value of a ball or object: "cue.speed".
struct ObjectValue {
    std::string object;
    std::string name;
};

/// A value of two balls or objects: "angle cue one".
struct PairValue {
    std::string name;
    std::string first, second;
};

using ValueName = std::variant<FrameValue, ObjectValue, PairValue>;

/// A value of a text, and how its number is written.
struct TextValue {
    ValueName name;
    std::string format;  // of {fmt} for a number, without braces and colon: ".1f"; empty: usual
};

/// A piece of a text: words or a value.
using TextPiece = std::variant<std::string, TextValue>;

/// Why a text cannot be used: a sentence and advice that follows it; for a name that does not
/// exist also the name and those that could be meant.
struct TextProblem {
    std::string sentence;
    std::string advice{};  // begins with a comma or semicolon
    std::string unknown{};
    std::vector<std::string> known{};
};

/// The names of the values, in the order in which messages list them.
[[nodiscard]] std::span<const std::string_view> frame_value_names();
[[nodiscard]] std::span<const std::string_view> object_value_names();
[[nodiscard]] std::span<const std::string_view> pair_value_names();

/// The pieces of a text, in order. "{{" and "}}" are braces. Formats are those of numbers in {fmt}:
/// sign, zeros, width, precision and one of e, f, g. The objects' names are not checked. On the
/// first problem it returns that.
[[nodiscard]] std::variant<std::vector<TextPiece>, TextProblem> parse_value_text(
    std::string_view text);

/// The objects that the values of a text name.
[[nodiscard]] std::vector<std::string> objects_of(std::span<const TextPiece> pieces);

}  // namespace carom::pipeline
