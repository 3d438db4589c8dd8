// Uses a frame store in a separate process, which a test may kill:
//   write FOLDER        writes frames without end
//   claim FOLDER FILE   claims frame 2 for a moment, then frame 1, creates FILE and sleeps
//   repeat FOLDER DIR   claims frame 1 300 times and creates and removes DIR each time; fails if
//                       another process has created DIR meanwhile
//   take FOLDER         reads frame 1, or claims and writes it if it is not there
#include <cstdint>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/pipeline/store/sample_frames.h"

namespace {

using carom::pipeline::Claim;
using carom::pipeline::FrameStore;
using carom::testing::make_key;

void write_without_end(const FrameStore& store) {
    for (std::uint64_t number = 0;; ++number) {
        store.write(make_key(number % 8), carom::testing::make_film(static_cast<int>(number % 8)),
                    {});
    }
}

int claim_and_sleep(const FrameStore& store, const char* file) {
    (void)store.claim(make_key(2));
    const std::optional<Claim> claim = store.claim(make_key(1));
    if (!claim || ::close(::open(file, O_CREAT | O_WRONLY, 0600)) != 0) {
        return 1;
    }
    ::pause();
    return 0;
}

int claim_repeatedly(const FrameStore& store, const char* folder) {
    for (int granted = 0; granted < 300;) {
        const std::optional<Claim> claim = store.claim(make_key(1));
        if (!claim) {
            std::this_thread::yield();
            continue;
        }
        ++granted;
        if (::mkdir(folder, 0700) != 0 || ::rmdir(folder) != 0) {
            return 1;
        }
    }
    return 0;
}

int take(const FrameStore& store) {
    if (store.read(make_key(1))) {
        return 0;
    }
    std::optional<Claim> claim = store.claim(make_key(1));
    if (!claim || store.contains(make_key(1))) {
        return 1;
    }
    store.write(make_key(1), carom::testing::make_film(1), {});
    return store.read(make_key(1)) ? 0 : 1;
}

}  // namespace

int main(int, char** arguments) {
    const std::string_view action = arguments[1];
    const FrameStore store(arguments[2]);
    if (action == "write") {
        write_without_end(store);
    }
    if (action == "take") {
        return take(store);
    }
    return action == "claim" ? claim_and_sleep(store, arguments[3])
                             : claim_repeatedly(store, arguments[3]);
}
