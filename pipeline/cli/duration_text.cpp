#include "pipeline/cli/duration_text.h"

#include <cstdlib>

#include "pipeline/cli/run_program.h"

namespace carom::cli {

std::chrono::duration<double> parse_duration(const std::string& text) {
    char* end = nullptr;
    const bool has_number = !text.empty() && text.front() >= '0' && text.front() <= '9';
    const double value = has_number ? std::strtod(text.c_str(), &end) : 0;
    std::string unit = has_number ? end : "";
    unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size()
                                                                   : unit.find_first_not_of(' '));
    const double seconds = unit == "d"     ? 86400
                           : unit == "h"   ? 3600
                           : unit == "min" ? 60
                           : unit == "s"   ? 1
                                           : 0;
    if (seconds == 0 || value * seconds > 1e9) {
        throw InputError("'" + text + "' is not a time; write it as 30d, 12h, 90min or 20s");
    }
    return std::chrono::duration<double>(value * seconds);
}

}  // namespace carom::cli
