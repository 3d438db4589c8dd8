// A problem of a file with its place, formatted like a compiler's message.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.h"

namespace carom::pipeline {

using carom::Severity;

/// A place in a text file; lines and columns count from 1, 0 means unknown.
struct SourcePlace {
    std::string file;
    int line = 0;
    int column = 0;
    int length = 1;  // number of underlined characters, >= 1
};

struct Problem {
    Severity severity = Severity::error;
    SourcePlace place;
    std::string key_path;  // "cameras[0].position", may be empty
    std::string message;   // "unknown key 'postion' in camera 'opening' (did you mean 'position'?)"
    std::string source_line;  // the line at `place`, may be empty
    /// The place that includes that file, the place that includes the including file, and so on;
    /// empty for the shot itself.
    std::vector<SourcePlace> included_by{};
    std::string suggestion{};  // what the message says was probably meant ("position"), or empty
};

/// The message as text, with the source line and a caret:
///   shot.yaml:14:9: error: unknown key ...
///      14 |         postion: [0, -2, 1]
///         |         ^~~~~~~
/// and, for each file of the chain of includes,
///         = included by other.yaml:3:10
[[nodiscard]] std::string format(const Problem& problem);

/// The same with another word for its severity than "error:" or "warning:", such as a coloured one.
[[nodiscard]] std::string format(const Problem& problem, const std::string& severity_word);

[[nodiscard]] bool has_errors(const std::vector<Problem>& problems);

}  // namespace carom::pipeline
