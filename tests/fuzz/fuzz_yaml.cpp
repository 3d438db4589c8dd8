// Fuzzes the loader of shots. Any text must give a shot or a list of problems that can be printed,
// without a crash or a hang. The resolved text of a shot must load again.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "pipeline/config/load_shot.h"

namespace {

std::string all_problems(const carom::pipeline::LoadResult& result) {
    std::string text;
    for (const carom::pipeline::Problem& problem : result.problems) {
        text += format(problem);
    }
    return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    const carom::pipeline::LoadResult result =
        carom::pipeline::load_shot_text(text, "/nowhere/fuzz.yaml");
    const std::string problems = all_problems(result);
    if (result.shot.has_value() == has_errors(result.problems)) {
        std::fprintf(stderr, "a shot with errors, or neither\n%s", problems.c_str());
        std::abort();
    }
    if (result.shot) {
        const carom::pipeline::LoadResult again =
            carom::pipeline::load_shot_text(result.shot->resolved_text, "/nowhere/again.yaml");
        if (!again.shot || again.shot->resolved_text != result.shot->resolved_text) {
            std::fprintf(stderr, "the resolved text does not load again:\n%s%s",
                         result.shot->resolved_text.c_str(), all_problems(again).c_str());
            std::abort();
        }
    }
    return 0;
}
