// What all measurements of carom compare share: their progress, their outputs, their lists.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/terminal/progress_meter.h"

namespace carom::cli {

/// Throws InputError if an output cannot be written.
void check_outputs(const CompareCommand& command);

/// The result in every requested form.
struct Texts {
    std::string text, csv, plot;
};
void write_texts(const CompareCommand& command, const Texts& texts);

/// Throws Stopped unless everything was measured.
void stop_unless(bool is_whole);

/// Seconds of a clock that never goes back.
[[nodiscard]] double now();

/// The result of `measure`, with its progress displayed.
template <class Measure>
auto with_progress(CommandContext& context, const Measure& measure) {
    ProgressMeter meter;
    auto result = measure([&](std::string_view /*structure*/, double fraction) {
        meter.on_progress("compare", fraction, now());
        context.console.progress(meter.snapshot(now()));
    });
    context.console.end_progress();
    return result;
}

/// What an option's list may contain.
struct ListRule {
    std::string_view option;  // "--leaf-capacity"
    double lowest = 1, highest = 1;
    bool is_whole = true;  // whole numbers only
};

/// The numbers of a list such as "1,2,4", without repetition. Throws InputError.
[[nodiscard]] std::vector<double> numbers_of(const std::string& text, const ListRule& rule);

}  // namespace carom::cli
