#include "pipeline/config/decimal_pattern.h"

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"

namespace carom::pipeline::config {

namespace {

/// The digits before the point without leading zeros, and those after it without trailing zeros.
struct Decimal {
    std::string whole;
    std::string fraction;

    [[nodiscard]] bool is_zero() const { return whole.empty() && fraction.empty(); }
};

/// Converts a number that is not negative; more than nine digits are rounded up or down.
Decimal decimal(double value, bool upwards) {
    constexpr int kDigits = 9;
    value = std::abs(value);  // -0 is 0
    const int magnitude = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 0;
    const int places = std::max(0, kDigits - magnitude);
    std::string text = fmt::format("{:.{}f}", value, places);
    const double step = std::pow(10.0, -places);
    const double shown = std::strtod(text.c_str(), nullptr);
    const double tolerance = 1e-12 * value;  // for the conversion from SI units
    if (std::abs(shown - value) > tolerance && (shown < value) == upwards) {
        text = fmt::format("{:.{}f}", shown + (upwards ? step : -step), places);
    }
    const std::size_t point = std::min(text.find('.'), text.size());
    Decimal result{text.substr(0, point), text.substr(std::min(point + 1, text.size()))};
    result.whole.erase(0, std::min(result.whole.find_first_not_of('0'), result.whole.size()));
    result.fraction.erase(result.fraction.find_last_not_of('0') + 1);
    return result;
}

std::string alternatives(const std::vector<std::string>& forms) {
    return "(" + join(forms, "|") + ")";
}

/// "[3-9]"; empty if the range is empty.
std::string digits(char low, char high) {
    if (low > high) {
        return {};
    }
    return low == high ? std::string(1, low) : std::string("[") + low + "-" + high + "]";
}

/// "[0-9]{3}".
std::string any_digits(std::size_t count) {
    return count == 0 ? "" : fmt::format("[0-9]{{{}}}", count);
}

/// Adds the numbers whose first digit that differs from `bound` is less (or greater); the digits
/// after it are arbitrary.
void add_first_differences(std::vector<std::string>& forms, const std::string& before,
                           const std::string& bound, bool is_less, bool is_fraction) {
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const auto here = is_less ? digits('0', static_cast<char>(bound[i] - 1))
                                  : digits(static_cast<char>(bound[i] + 1), '9');
        if (!here.empty()) {
            const std::string rest =
                is_fraction ? "[0-9]*" : any_digits(bound.size() - i - 1) + R"((\.[0-9]*)?)";
            forms.push_back(before);
            forms.back().append(bound, 0, i).append(here).append(rest);
        }
    }
}

std::string at_most_pattern(const Decimal& bound, bool is_open) {
    std::vector<std::string> forms;
    const std::string same = "0*" + bound.whole;
    if (!bound.whole.empty()) {
        forms.push_back(bound.whole.size() == 1
                            ? R"(0*(\.[0-9]*)?)"
                            : fmt::format(R"(0*[0-9]{{0,{}}}(\.[0-9]*)?)", bound.whole.size() - 1));
        add_first_differences(forms, "0*", bound.whole, true, false);
    }
    if (!bound.fraction.empty()) {
        forms.push_back(same + R"(\.?)");
        add_first_differences(forms, same + R"(\.)", bound.fraction, true, true);
        for (std::size_t i = 1; i < bound.fraction.size(); ++i) {
            forms.push_back(same + R"(\.)" + bound.fraction.substr(0, i));
        }
    }
    if (!is_open) {
        forms.push_back(bound.fraction.empty() ? same + R"((\.0*)?)"
                                               : same + R"(\.)" + bound.fraction + "0*");
    }
    return forms.empty() ? "(?!)" : alternatives(forms);
}

std::string at_least_pattern(const Decimal& bound, bool is_open) {
    std::vector<std::string> forms;
    const std::string same = "0*" + bound.whole;
    forms.push_back(fmt::format(R"(0*[1-9][0-9]{{{},}}(\.[0-9]*)?)", bound.whole.size()));
    add_first_differences(forms, "0*", bound.whole, false, false);
    add_first_differences(forms, same + R"(\.)", bound.fraction, false, true);
    const std::string equal = same + (bound.fraction.empty() ? "" : R"(\.)" + bound.fraction);
    const std::string tail = bound.fraction.empty() ? R"(\.[0-9]*)" : "[0-9]*";
    forms.push_back(equal + tail + "[1-9][0-9]*");
    if (!is_open) {
        forms.push_back(bound.fraction.empty() ? equal + R"((\.0*)?)" : equal + "0*");
    }
    return alternatives(forms);
}

/// Matches the numbers of `range` without a sign.
std::string positive_pattern(const Range& range) {
    const std::string end = "(?![0-9.])";
    std::string pattern;
    if (range.low && *range.low >= 0 && !(*range.low == 0 && !range.low_open)) {
        pattern += "(?=" + at_least_pattern(decimal(*range.low, false), range.low_open) + end + ")";
    }
    if (range.high) {
        pattern += "(?=" + at_most_pattern(decimal(*range.high, true), range.high_open) + end + ")";
    }
    return pattern + R"(([0-9]+\.?[0-9]*|\.[0-9]+))";
}

/// The range of the negated numbers.
Range negated(const Range& range) {
    Range result;
    if (range.high) {
        result.low = -*range.high;
    }
    if (range.low) {
        result.high = -*range.low;
    }
    result.low_open = range.high_open;
    result.high_open = range.low_open;
    return result;
}

bool has_positive(const Range& range) {
    return !range.high || *range.high > 0 || (*range.high == 0 && !range.high_open);
}

}  // namespace

std::string decimal_pattern(const Range& range) {
    std::vector<std::string> forms;
    if (has_positive(range)) {
        forms.push_back(R"(\+?)" + positive_pattern(range));
    }
    if (has_positive(negated(range))) {
        forms.push_back("-" + positive_pattern(negated(range)));
    }
    return alternatives(forms);
}

std::string sign_pattern(const Range& range) {
    const bool may_be_negative = !range.low || *range.low < 0;
    const bool may_be_positive = !range.high || *range.high > 0;
    const std::string zero = R"((?=0*\.?0*(?![0-9.])))";
    return "(" + std::string(may_be_positive ? R"(\+?)" : R"(\+?)" + zero) + "|-" +
           (may_be_negative ? "" : zero) + ")";
}

}  // namespace carom::pipeline::config
