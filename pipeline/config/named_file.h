// The files that a shot names besides the texts it consists of.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/config/problem.h"

namespace carom::pipeline {

/// What a file is used for, which decides what must be in it.
enum class FileKind : std::uint8_t {
    mesh,
    texture,             // a picture on a surface
    normals,             // a picture of the normals of a surface
    environment,         // a picture around the scene
    annotation_picture,  // a picture over the frames
    font,
    music,
};

struct NamedFile {
    FileKind kind = FileKind::mesh;
    std::string path;  // absolute
    Problem where;     // a problem at the value that names the file, without a message
    /// Whether the shot says what is seen where a texture is transparent.
    bool is_transparency_meant = false;
};

}  // namespace carom::pipeline
