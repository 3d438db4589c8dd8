// Fuzzes the parsers of frame ranges, chunks and cache sizes. Any text must give an Error or a
// valid value.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "pipeline/job/frame_range.h"
#include "pipeline/store/cache_maintenance.h"

namespace {

using namespace carom::pipeline;

void require(bool condition, const char* what) {
    if (condition) {
        return;
    }
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

template <class Parse>
void attempt(Parse parse) {
    try {
        parse();
    } catch (const carom::Error&) {
    }
}

void use_range(std::string_view text) {
    const FrameRange range = parse_frame_range(text);
    const auto frames = range.frames(1000);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        require(frames[i] >= 0 && frames[i] < 1000 && (i == 0 || frames[i] > frames[i - 1]),
                "frames that are not ascending");
    }
    if (!frames.empty()) {
        require(parse_frame_range(frames_text(frames)).frames(1000) == frames,
                "frames that read back differently");
    }
}

void use_chunk(std::string_view text) {
    const FrameChunk chunk = parse_frame_chunk(text);
    require(chunk.number >= 1 && chunk.number <= chunk.of, "a chunk beyond the last");
    require(chunk.part_of({1, 2, 3}).size() <= 3, "a part larger than the whole");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    attempt([&] { use_range(text); });
    attempt([&] { use_chunk(text); });
    attempt([&] { (void)size_text(parse_cache_size(text)); });
    return 0;
}
