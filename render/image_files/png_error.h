// Errors of libpng, which it reports by calling a function that must not return.
#pragma once

#include <array>
#include <cstdio>

#include <png.h>

namespace carom::render {

struct PngError {
    std::array<char, 200> text{"libpng cannot be started"};
};

/// For png_create_read_struct and png_create_write_struct, with a PngError as their pointer.
[[noreturn]] inline void stop_with_message(png_structp png, png_const_charp message) {
    auto* error = static_cast<PngError*>(png_get_error_ptr(png));
    std::snprintf(error->text.data(), error->text.size(), "%s", message);
    png_longjmp(png, 1);
}

/// A warning is about what carom does not use, such as a colour profile.
inline void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

}  // namespace carom::render
