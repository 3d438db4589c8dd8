#include "pipeline/config/parse_moment.h"

#include <optional>

#include "pipeline/config/config_files.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/sections/occurrences.h"

namespace carom::pipeline {

using namespace config;

std::variant<sim::EventTime, std::string> parse_moment(const std::string& text) {
    SourceSet sources;
    ProblemList problems(sources);
    const int source = sources.add({"the moment", "", text});
    const std::optional<Node> node = parse_yaml(sources, source, problems);
    std::optional<sim::EventTime> moment;
    if (node) {
        const ConfigFolders folders;
        Reader reader(sources, folders, problems);
        reader.set_root_place(node->place);
        const Reader::Scope scope(reader, std::size_t{0}, node->place);
        reader.set_label("the moment");
        moment = config::moment().read(reader, *node);
    }
    const std::vector<Problem> found = problems.take();
    for (const Problem& problem : found) {
        if (problem.severity == Severity::error) {
            return problem.message;
        }
    }
    return moment ? std::variant<sim::EventTime, std::string>(*moment)
                  : std::variant<sim::EventTime, std::string>("it is empty");
}

}  // namespace carom::pipeline
