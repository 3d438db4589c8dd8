// Collects what is wrong while a shot is read.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

class ProblemList {
  public:
    explicit ProblemList(const SourceSet& sources) : sources_(&sources) {}

    void error(const Place& place, std::string message, std::string key_path = {});
    void warning(const Place& place, std::string message, std::string key_path = {});

    [[nodiscard]] bool has_error() const { return error_count_ > 0; }

    /// In the order of the texts and their lines, each once. Past 100 of them one closing problem
    /// says how many more there are.
    [[nodiscard]] std::vector<Problem> take();

  private:
    struct Entry {
        Place place;
        Severity severity = Severity::error;
        std::string message;
        std::string key_path;
    };
    void add(Entry entry);

    const SourceSet* sources_;
    std::vector<Entry> entries_;
    int error_count_ = 0;
    int hidden_count_ = 0;
};

}  // namespace carom::pipeline::config
