#include "pipeline/studio/shot_copy.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/schema_line.h"
#include "pipeline/config/text.h"
#include "pipeline/studio/paths.h"

namespace carom::studio {

namespace fs = std::filesystem;
namespace config = pipeline::config;

namespace {

constexpr std::size_t kMostFiles = 64;          // that are copied with a shot
constexpr std::size_t kMostBytes = 64U << 20U;  // of one of them
constexpr int kMostNames = 1000;                // that are tried

std::string read_bytes(const std::string& path) {
    std::string text;
    if (!config::read_text_file(path, kMostBytes, text)) {
        throw Error("the file " + config::quote(path) + " " + text);
    }
    return text;
}

/// Copies a shot and, one after the other, the files that it needs.
class Copier {
  public:
    Copier(std::string from, std::string to, std::string root, const config::OpenTexts* texts)
        : from_(std::move(from)),
          to_(std::move(to)),
          root_(std::move(root)),
          folders_(config::standard_config_folders()) {
        folders_.texts = texts;
        // A shot of carom's own, or one that was opened elsewhere, uses what is in its own folder.
        folders_.root = from_ == root_ || is_below(from_, root_) ? root_ : from_;
    }

    [[nodiscard]] ShotCopy copy(const std::string& text) {
        ShotCopy result;
        result.text = rewritten(text, from_, to_);
        result.files = std::move(files_);
        return result;
    }

  private:
    struct Edit {
        std::size_t length = 0;
        std::string text;
    };
    using Edits = std::map<std::size_t, Edit>;  // by their offsets; an alias is visited twice

    std::string rewritten(const std::string& text, const std::string& from, const std::string& to) {
        config::SourceSet sources;
        sources.add({"shot", from, text});
        config::ProblemList problems(sources);
        const std::optional<config::Node> root = config::parse_yaml(sources, 0, problems);
        if (!root) {
            return text;
        }
        Edits edits;
        visit(*root, sources, from, to, edits);
        std::string result = text;
        for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
            result.replace(edit->first, edit->second.length, edit->second.text);
        }
        return config::has_schema_line(result) && from != to
                   ? config::with_schema_line(std::move(result), to)
                   : result;
    }

    void visit(const config::Node& node, const config::SourceSet& sources, const std::string& from,
               const std::string& to, Edits& edits) {
        if (node.is_scalar() && node.text.find('.') != std::string::npos) {
            add_edit(node, sources, from, to, edits);
        }
        for (const config::Node& item : node.items) {
            visit(item, sources, from, to, edits);
        }
        for (const config::Entry& entry : node.entries) {
            visit(entry.value, sources, from, to, edits);
        }
    }

    void add_edit(const config::Node& node, const config::SourceSet& sources,
                  const std::string& from, const std::string& to, Edits& edits) {
        const std::string file = config::find_config_file(node.text, from, folders_).path;
        if (file.empty() || config::find_config_file(node.text, to, folders_).path == file) {
            return;
        }
        const std::string& text = sources.at(0).text;
        std::size_t at = offset_of(node.place, text, sources);
        at += at < text.size() && (text[at] == '"' || text[at] == '\'') ? 1 : 0;
        if (text.compare(at, node.text.size(), node.text) == 0) {
            edits[at] = {node.text.size(), name_for(file, from, to)};
        }
    }

    /// The byte of a place, whose column counts characters.
    static std::size_t offset_of(const config::Place& place, const std::string& text,
                                 const config::SourceSet& sources) {
        std::size_t at = sources.offset_of(0, place.line - 1, 0);
        for (int column = 1; column < place.column && at < text.size(); ++column) {
            ++at;
            while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) {
                ++at;
            }
        }
        return at;
    }

    /// How a shot in the folder `to` names the file.
    std::string name_for(const std::string& file, const std::string& from, const std::string& to) {
        for (const std::string& folder : folders_.folders) {
            if (is_below(file, whole_path(folder))) {
                return fs::path(file).lexically_relative(whole_path(folder)).string();
            }
        }
        if (is_below(file, root_)) {
            return fs::path(file).lexically_relative(to).string();
        }
        return fs::path(copied(file, from, to)).lexically_relative(to).string();
    }

    /// The path of the copy.
    std::string copied(const std::string& file, const std::string& from, const std::string& to) {
        const auto known = copies_.find(file);
        if (known != copies_.end()) {
            return known->second;
        }
        if (copies_.size() >= kMostFiles) {
            throw Error("this shot consists of more than 64 files, which are not copied with it");
        }
        const fs::path inner = fs::path(file).lexically_relative(from);
        const bool is_beside = !inner.empty() && *inner.begin() != "..";
        fs::path path = fs::path(to) / (is_beside ? inner : fs::path(file).filename());
        copies_[file] = path.string();
        const bool is_yaml = path.extension() == ".yaml";
        const std::string bytes = read_bytes(file);
        const std::string text = is_yaml ? rewritten(bytes, fs::path(file).parent_path().string(),
                                                     path.parent_path().string())
                                         : "";
        const std::string& wanted = is_yaml ? text : bytes;
        const fs::path stem = path.parent_path() / path.stem();
        for (int i = 2; is_there(path); ++i) {
            if (read_bytes(path.string()) == wanted) {
                return copies_[file] = path.string();
            }
            if (i > kMostNames) {
                throw Error("there is no free name for a copy of " + config::quote(file));
            }
            path = stem.string() + "_" + std::to_string(i) + path.extension().string();
        }
        const std::string place = whole_path(path);  // a folder may be a link
        if (!is_below(place, root_) && !is_below(place, to_)) {
            throw Error("a copy of " + config::quote(file) + " would be written to " +
                        config::quote(place) + ", outside " + config::quote(root_));
        }
        files_.push_back({file, path.string(), text});
        return copies_[file] = path.string();
    }

    std::string from_;
    std::string to_;
    std::string root_;
    config::ConfigFolders folders_;
    std::map<std::string, std::string> copies_;  // by the files' paths
    std::vector<ShotCopy::File> files_;
};

}  // namespace

ShotCopy copy_shot(const std::string& text, const std::string& from, const std::string& to,
                   const std::string& root, const config::OpenTexts* texts) {
    return Copier(whole_path(from), whole_path(to), whole_path(root), texts).copy(text);
}

void write_files(const ShotCopy& copy) {
    for (const ShotCopy::File& file : copy.files) {
        std::error_code code;
        fs::create_directories(fs::path(file.path).parent_path(), code);
        const std::string bytes = file.text.empty() ? read_bytes(file.from) : file.text;
        write_file_atomically(file.path, std::as_bytes(std::span(bytes)));
    }
}

}  // namespace carom::studio
