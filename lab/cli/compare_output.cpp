#include "lab/cli/compare_output.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <sstream>

#include <fmt/core.h>

#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"

namespace carom::cli {

void check_outputs(const CompareCommand& command) {
    check_output_folder(command.output);
    check_output_folder(command.csv);
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
}

void write_texts(const CompareCommand& command, const Texts& texts) {
    write_text_output(command.output.empty() ? "-" : command.output, texts.text);
    if (!command.csv.empty()) {
        write_text_output(command.csv, texts.csv);
    }
    if (!command.plot.empty()) {
        write_drawing({command.plot, command.drawing.width}, texts.plot);
    }
}

void stop_unless(bool is_whole) {
    if (!is_whole) {
        throw Stopped();
    }
}

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

std::vector<double> numbers_of(const std::string& text, const ListRule& rule) {
    std::vector<double> numbers;
    std::istringstream list(text + ",");
    for (std::string word; std::getline(list, word, ',');) {
        double number = 0;
        const char* const end = word.data() + word.size();
        const auto read = std::from_chars(word.data(), end, number);
        const bool is_number = read.ec == std::errc() && read.ptr == end;
        if (!is_number || !(number >= rule.lowest && number <= rule.highest) ||
            (rule.is_whole && number != std::floor(number))) {
            throw InputError(fmt::format("{} '{}' is not a list of {}numbers from {} to {}",
                                         rule.option, text, rule.is_whole ? "whole " : "",
                                         rule.lowest, rule.highest));
        }
        if (std::ranges::find(numbers, number) != numbers.end()) {
            throw InputError(fmt::format("{} names {} twice", rule.option, number));
        }
        numbers.push_back(number);
    }
    return numbers;
}

}  // namespace carom::cli
