#include "pipeline/video/picture_writer.h"

#include "core/error.h"
#include "pipeline/video/pending_file.h"
#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {

namespace {

/// The message with the path of the temporary file replaced by that of the target.
std::string with_target(std::string message, const PendingFile& file) {
    const std::size_t at = message.find(file.temporary_path());
    if (at != std::string::npos) {
        message.replace(at, file.temporary_path().size(), file.target());
    }
    return message;
}

/// Calls `write` with a temporary path, then renames the file.
template <class Write>
void write_atomically(const std::string& path, const Write& write) {
    PendingFile file(path);
    try {
        write(file.temporary_path());
    } catch (const Error& error) {
        throw Error(with_target(error.what(), file));
    }
    file.commit();
}

}  // namespace

void write_picture(const render::Film& film, const DisplayView& view, const ViewedFrame& frame,
                   const std::string& path, const render::ImageMetadata& metadata,
                   const DrawOver& draw_over,
                   const std::optional<render::ExrStandardAttributes>& standard) {
    if (is_linear_picture(path)) {
        write_atomically(path, [&](const std::string& temporary) {
            render::write_exr(film, temporary, metadata, standard);
        });
        return;
    }
    std::vector<std::uint8_t> display = view.to_8(film, frame);
    if (draw_over) {
        draw_over(display, film.width, film.height);
    }
    write_display_picture(display, film.width, film.height, path, metadata);
}

void write_display_picture(const std::vector<std::uint8_t>& rgb, int width, int height,
                           const std::string& path, const render::ImageMetadata& metadata) {
    write_atomically(path, [&](const std::string& temporary) {
        render::write_display_image(rgb, width, height, temporary, metadata);
    });
}

}  // namespace carom::pipeline
