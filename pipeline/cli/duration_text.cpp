#include "pipeline/cli/duration_text.h"

#include <variant>

#include "pipeline/cli/run_program.h"
#include "pipeline/config/number_types.h"
#include "pipeline/config/units.h"

namespace carom::cli {

namespace config = pipeline::config;

std::chrono::duration<double> parse_duration(const std::string& text) {
    // Shots have no days.
    const bool is_days = text.ends_with('d');
    const auto parsed =
        config::parse_quantity(is_days ? text.substr(0, text.size() - 1) + "h" : text);
    const auto* quantity = std::get_if<config::Quantity>(&parsed);
    const double seconds = quantity != nullptr ? quantity->value * (is_days ? 24 : 1) : -1;
    const bool is_time = quantity != nullptr && quantity->has_unit &&
                         quantity->exponents == config::Exponents{.second = 1};
    constexpr double kLongest = 1e9;  // s
    if (!is_time || !(seconds >= 0 && seconds <= kLongest)) {
        throw InputError("'" + text + "' is not a time; write it as 30d, 12h, 90min, 20s or 500ms");
    }
    return std::chrono::duration<double>(seconds);
}

}  // namespace carom::cli
