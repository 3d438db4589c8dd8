#include "pipeline/cli/quantity_option.h"

#include "pipeline/cli/run_program.h"
#include "pipeline/config/number_types.h"

namespace carom::cli {

namespace config = pipeline::config;

pipeline::Rational parse_value(std::string_view text, const config::Exponents& exponents,
                               const std::string& expected) {
    const auto parsed = config::parse_quantity(text);
    const auto* quantity = std::get_if<config::Quantity>(&parsed);
    constexpr double kLargest = 1e6;
    if (quantity == nullptr || (quantity->has_unit && !(quantity->exponents == exponents)) ||
        !(quantity->value >= -kLargest && quantity->value <= kLargest)) {
        throw InputError("'" + std::string(text) + "' is not " + expected);
    }
    return config::to_rational(*quantity);
}

}  // namespace carom::cli
