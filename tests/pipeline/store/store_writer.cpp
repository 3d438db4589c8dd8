// Writes frames into the store FOLDER for ever: what a test kills.
#include <cstdint>

#include "tests/pipeline/store/sample_frames.h"

int main(int, char** arguments) {
    const carom::pipeline::FrameStore store(arguments[1]);
    for (std::uint64_t number = 0;; ++number) {
        store.write(carom::testing::make_key(number % 8),
                    carom::testing::make_film(static_cast<int>(number % 8)), {});
    }
}
