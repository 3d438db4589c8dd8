// Times, rates and counts as a person reads them.
#pragma once

#include <string>

namespace carom::cli {

/// "0 s", "45 s", "1 min 20 s", "2 h 05 min", "3 d 04 h": two units, rounded to the lesser one.
/// For seconds below 0 or not finite: "?".
[[nodiscard]] std::string duration_text(double seconds);

/// Three significant digits and a prefix: rate_text(8.123e6, "rays/s") is "8.12 Mrays/s".
[[nodiscard]] std::string rate_text(double value, const std::string& unit);

}  // namespace carom::cli
