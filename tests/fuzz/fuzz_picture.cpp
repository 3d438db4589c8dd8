// Fuzzes the readers of PNG and Radiance files. Any bytes must give an Error, or as many values as
// the picture has.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "core/error.h"
#include "render/image_files/png_file.h"
#include "render/image_files/radiance_file.h"

namespace {

carom::render::RawPicture decode(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return carom::render::is_png(text) ? carom::render::decode_png(bytes, "fuzzed")
                                       : carom::render::decode_radiance(bytes, "fuzzed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto picture = decode(std::as_bytes(std::span(data, size)));
        if (std::visit([](const auto& values) { return values.size(); }, picture.values) !=
            picture.value_count()) {
            std::fputs("the number of values does not fit the size\n", stderr);
            std::abort();
        }
    } catch (const carom::Error&) {
    }
    return 0;
}
