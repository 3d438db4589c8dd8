// What can be made of a shot beside a film, and how the command line is asked for it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"
#include "pipeline/studio/program_options.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// What a page asked for, and the files that it showed.
struct DocumentRequest {
    Make make;
    std::string shot;  // the path of its file
    std::string root;  // the folder below which files are written
};

struct DocumentKind {
    std::string_view what;       // of Make
    std::string_view command;    // of carom
    std::string_view option;     // before the file's name
    std::string_view extension;  // if the name has none
    bool is_rendered = false;    // a picture, which the program makes also if it is only looked at
};

/// The kind that is asked for. Throws Error if there is none, or if the request is not a valid one.
[[nodiscard]] const DocumentKind& kind_of(const Make& request);

/// The words after "carom" that make the file.
[[nodiscard]] std::vector<std::string> document_words(const DocumentKind& kind,
                                                      const DocumentRequest& request,
                                                      const ProgramOptions& options,
                                                      const std::string& file);

/// A drawing as SVG, or the report as a text, to look at. `kind` is not rendered, and no export.
[[nodiscard]] std::string draw_document(const DocumentKind& kind, const pipeline::Shot& shot,
                                        const sim::Timeline& timeline);

}  // namespace carom::studio
