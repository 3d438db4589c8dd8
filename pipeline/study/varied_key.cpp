#include "pipeline/study/varied_key.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/normal.h"
#include "pipeline/config/quantity.h"
#include "pipeline/config/text.h"
#include "pipeline/study/sampling.h"

namespace carom::pipeline::study {

namespace {

using config::quote;

constexpr double kMostSteps = 1e6;

/// A part of the option's text.
struct Part {
    std::string text;
    std::size_t offset = 0;
};

struct Wrong {
    TextProblem problem;
};

[[noreturn]] void fail(const Part& part, std::string sentence) {
    throw Wrong{{std::move(sentence), part.offset, std::max<std::size_t>(part.text.size(), 1)}};
}

Part trimmed(const Part& part) {
    const std::size_t first = std::min(part.text.find_first_not_of(' '), part.text.size());
    const std::size_t last = part.text.find_last_not_of(' ');
    return {first < part.text.size() ? part.text.substr(first, last - first + 1) : "",
            part.offset + first};
}

Part part_of(const Part& whole, std::size_t from, std::size_t to) {
    return trimmed({whole.text.substr(from, to - from), whole.offset + from});
}

/// A number with the unit as it is written.
struct Number {
    double value = 0;
    std::string unit;
};

std::optional<Number> find_number(const std::string& text) {
    Number number;
    const char* const last = text.data() + text.size();
    const char* const first = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, code] = std::from_chars(first, last, number.value);
    if (code != std::errc() || !std::isfinite(number.value)) {
        return std::nullopt;
    }
    number.unit = std::string(end, last);
    number.unit.erase(0, number.unit.find_first_not_of(' '));
    return number;
}

/// A number with a unit that exists.
Number number_of(const Part& part) {
    const std::optional<Number> number = find_number(part.text);
    const auto parsed = config::parse_quantity(part.text);
    if (const auto* problem = std::get_if<config::QuantityProblem>(&parsed)) {
        if (problem->kind != config::QuantityProblem::Kind::not_a_number) {
            fail(part, quote(part.text) + " " + problem->message.text);
        }
    }
    if (!number) {
        fail(part, part.text.empty() ? "a number is missing here"
                                     : quote(part.text) + " is not a number");
    }
    return *number;
}

/// The SI value of one of a unit, and its dimension.
config::Quantity one_of(const std::string& unit) {
    return std::get<config::Quantity>(config::parse_quantity("1 " + unit));
}

/// The number in `unit`; one without a unit is in it already.
double in_unit(const Part& part, const std::string& unit) {
    const Number number = number_of(part);
    if (number.unit.empty() || number.unit == unit) {
        return number.value;
    }
    const config::Quantity own = one_of(number.unit);
    const config::Quantity wanted = one_of(unit);
    if (own.exponents != wanted.exponents) {
        fail(part, quote(part.text) + " is " + config::name_of(own.exponents) + ", where " +
                       (unit.empty() ? "a plain number"
                                     : config::name_of(wanted.exponents) + " in " + unit) +
                       " is needed");
    }
    return number.value * own.value / wanted.value;
}

std::string text_of_number(double value, const std::string& unit) {
    return fmt::format("{}", value) + (unit.empty() ? "" : " " + unit);
}

VariedPoint point_of(double value, const std::string& unit) {
    return {text_of_number(value, unit), value};
}

/// LOW..HIGH UNIT or LOW..HIGH UNIT:STEP
void read_range(const Part& value, std::size_t dots, VariedKey& key) {
    const std::size_t colon = std::min(value.text.find(':', dots), value.text.size());
    const Part low = part_of(value, 0, dots);
    const Part high = part_of(value, dots + 2, colon);
    key.unit = number_of(high).unit;
    if (key.unit.empty()) {
        key.unit = number_of(low).unit;
    }
    key.low = in_unit(low, key.unit);
    key.high = in_unit(high, key.unit);
    const Part range = part_of(value, 0, colon);
    if (key.low == key.high) {
        fail(range, "the range is empty: both ends are " + text_of_number(key.low, key.unit));
    }
    if (key.low > key.high) {
        fail(range, "the range begins above its end; write " + fmt::format("{}..", key.high) +
                        text_of_number(key.low, key.unit));
    }
    if (colon == value.text.size()) {
        return;
    }
    const Part step_text = part_of(value, colon + 1, value.text.size());
    const double step = in_unit(step_text, key.unit);
    const double steps = (key.high - key.low) / step;
    if (step <= 0) {
        fail(step_text, "the step must be above 0");
    }
    if (steps < 1 - 1e-9) {
        fail(step_text, "the step is larger than the range of " +
                            text_of_number(key.high - key.low, key.unit));
    }
    if (steps > kMostSteps) {
        fail(step_text, "the range has more than 1000000 such steps");
    }
    const auto count = static_cast<std::size_t>(steps * (1 + 1e-9));
    for (std::size_t i = 0; i <= count; ++i) {
        // 12 digits, so that 0.1 + 2 * 0.1 is 0.3.
        const std::string decimal = fmt::format("{:.12g}", key.low + static_cast<double>(i) * step);
        key.points.push_back(point_of(find_number(decimal)->value, key.unit));
    }
}

/// VALUE~ERROR; VALUE is empty where the shot's is meant.
void read_error(const Part& value, const Part& error, VariedKey& key, const TextOfKey& text_of) {
    Part mean = value;
    if (mean.text.empty()) {
        const std::optional<std::string> own = text_of(key.key);
        const Part name{key.key, 0};
        if (!own) {
            fail(name, "the shot gives no single value to " + quote(key.key) +
                           ", around which there could be an error; write KEY=VALUE~ERROR");
        }
        const auto parsed = config::parse_quantity(*own);
        if (!find_number(*own) || !std::holds_alternative<config::Quantity>(parsed)) {
            fail(name, quote(key.key) + " is " + quote(*own) +
                           " in the shot, which is not a number with an error");
        }
        mean = {*own, 0};
    }
    const Number number = number_of(mean);
    key.is_normal = true;
    key.mean = number.value;
    key.unit = number.unit;
    key.deviation = in_unit(error, key.unit);
    if (key.deviation <= 0) {
        fail(error, "the error must be above 0; it is the standard deviation");
    }
}

std::vector<Part> list_of(const Part& value) {
    std::vector<Part> parts;
    int depth = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i <= value.text.size(); ++i) {
        const char c = i < value.text.size() ? value.text[i] : ',';
        depth += (c == '[' || c == '{' ? 1 : 0) - (c == ']' || c == '}' ? 1 : 0);
        if (i == value.text.size() || (c == ',' && depth <= 0)) {
            parts.push_back(part_of(value, first, i));
            first = i + 1;
        }
    }
    return parts;
}

