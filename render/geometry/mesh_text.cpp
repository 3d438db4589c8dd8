#include "render/geometry/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/core.h>

#include "core/printable.h"

namespace carom::render {
namespace {

/// The sentence for one case and for several, which contain "{}" for their number.
std::pair<const char*, const char*> sentences_of(MeshBlemish blemish) {
    switch (blemish) {
        case MeshBlemish::bad_normal:
            return {"a normal has no length or is not three numbers; it is ignored",
                    "{} normals have no length or are not three numbers; they are ignored"};
        case MeshBlemish::bad_uv:
            return {"a texture coordinate is not a number; it counts as 0",
                    "{} texture coordinates are not numbers; they count as 0"};
        case MeshBlemish::uv_count:
            return {
                "a face does not have two texture coordinates for each corner; they are ignored",
                "{} faces do not have two texture coordinates for each corner; theirs are "
                "ignored"};
        case MeshBlemish::some_corners_without_normal:
            return {"a face has no normals, so that those of all others are ignored",
                    "{} faces have no normals, so that those of all others are ignored"};
        case MeshBlemish::some_corners_without_uv:
            return {"a face has no texture coordinates, so that those of all others are ignored",
                    "{} faces have no texture coordinates, so that those of all others are "
                    "ignored"};
        case MeshBlemish::index_zero:
            return {
                "a face refers to normal or texture coordinate 0, which does not exist; it "
                "counts as none",
                "{} corners refer to normal or texture coordinate 0, which does not exist; "
                "it counts as none"};
        case MeshBlemish::unknown_statement:
            return {"a line is no statement of an OBJ file; it is ignored",
                    "{} lines are no statements of an OBJ file; they are ignored"};
        case MeshBlemish::curved_surface:
            return {"a curve or curved surface is ignored; only faces are read",
                    "{} statements of curves and curved surfaces are ignored; only faces are "
                    "read"};
        case MeshBlemish::several_pictures:
            break;
    }
    return {"a face has another picture than the first face; the object's material covers all",
            "{} faces have another picture than the first face; the object's material covers all"};
}

/// Whether a word is how the C library of Microsoft prints a number that is none, such as
/// "-1.#IND" or "1.#QNAN0".
bool is_special_of_microsoft(std::string_view word) {
    const std::size_t mark = word.find(".#");
    if (mark == std::string_view::npos) {
        return false;
    }
    const std::string_view kind = word.substr(mark + 2);
    return kind.starts_with("IND") || kind.starts_with("QNAN") || kind.starts_with("SNAN") ||
           kind.starts_with("INF");
}

/// Whether the digits of a number outside of a double's range stand for a very small one.
bool is_tiny(std::string_view number) {
    return number.find("e-") != std::string_view::npos ||
           number.find("E-") != std::string_view::npos || number.starts_with("0.") ||
           number.starts_with("-0.") || number.starts_with(".");
}

}  // namespace

void refuse(std::size_t line, std::string sentence) {
    throw MeshRefusal{{line, std::move(sentence)}};
}

void check_corner_count(std::size_t count, std::size_t line) {
    if (count < 3 || count > kMaxCorners) {
        refuse(line,
               fmt::format("a face of {} corners (3 to {} are possible)", count, kMaxCorners));
    }
}

std::vector<MeshRemark> MeshBlemishes::warnings() const {
    std::vector<MeshRemark> warnings;
    for (const auto& [blemish, cases] : cases_) {
        const auto [one, several] = sentences_of(blemish);
        warnings.push_back(
            {cases.first_line, cases.count == 1 ? std::string(one)
                                                : fmt::format(fmt::runtime(several), cases.count)});
    }
    return warnings;
}

std::size_t after_line_end(std::string_view text, std::size_t end) {
    if (end >= text.size()) {
        return text.size();
    }
    return end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
}

void add_words(std::string_view line, std::vector<std::string_view>& words) {
    std::size_t at = 0;
    for (;;) {
        while (at < line.size() && is_blank(line[at])) {
            ++at;
        }
        const std::size_t begin = at;
        while (at < line.size() && !is_blank(line[at])) {
            ++at;
        }
        if (begin == at) {
            return;
        }
        words.push_back(line.substr(begin, at - begin));
    }
}

std::optional<double> number_of(std::string_view word) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) {
            return std::nullopt;
        }
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (stop != word.data() + word.size()) {
        return is_special_of_microsoft(word) ? std::optional(kNone) : std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        return is_tiny(word) ? 0 : kNone;
    }
    if (error != std::errc()) {
        return std::nullopt;
    }
    return value - value == 0 ? value : kNone;
}

std::string quoted(std::string_view word) {
    constexpr std::size_t kShown = 40;  // bytes
    return "'" + printable(word.substr(0, kShown)) + (word.size() > kShown ? "...'" : "'");
}

std::string not_a_number(std::string_view word) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t comma = word.find(',');
    const bool is_decimal_comma = comma != std::string_view::npos && comma > 0 &&
                                  comma + 1 < word.size() && is_digit(word[comma - 1]) &&
                                  is_digit(word[comma + 1]);
    return quoted(word) + " is not a number" +
           (is_decimal_comma ? "; decimals need a point instead of a comma" : "");
}

}  // namespace carom::render
