#include "pipeline/check/file_check.h"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
#include "render/geometry/mesh_file.h"
#include "render/image_files/picture_light.h"
#include "render/image_files/read_picture.h"
#include "render/letters/font_file.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

/// The sizes of the files, by their paths.
using Sizes = std::map<std::string, std::uintmax_t>;

Sizes sizes_of(std::span<const NamedFile> files) {
    Sizes sizes;
    for (const NamedFile& file : files) {
        std::error_code failure;
        const std::uintmax_t size = fs::file_size(file.path, failure);
        sizes[file.path] = failure ? 0 : size;
    }
    return sizes;
}

/// The files that are read whole: the smallest, up to so many bytes together.
std::set<std::string> read_whole(const Sizes& sizes, std::uintmax_t most_bytes) {
    std::vector<std::pair<std::uintmax_t, std::string>> by_size;
    for (const auto& [path, size] : sizes) {
        by_size.emplace_back(size, path);
    }
    std::ranges::sort(by_size);
    std::set<std::string> whole;
    std::uintmax_t sum = 0;
    for (const auto& [size, path] : by_size) {
        if (size > most_bytes - sum) {
            break;
        }
        sum += size;
        whole.insert(path);
    }
    return whole;
}

/// "3 of 8192 pixels"
std::string share(std::size_t count, std::size_t all) {
    return fmt::format("{} of {}", count, counted(all, "pixel"));
}

Problem problem_at(const NamedFile& file, Severity severity, const std::string& sentence) {
    Problem problem = file.where;
    problem.severity = severity;
    problem.message = sentence;
    return problem;
}

/// A picture of a material may be named once and used by many objects.
void add_once(Problem problem, std::vector<Problem>& problems) {
    const bool is_known = std::ranges::any_of(problems, [&](const Problem& other) {
        return other.message == problem.message && other.place.file == problem.place.file &&
               other.place.line == problem.place.line && other.place.column == problem.place.column;
    });
    if (!is_known) {
        problems.push_back(std::move(problem));
    }
}

}  // namespace

void FileChecker::examine_mesh(const std::string& path, bool is_whole, Finding& finding) {
    if (!is_whole) {
        return;  // what precedes the vertices says nothing about them
    }
    const render::MeshReading reading = render::read_mesh_file(path);
    for (const render::MeshRemark& problem : reading.problems) {
        finding.problems.push_back(render::text_of(path, problem));
    }
    for (const render::MeshRemark& warning : reading.warnings) {
        finding.warnings.push_back(render::text_of(path, warning));
    }
}

void FileChecker::examine_picture(const std::string& path, bool is_whole, Finding& finding) {
    if (!is_whole) {
        static_cast<void>(render::read_picture_size(path));
        return;
    }
    const render::RawPicture picture = render::read_picture(path);
    finding.pixels = picture.pixel_count();
    if (!picture.has_alpha() && !picture.is_floating_point) {
        return;  // all values are light
    }
    for (std::size_t i = 0; i < finding.pixels; ++i) {
        const render::PixelLight light = render::pixel_light(picture, i, true);
        finding.clamped += light.is_clamped ? 1 : 0;
        finding.transparent += light.alpha < 1 ? 1 : 0;
    }
}

FileChecker::Finding FileChecker::examine(const NamedFile& file, bool is_whole,
                                          const FileCheckOptions& options) {
    Finding finding;
    try {
        switch (file.kind) {
            case FileKind::mesh:
                examine_mesh(file.path, is_whole, finding);
                break;
            case FileKind::texture:
            case FileKind::normals:
            case FileKind::environment:
            case FileKind::annotation_picture:
                examine_picture(file.path, is_whole, finding);
                break;
            case FileKind::font:
                render::check_font_file(file.path);
                break;
            case FileKind::music:
                if (options.try_music) {
                    options.try_music(file.path);
                }
                break;
        }
    } catch (const Error& failure) {
        finding.problems.emplace_back(failure.what());
    }
    return finding;
}

const FileChecker::Finding& FileChecker::finding(const NamedFile& file, std::uintmax_t size,
                                                 bool is_whole, const FileCheckOptions& options) {
    std::error_code failure;
    const fs::file_time_type time = fs::last_write_time(file.path, failure);
    const Reading reading{file.path, file.kind, is_whole, size, time};
    const auto known = known_.find(reading);
    return known != known_.end()
               ? known->second
               : known_.emplace(reading, examine(file, is_whole, options)).first->second;
}

std::vector<std::string> FileChecker::warnings_of(const NamedFile& file, const Finding& found) {
    std::vector<std::string> sentences = found.warnings;
    if (found.clamped > 0) {
        sentences.push_back(fmt::format(
            "image '{}' has a negative, infinite or undefined value in {}; negative and undefined "
            "ones become 0, infinite ones {}",
            file.path, share(found.clamped, found.pixels), render::kBrightestPixel));
    }
    const std::string transparent = fmt::format("image '{}' is transparent in {}", file.path,
                                                share(found.transparent, found.pixels));
    if (found.transparent > 0 && file.kind == FileKind::environment) {
        sentences.push_back(transparent + ", where it is dark");
    }
    if (found.transparent > 0 && file.kind == FileKind::texture && !file.is_transparency_meant) {
        sentences.push_back(transparent +
                            ", where a light grey is seen; cut the surface out there, beside "
                            "'base', with 'opacity: {image: ...}' of the same file, or choose the "
                            "colour: 'image: {file: ..., background: 0.8}'");
    }
    return sentences;
}

FileReport FileChecker::check(std::span<const NamedFile> files, const FileCheckOptions& options) {
    const Sizes sizes = sizes_of(files);
    const std::set<std::string> whole = read_whole(sizes, options.most_bytes);
    FileReport report;
    for (const NamedFile& file : files) {
        const bool is_whole = whole.contains(file.path);
        const Finding& found = finding(file, sizes.at(file.path), is_whole, options);
        for (const std::string& problem : found.problems) {
            add_once(problem_at(file, Severity::error, problem), report.problems);
        }
        for (const std::string& warning : warnings_of(file, found)) {
            add_once(problem_at(file, Severity::warning, warning), report.problems);
        }
        const bool has_header = file.kind != FileKind::font && file.kind != FileKind::music;
        const bool is_listed = std::ranges::find(report.read_by_header, file.path,
                                                 &NamedFile::path) != report.read_by_header.end();
        if (!is_whole && has_header && !is_listed) {
            report.read_by_header.push_back(file);
        }
    }
    return report;
}

}  // namespace carom::pipeline