/// VALUE,VALUE,...
void read_list(const Part& value, VariedKey& key) {
    const std::vector<Part> parts = list_of(value);
    if (parts.size() == 1) {
        fail(value, value.text.empty()
                        ? "the values are missing: write 1..8 m/s:0.5, a list such as 1,2,4, or an "
                          "error such as ~0.1"
                        : "this is a single value, which --set gives; write a range such as 1..8 "
                          "m/s:0.5, a list such as 1,2,4, or an error such as ~0.1");
    }
    bool is_numeric = true;
    for (const Part& part : parts) {
        if (part.text.empty()) {
            fail(part, "a value is missing here");
        }
        const auto same = [&](const VariedPoint& point) { return point.text == part.text; };
        if (std::ranges::any_of(key.points, same)) {
            fail(part, quote(part.text) + " is in the list twice");
        }
        const std::optional<Number> number = find_number(part.text);
        is_numeric = is_numeric && number && (&part == &parts.front() || number->unit == key.unit);
        key.unit = number && &part == &parts.front() ? number->unit : key.unit;
        key.points.push_back(
            {part.text, number ? std::optional(number->value) : std::optional<double>()});
    }
    if (!is_numeric) {
        key.unit.clear();
        for (VariedPoint& point : key.points) {
            point.number.reset();
        }
    }
}

VariedKey read(const std::string& text, const TextOfKey& text_of) {
    const std::size_t sign = text.find_first_of("=~");
    const Part whole{text, 0};
    VariedKey key;
    key.key = part_of(whole, 0, std::min(sign, text.size())).text;
    if (sign == std::string::npos || key.key.empty()) {
        fail(whole, quote(text) +
                        " is not of the form KEY=LOW..HIGH:STEP, KEY=VALUE,VALUE or KEY~ERROR, as "
                        "in 'events[0].strike.speed=1..8 m/s:0.5'");
    }
    const Part value = part_of(whole, sign + 1, text.size());
    if (text[sign] == '~') {
        read_error({}, value, key, text_of);
        return key;
    }
    // In a list of words, such as paths, these signs have no meaning.
    const bool is_number = config::looks_like_number(value.text);
    const std::size_t error = is_number ? value.text.find('~') : std::string::npos;
    const std::size_t dots = is_number ? value.text.find("..") : std::string::npos;
    if (error != std::string::npos) {
        read_error(part_of(value, 0, error), part_of(value, error + 1, value.text.size()), key,
                   text_of);
    } else if (dots != std::string::npos) {
        read_range(value, dots, key);
    } else {
        read_list(value, key);
    }
    return key;
}

}  // namespace

bool VariedKey::is_numeric() const {
    return std::ranges::all_of(points,
                               [](const VariedPoint& point) { return point.number.has_value(); });
}

VariedPoint VariedKey::at(double coordinate) const {
    return point_of(is_normal ? mean + deviation * normal_quantile(coordinate)
                              : low + (high - low) * coordinate,
                    unit);
}

std::string VariedKey::title() const {
    return unit.empty() ? key : key + " [" + unit + "]";
}

std::variant<VariedKey, TextProblem> parse_varied(const std::string& text,
                                                  const TextOfKey& text_of) {
    try {
        return read(text, text_of);
    } catch (const Wrong& wrong) {
        return wrong.problem;
    }
}

}  // namespace carom::pipeline::study
