#include "pipeline/cli/report_filter.h"

#include <algorithm>

#include "core/text.h"
#include "pipeline/cli/moment_text.h"
#include "pipeline/cli/quantity_option.h"
#include "pipeline/cli/retime_words.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/config/text.h"

namespace carom::cli {

namespace {

namespace config = pipeline::config;

/// Throws InputError if nothing in the report has the name.
void check_name(const std::string& name, const pipeline::ShotReport& report) {
    std::vector<std::string> known;
    for (const pipeline::ReportedObject& object : report.objects) {
        known.push_back(object.name);
    }
    for (const pipeline::ReportedEvent& row : report.events) {
        known.insert(known.end(), {row.event.a, row.event.b});
    }
    if (name.empty() || std::ranges::find(known, name) == known.end()) {
        throw InputError("--object: nothing in the report is called " + config::quote(name) +
                         config::hint(name, known).text);
    }
}

double impulse_of(const std::string& text) {
    constexpr config::Exponents kImpulse{1, 1, -1, 0};
    return text.empty()
               ? 0
               : parse_value(text, kImpulse, "an impulse; write 0.01 or '0.01 N s'").to_double();
}

}  // namespace

std::vector<std::string> words_of(const std::string& option, const std::string& list,
                                  const std::vector<std::string>& known) {
    std::vector<std::string> words;
    for (std::size_t start = 0; !list.empty() && start <= list.size();) {
        const std::size_t comma = std::min(list.find(',', start), list.size());
        std::string word = list.substr(start, comma - start);
        word.erase(0, word.find_first_not_of(' '));
        word.erase(word.find_last_not_of(' ') + 1);
        if (std::ranges::find(known, word) == known.end()) {
            throw InputError(option + ": there is no " + config::quote(word) +
                             config::hint(word, known).text + "; the words are " +
                             join(known, ", "));
        }
        words.push_back(std::move(word));
        start = comma + 1;
    }
    return words;
}

bool names_moments(const ReportCommand& command) {
    return is_moment_text(command.from) || is_moment_text(command.to);
}

pipeline::ReportFilter report_filter(const ReportCommand& command,
                                     const pipeline::ShotReport& report, const ShotInput& input) {
    pipeline::ReportFilter filter;
    const std::vector<std::string> words = pipeline::report_words();
    filter.only = words_of("--only", command.only, words);
    filter.without = words_of("--without", command.without, words);
    for (const std::string& name : command.objects) {
        check_name(name, report);
    }
    filter.objects = command.objects;
    if (const auto from = scene_time_of("--from", command.from, input)) {
        filter.from = from->to_double();
    }
    if (const auto to = scene_time_of("--to", command.to, input)) {
        filter.to = to->to_double();
    }
    if (filter.to < filter.from) {
        throw InputError("--to is before --from");
    }
    filter.min_impulse = impulse_of(command.min_impulse);
    return filter;
}

}  // namespace carom::cli
