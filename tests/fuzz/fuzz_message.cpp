// Fuzzes the texts of the studio's pages. Any text must be refused with a sentence, or give a
// message that is the same after it was written and read again.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "pipeline/studio/message_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace carom::studio;
    const std::string text(data, data + size);
    std::string written;
    try {
        written = to_json(read_page_message(text));
    } catch (const carom::Error& error) {
        if (std::string(error.what()).empty()) {
            std::abort();
        }
        return 0;
    }
    const std::string again = to_json(read_page_message(written));
    if (again != written) {
        std::fprintf(stderr, "%s\n%s\n", written.c_str(), again.c_str());
        std::abort();
    }
    return 0;
}
