#include "pipeline/studio/workspace.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/hash.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/text.h"
#include "pipeline/studio/value_places.h"

namespace carom::studio {

namespace fs = std::filesystem;
using pipeline::config::quote;

namespace {

std::string hash_text(const std::string& text) {
    return hash_bytes(std::as_bytes(std::span(text))).to_string();
}

std::string canonical(const std::string& path) {
    std::error_code code;
    const fs::path result = fs::weakly_canonical(path, code);
    return code ? path : result.string();
}

}  // namespace

Workspace::Workspace(const std::string& shot, const std::string& root)
    : shot_(canonical(shot)),
      root_(canonical(root.empty() ? fs::path(shot_).parent_path().string() : root)),
      texts_(std::make_shared<const pipeline::config::OpenTexts>()) {
    std::string text;
    if (!pipeline::config::read_text_file(shot_, pipeline::config::YamlLimits{}.bytes, text)) {
        throw Error("the file " + quote(shot) + " " + text);
    }
    disk_[shot_] = read(shot_);
    files_.push_back({shot_, fs::path(shot_).filename().string()});
}

Workspace::DiskFile Workspace::read(const std::string& path) {
    std::string text;
    if (!pipeline::config::read_text_file(path, pipeline::config::YamlLimits{}.bytes, text)) {
        return {};
    }
    std::string hash = hash_text(text);
    return {std::move(text), std::move(hash)};
}

bool Workspace::set_files(const std::vector<pipeline::ReadFile>& files) {
    if (files.empty() || files == files_) {
        return false;
    }
    const bool is_other = !std::ranges::equal(files, files_, {}, &pipeline::ReadFile::path,
                                              &pipeline::ReadFile::path);
    files_ = files;
    for (const pipeline::ReadFile& file : files_) {
        if (!disk_.contains(file.path)) {
            disk_[file.path] = read(file.path);
        }
    }
    return is_other;
}

Files Workspace::files() const {
    Files message;
    message.v = version_;
    for (const pipeline::ReadFile& file : files_) {
        const auto known = disk_.find(file.path);
        const DiskFile disk = known == disk_.end() ? DiskFile{} : known->second;
        const auto open = texts_->find(file.path);
        OpenFile entry;
        entry.file = file.path;
        const fs::path name = fs::path(file.path).lexically_relative(fs::path(shot_).parent_path());
        entry.name =
            is_below(file.path, root_) ? name.string() : fs::path(file.path).filename().string();
        entry.text = open == texts_->end() ? disk.text : open->second;
        entry.hash = disk.hash;
        entry.writable = is_writable(file.path, root_);
        entry.changed = entry.text != disk.text;
        message.files.push_back(std::move(entry));
    }
    return message;
}

bool Workspace::is_known(const std::string& file) const {
    return std::ranges::find(files_, file, &pipeline::ReadFile::path) != files_.end();
}

void Workspace::require_writable(const std::string& file) const {
    if (!is_known(file)) {
        throw Error(quote(file) + " is not a file of this shot");
    }
    if (!is_writable(file, root_)) {
        throw Error(quote(file) + " cannot be changed, because it is not below " + quote(root_) +
                    " or belongs to carom");
    }
}

std::int64_t Workspace::next_version(std::int64_t v) {
    version_ = std::max(version_ + 1, v);
    return version_;
}

void Workspace::change_text(const std::string& file, const std::optional<std::string>& text) {
    auto texts = std::make_shared<pipeline::config::OpenTexts>(*texts_);
    if (text) {
        (*texts)[file] = *text;
    } else {
        texts->erase(file);
    }
    texts_ = std::move(texts);
}

std::int64_t Workspace::set_text(std::int64_t v, const std::string& file, const std::string& text) {
    require_writable(file);
    change_text(file, text);
    return next_version(v);
}

std::int64_t Workspace::revert(std::int64_t v, const std::string& file) {
    require_writable(file);
    change_text(file, std::nullopt);
    disk_[file] = read(file);
    return next_version(v);
}

std::variant<Saved, DiskChanged> Workspace::save(const Save& request) {
    const bool is_new = !is_known(request.file);
    const fs::path path(request.file);
    if (is_new && (!path.is_absolute() || canonical(request.file) != request.file ||
                   !is_writable(request.file, root_) || path.extension() != ".yaml")) {
        throw Error(quote(request.file) +
                    " cannot be written: new files have to be .yaml files below " + quote(root_));
    }
    if (!is_new) {
        require_writable(request.file);
    }
    const DiskFile disk = read(request.file);
    if (disk.hash != request.base_hash && !request.force) {
        disk_[request.file] = disk;
        return DiskChanged{request.file, disk.text, disk.hash, true};
    }
    write_file_atomically(request.file, std::as_bytes(std::span(request.text)));
    disk_[request.file] = {request.text, hash_text(request.text)};
    const auto open = texts_->find(request.file);
    if (open != texts_->end() && open->second == request.text) {
        change_text(request.file, std::nullopt);
    }
    return Saved{request.file, disk_[request.file].hash};
}

Workspace::DiskChanges Workspace::look_at_disk() {
    DiskChanges changes;
    for (const pipeline::ReadFile& file : files_) {
        DiskFile now = read(file.path);
        DiskFile& known = disk_[file.path];
        if (now.hash == known.hash || now.hash.empty()) {
            continue;  // an editor may be about to replace it
        }
        known = std::move(now);
        const auto open = texts_->find(file.path);
        if (open == texts_->end()) {
            changes.reloaded.push_back({next_version(0), file.path, known.text});
        } else if (open->second == known.text) {
            change_text(file.path, std::nullopt);
        } else {
            changes.conflicting.push_back({file.path, known.text, known.hash, false});
        }
    }
    return changes;
}

}  // namespace carom::studio
