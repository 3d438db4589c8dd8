// The text of a shot for another folder, in which what it includes is still found.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/config_files.h"

namespace carom::studio {

struct ShotCopy {
    struct File {
        std::string from;  // absolute path
        std::string path;  // to which it has to be copied
        std::string text;  // of a YAML file; empty: the bytes of `from`
    };
    std::string text;
    std::vector<File> files;  // that do not exist yet
};

/// `text`: a shot of the folder `from`, which gets the folder `to`. Files of carom's configurations
/// keep their names where those are found. Files below `root` get paths relative to `to`. Others
/// have to be copied beside the shot: those get a free name. Only files below `root` are copied,
/// or, if the shot is not there, those of the folder `from`. A first line that names a schema is
/// replaced. A text that is not valid YAML is not changed. Nothing is written.
[[nodiscard]] ShotCopy copy_shot(const std::string& text, const std::string& from,
                                 const std::string& to, const std::string& root,
                                 const pipeline::config::OpenTexts* texts = nullptr);

/// Writes the files of the copy, but not the shot. Throws Error.
void write_files(const ShotCopy& copy);

}  // namespace carom::studio
