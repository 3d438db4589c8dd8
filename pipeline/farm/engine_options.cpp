#include "pipeline/farm/engine_options.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

namespace carom::farm {
namespace {

/// How a program that submits reads its options.
struct Syntax {
    std::string program;
    std::string flags;                                    // short options without a value
    std::string own;                                      // short options that are not the user's
    std::vector<std::string_view> names;                  // long ones
    std::map<char, std::vector<std::string_view>> parts;  // of values in a list with commas
};

/// sbatch(1) of Slurm; qsub(1B) of OpenPBS and PBS Professional.
const std::map<std::string, Syntax>& syntaxes() {
    static const std::map<std::string, Syntax> all{
        {"slurm",
         {"sbatch",
          "HIKOQWhksuVv",
          "abcdeopthuADJMVW",
          {"--account",    "--array",         "--begin",       "--chdir",       "--clusters",
           "--comment",    "--cpus-per-task", "--dependency",  "--error",       "--help",
           "--job-name",   "--mem",           "--mem-per-cpu", "--mem-per-gpu", "--nice",
           "--no-requeue", "--open-mode",     "--output",      "--parsable",    "--partition",
           "--requeue",    "--signal",        "--test-only",   "--time",        "--time-min",
           "--usage",      "--version",       "--wait",        "--wrap",        "--exclude"},
          {}}},
        {"pbs",
         {"qsub",
          "IVXfhz",
          "ACIJNXefjopqrvz",
          {"--version"},
          {{'l', {"select", "walltime", "ncpus", "mem"}}, {'W', {"depend", "block"}}}}}};
    return all;
}

/// The own option that the word gives a value to by a short name; empty: none.
std::string own_short(const Syntax& syntax, const std::string& word) {
    for (std::size_t at = 1; at < word.size(); ++at) {
        const char name = word[at];
        if (syntax.own.find(name) != std::string::npos) {
            return {'-', name};
        }
        if (const auto list = syntax.parts.find(name); list != syntax.parts.end()) {
            const std::string values = "," + word.substr(at + 1);
            for (const std::string_view part : list->second) {
                if (values.find("," + std::string(part) + "=") != std::string::npos) {
                    return std::string{'-', name} + std::string(part);
                }
            }
        }
        if (syntax.flags.find(name) == std::string::npos) {
            return "";  // the rest is its value
        }
    }
    return "";
}

/// The own option that the word means; empty: none.
std::string own_option(const Syntax& syntax, const std::string& word) {
    if (!word.starts_with("--")) {
        return own_short(syntax, word);
    }
    const std::string name = word.substr(0, word.find('='));
    const bool is_exclude = name == "--exclude" && word.size() > name.size();  // is joined
    const auto own = std::ranges::find_if(
        syntax.names, [&](std::string_view one) { return one.starts_with(name); });
    return own == syntax.names.end() || is_exclude ? "" : std::string(*own);
}

}  // namespace

std::string problem_of_option(const std::string& engine, const std::string& option) {
    const auto syntax = syntaxes().find(engine);
    if (syntax == syntaxes().end()) {
        return "options after -- are for slurm and pbs, not for " + engine;
    }
    if (!option.starts_with('-') || option == "-" || option == "--") {
        return "'" + option + "' is no option; write a value in the same word, as in " +
               (engine == "pbs" ? "-lplace=excl" : "--qos=high");
    }
    const std::string own = own_option(syntax->second, option);
    return own.empty() ? ""
                       : "'" + option + "' is refused, since carom itself decides about '" + own +
                             "' of " + syntax->second.program;
}

}  // namespace carom::farm
