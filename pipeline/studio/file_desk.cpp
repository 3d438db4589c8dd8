#include "pipeline/studio/file_desk.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/schema_line.h"
#include "pipeline/config/text.h"
#include "pipeline/import/import_scene.h"
#include "pipeline/studio/folder_list.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/shot_copy.h"
#include "pipeline/studio/shot_parts.h"

namespace carom::studio {

namespace fs = std::filesystem;
namespace config = pipeline::config;
using config::quote;

namespace {

std::string folder_of(const std::string& file) {
    return fs::path(file).parent_path().string();
}

/// The text of a file as the page has it, else as it is on disk. Throws Error.
std::string text_of(const std::string& file, const config::OpenTexts* texts) {
    config::ConfigFolders folders;
    folders.texts = texts;
    std::string text;
    if (!config::read_config_text(file, config::YamlLimits{}.bytes, folders, text)) {
        throw Error("the file " + quote(file) + " " + text);
    }
    return text;
}

void write_shot(const std::string& file, const ShotCopy& copy) {
    write_files(copy);
    write_file_atomically(file, std::as_bytes(std::span(copy.text)));
}

std::string sentence_of(const pipeline::Problem& problem) {
    const std::string place =
        problem.place.line > 0 ? "line " + std::to_string(problem.place.line) + ": " : "";
    return place + problem.message;
}

}  // namespace

FileDesk::FileDesk(const std::string& state_folder, Send send)
    : send_(std::move(send)),
      recent_(state_folder.empty() ? default_state_folder() : state_folder),
      page_(std::make_unique<StartPage>([this] { send_(0, start()); })) {}

Start FileDesk::start() {
    return page_->offer(recent_.list());
}

void FileDesk::opened(const std::string& file) {
    recent_.add(file);
    page_->rest();
}

void FileDesk::forget(const std::string& file) {
    recent_.remove(file);
}

std::optional<Still> FileDesk::find_still(std::string_view address) const {
    return page_->find(address);
}

std::variant<std::string, Exists> FileDesk::file_to_open(const Open& request,
                                                         const std::string& root) {
    if (request.from.empty() && request.text.empty()) {
        const std::string file = whole_path(fs::path(root) / request.file);
        const std::vector<std::string> recent = recent_.list();
        if (!is_below(file, root) && std::ranges::find(recent, file) == recent.end()) {
            throw Error(quote(request.file) + " is not below " + quote(root));
        }
        return file;
    }
    const std::string file = path_for_writing(request.file, root);
    if (!request.overwrite && is_there(file)) {
        return Exists{request.kName, file, name_below(file, root)};
    }
    ShotCopy copy{request.text, {}};
    if (request.text.empty()) {
        if (!page_->has(request.from)) {
            throw Error(quote(request.from) + " is neither a template nor an example");
        }
        copy = copy_shot(text_of(request.from, nullptr), folder_of(request.from), folder_of(file),
                         root);
    }
    copy.text = config::with_schema_line(std::move(copy.text), folder_of(file));
    write_shot(file, copy);
    return file;
}

std::variant<std::string, Exists> FileDesk::save_as(const SaveAs& request, const OpenShot& shot) {
    const std::string file = path_for_writing(request.file, shot.root);
    if (file == shot.file) {
        throw Error("this is the name of the open shot; save it instead");
    }
    if (!request.overwrite && is_there(file)) {
        return Exists{request.kName, file, name_below(file, shot.root)};
    }
    write_shot(file, copy_shot(text_of(shot.file, shot.texts.get()), folder_of(shot.file),
                               folder_of(file), shot.root, shot.texts.get()));
    return file;
}

template <class Request, class Work>
void FileDesk::do_later(std::uint64_t page, const Request& request, Work work) {
    const bool is_posted = errands_.post([this, page, request, work] {
        try {
            send_(page, work(request));
        } catch (const std::exception& error) {
            send_(page, Failed{Request::kName, 0, error.what()});
        }
    });
    if (!is_posted) {
        send_(page, Failed{Request::kName, 0, "too much was asked for at once; try again"});
    }
}

void FileDesk::answer(std::uint64_t page, const ListFolder& request, const OpenShot& shot) {
    do_later(page, request, [shot](const ListFolder& list) -> ServerMessage {
        const bool is_own = list.folder.empty() && !shot.file.empty();
        return list_folder(is_own ? folder_of(shot.file) : list.folder, shot.root);
    });
}

void FileDesk::answer(std::uint64_t page, const Import& request, const OpenShot& shot) {
    do_later(page, request, [shot](const Import& scene) -> ServerMessage {
        const std::string folder = shot.file.empty() ? shot.root : folder_of(shot.file);
        const pipeline::ImportResult result =
            pipeline::import_scene(scene.text, scene.name, folder, folder);
        Imported answer{scene.name, result.yaml, {}, result.notes};
        for (const pipeline::Problem& problem : result.problems) {
            answer.problems.push_back(sentence_of(problem));
        }
        return answer;
    });
}

namespace {

ShotText other_shot(const std::string& file, const std::string& text, const OpenShot& shot,
                    const StartPage& page) {
    if (!text.empty()) {
        return {text, shot.file.empty() ? shot.root : folder_of(shot.file), shot.root};
    }
    const std::string path = whole_path(fs::path(shot.root) / file);
    if (!is_below(path, shot.root) && !page.has(path)) {
        throw Error(quote(file) + " is not below " + quote(shot.root));
    }
    return {text_of(path, shot.texts.get()), folder_of(path),
            page.has(path) ? folder_of(path) : shot.root};
}

ShotText this_shot(const OpenShot& shot) {
    if (shot.file.empty()) {
        throw Error("no shot is open");
    }
    return {text_of(shot.file, shot.texts.get()), folder_of(shot.file), shot.root};
}

}  // namespace

void FileDesk::answer(std::uint64_t page, const ReadParts& request, const OpenShot& shot) {
    do_later(page, request, [this, shot](const ReadParts& ask) -> ServerMessage {
        return Parts{ask.file, read_parts(other_shot(ask.file, ask.text, shot, *page_),
                                          this_shot(shot), shot.texts.get())};
    });
}

void FileDesk::answer(std::uint64_t page, const AddParts& request, const OpenShot& shot) {
    do_later(page, request, [this, shot](const AddParts& ask) -> ServerMessage {
        return Additions{parts_to_add(other_shot(ask.file, ask.text, shot, *page_), this_shot(shot),
                                      ask.parts, shot.texts.get())};
    });
}

void FileDesk::later(std::function<void()> work) {
    errands_.post_always(std::move(work));
}

void FileDesk::end() {
    errands_.end();
    page_->rest();
}

}  // namespace carom::studio
