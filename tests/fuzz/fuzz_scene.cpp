// Fuzzes the import of scenes. Any text must give problems that can be printed, or YAML with valid
// syntax.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "pipeline/config/load_shot.h"
#include "pipeline/import/import_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace carom::pipeline;
    const ImportResult result =
        import_scene(std::string(data, data + size), "fuzz.txt", "/nowhere", "/nowhere");
    std::string shown;
    for (const Problem& problem : result.problems) {
        shown += format(problem);
    }
    if (result.yaml.empty() != has_errors(result.problems)) {
        std::fprintf(stderr, "both YAML and errors, or neither\n%s", shown.c_str());
        std::abort();
    }
    if (!result.yaml.empty()) {
        for (const Problem& problem : load_shot_text(result.yaml, "/nowhere/shot.yaml").problems) {
            // Values may be outside the range that a shot allows, but unknown keys and invalid
            // syntax are errors of the import.
            const bool is_import_error =
                problem.message.find("unknown key") != std::string::npos ||
                problem.message.find("cannot be the name") != std::string::npos ||
                problem.message.starts_with("YAML syntax");
            if (is_import_error) {
                std::fprintf(stderr, "%s\n%s", result.yaml.c_str(), format(problem).c_str());
                std::abort();
            }
        }
    }
    return 0;
}
