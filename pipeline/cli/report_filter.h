// The options that say what is wanted of a report: --only, --object, --from ...
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/report/report_parts.h"

namespace carom::cli {

/// Whether --from or --to is a moment, for which the input's motion has to be known.
[[nodiscard]] bool names_moments(const ReportCommand& command);

/// Throws InputError if a word, a name, a time or an impulse is none.
[[nodiscard]] pipeline::ReportFilter report_filter(const ReportCommand& command,
                                                   const pipeline::ShotReport& report,
                                                   const ShotInput& input);

/// The words of a list with commas. Throws InputError if one is not among the `known` ones.
/// `option` ("--only") is for the message.
[[nodiscard]] std::vector<std::string> words_of(const std::string& option, const std::string& list,
                                                const std::vector<std::string>& known);

}  // namespace carom::cli
