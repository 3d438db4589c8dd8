// Collects the problems of a shot while it is read.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/message.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

class ProblemList {
  public:
    explicit ProblemList(const SourceSet& sources) : sources_(&sources) {}

    void error(const Place& place, Message message, std::string key_path = {});
    void warning(const Place& place, Message message, std::string key_path = {});

    [[nodiscard]] bool has_error() const { return error_count_ > 0; }

    /// The problems in the order of the texts and their lines, without duplicates. After 100 of
    /// them, one last problem has the number of the others.
    [[nodiscard]] std::vector<Problem> take();

  private:
    struct Entry {
        Place place;
        Severity severity = Severity::error;
        Message message;
        std::string key_path;
    };
    void add(Entry entry);

    const SourceSet* sources_;
    std::vector<Entry> entries_;
    int error_count_ = 0;
    int hidden_count_ = 0;
};

}  // namespace carom::pipeline::config
