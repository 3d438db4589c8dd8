#include "pipeline/video/picture_writer.h"

#include "pipeline/video/pending_file.h"
#include "pipeline/video/picture_kind.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {

namespace {

/// An error about the temporary file is one about the target.
std::string with_target(std::string message, const PendingFile& file) {
    const std::size_t at = message.find(file.temporary_path());
    if (at != std::string::npos) {
        message.replace(at, file.temporary_path().size(), file.target());
    }
    return message;
}

}  // namespace

void write_picture(const render::Film& film, const DisplayView& view, const std::string& path,
                   const render::ImageMetadata& metadata, const render::PictureText& text) {
    PendingFile file(path);
    try {
        if (is_linear_picture(path)) {
            // OpenImageIO writes the time of writing otherwise: the same frame, other bytes.
            render::ImageMetadata dated = metadata;
            dated.emplace("DateTime", "1970:01:01 00:00:00");
            render::write_exr(film, file.temporary_path(), dated);
        } else {
            std::vector<std::uint8_t> display = view.to_8(film);
            render::draw_text(text, display, film.width, film.height);
            render::write_display_image(display, film.width, film.height, file.temporary_path(),
                                        metadata);
        }
    } catch (const Error& error) {
        throw Error(with_target(error.what(), file));
    }
    file.commit();
}

}  // namespace carom::pipeline
