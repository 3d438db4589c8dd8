// The only symbol that carom-formats.so exports.
#include "render/image_files/module/format_functions.h"

using carom::render::FormatModule;

extern "C" __attribute__((visibility("default"))) const FormatModule* carom_format_module() {
    namespace formats = carom::render::formats;
    static const FormatModule functions{formats::read, formats::read_size, formats::encode,
                                        formats::make_transform};
    return &functions;
}
