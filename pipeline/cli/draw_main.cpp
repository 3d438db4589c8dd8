// The program libexec/carom/carom-draw WIDTH, which converts SVG on standard input to PNG on
// standard output. bin/carom runs it, so that it does not load librsvg itself.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "core/error.h"
#include "pipeline/drawing/svg_picture.h"

namespace {

std::vector<std::byte> read_all(std::FILE* file) {
    std::vector<std::byte> bytes;
    std::vector<std::byte> block(1 << 16);
    for (std::size_t size = 0; (size = std::fread(block.data(), 1, block.size(), file)) > 0;) {
        bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(size));
    }
    return bytes;
}

}  // namespace

int main(int argument_count, char** arguments) {
    try {
        if (argument_count != 2) {
            throw carom::Error("this program only draws for carom; run carom instead");
        }
        const std::vector<std::byte> png =
            carom::pipeline::svg_to_png(read_all(stdin), std::stoi(arguments[1]));
        const bool is_written = std::fwrite(png.data(), 1, png.size(), stdout) == png.size();
        return is_written && std::fflush(stdout) == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "carom: error: %s\n", error.what());
        return 1;
    }
}
