// Fuzzes the import of tables. Any table must give problems that can be printed, or the motion of
// an object in a valid shot.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/text.h"
#include "pipeline/import/import_track.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace carom::pipeline;
    const std::string text(data, data + size);
    if (config::find_invalid_utf8(text) != std::string::npos) {
        return 0;  // rejected before it is parsed
    }
    ImportTrackOptions options;
    options.name = "thing";
    const ImportTrackResult result = import_track(text, "fuzz.csv", options);
    std::string shown;
    for (const Problem& problem : result.problems) {
        shown += format(problem);
    }
    if (result.yaml.empty() != has_errors(result.problems)) {
        std::fprintf(stderr, "both YAML and errors, or neither\n%s", shown.c_str());
        std::abort();
    }
    if (!result.yaml.empty()) {
        for (const Problem& problem :
             load_shot_text(result.yaml + "    sphere: 1\n", "/nowhere/shot.yaml").problems) {
            if (problem.severity == Severity::error) {
                std::fprintf(stderr, "%s\n%s", result.yaml.c_str(), format(problem).c_str());
                std::abort();
            }
        }
    }
    return 0;
}
