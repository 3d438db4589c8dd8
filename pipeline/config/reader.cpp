#include "pipeline/config/reader.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "core/text.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

Reader::Scope::Scope(Reader& reader, std::string key, Place key_place) : reader_(reader) {
    reader.steps_.push_back({std::move(key), 0, key_place, {}});
}

Reader::Scope::Scope(Reader& reader, std::size_t index, Place place) : reader_(reader) {
    reader.steps_.push_back({{}, index, place, {}});
}

std::string Reader::label() const {
    std::string text;
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
        if (!step->label.empty()) {
            return text.empty() ? step->label : text + " of " + step->label;
        }
        if (!step->key.empty()) {
            text += (text.empty() ? "'" : " of '") + step->key + "'";
        }
    }
    return text.empty() ? "the shot" : text;
}

std::string Reader::value_name() const {
    std::string text;
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
        if (!step->key.empty()) {
            return "'" + step->key + text + "'";
        }
        text.insert(0, fmt::format("[{}]", step->index));
    }
    return "the shot";
}

std::string Reader::key_path() const {
    std::string path;
    for (const Step& step : steps_) {
        if (step.key.empty()) {
            path += fmt::format("[{}]", step.index);
        } else {
            path += (path.empty() ? "" : ".") + step.key;
        }
    }
    return path;
}

Place Reader::key_place() const {
    return steps_.empty() ? root_place_ : steps_.back().place;
}

void Reader::error(const Place& place, Message message) {
    problems_->error(place, std::move(message), key_path());
}

void Reader::warning(const Place& place, Message message) {
    problems_->warning(place, std::move(message), key_path());
}

void Reader::error_at_path(const Place& place, Message message, std::string key_path) {
    problems_->error(place, std::move(message), std::move(key_path));
}

void Reader::wrong_type(const Node& node, std::string_view expected) {
    error(node.place,
          value_name() + " must be " + std::string(expected) + ", not " + describe(node));
}

void Reader::refer(ReferenceKind kind, const Node& node) {
    references_.push_back({kind, node.text, node.place, key_path()});
}

std::string Reader::file(const Node& node, FileKind kind) {
    const std::string& folder = sources_->at(node.place.source).folder;
    const FoundFile found = find_config_file(node.text, folder, *folders_);
    if (found.path.empty()) {
        error(node.place, found.problem);
        return {};
    }
    if (::access(found.path.c_str(), R_OK) != 0 && errno == EACCES) {
        error(node.place, "file " + quote(node.text) +
                              " cannot be read: " + std::generic_category().message(EACCES));
        return {};
    }
    std::error_code ignored;
    if (folders_->most_asset_bytes > 0 &&
        std::filesystem::file_size(found.path, ignored) > folders_->most_asset_bytes) {
        error(node.place, "file " + quote(node.text) + " has more than " +
                              std::to_string(folders_->most_asset_bytes >> 20U) +
                              " MiB, which is too much to read again after every change; 'carom "
                              "render' reads it");
        return {};
    }
    if (std::ranges::find(files_, &node, &FileOfNode::node) == files_.end()) {
        files_.push_back({&node, kind, found.path, key_path(), false});
    }
    replaced_[&node] = found.path;
    return found.path;
}

void Reader::set_background(const Node& node) {
    const auto file = std::ranges::find(files_, &node, &FileOfNode::node);
    if (file != files_.end()) {
        file->is_transparency_meant = true;
    }
}

void Reader::set_cut_out(const std::string& path) {
    const std::string value = key_path();
    for (FileOfNode& file : files_) {
        const bool is_within = file.key_path == value || file.key_path.starts_with(value + ".");
        file.is_transparency_meant = file.is_transparency_meant || (is_within && file.path == path);
    }
}

std::vector<NamedFile> Reader::named_files() const {
    std::vector<NamedFile> named;
    named.reserve(files_.size());
    for (const FileOfNode& file : files_) {
        const Place& place = file.node->place;
        named.push_back({file.kind,
                         file.path,
                         {Severity::error,
                          sources_->describe(place),
                          file.key_path,
                          {},
                          sources_->line_of(place),
                          sources_->include_chain(place)},
                         file.is_transparency_meant});
    }
    return named;
}

std::optional<double> Reader::time_of(const sim::EventTime& moment, const Node& node) {
    if (motion_ == nullptr) {
        moments_.push_back({key_path(), std::nullopt});
        return 0;
    }
    const auto found = sim::find_event_time(moment, *motion_->timeline, *motion_->world);
    if (const auto* reason = std::get_if<std::string>(&found)) {
        return leave_open(node, "this moment never comes: " + *reason);
    }
    const double ticks = static_cast<double>(kMomentTicks);
    const double time = std::round(std::get<double>(found) * ticks) / ticks;
    if (time < 0) {
        return leave_open(node,
                          "this moment is " + seconds_text(-time) + " before the shot begins");
    }
    moments_.push_back({key_path(), time});
    replaced_[&node] = seconds_text(time);
    return time;
}

std::optional<double> Reader::leave_open(const Node& node, const std::string& reason) {
    if (!motion_->keeps_open) {
        error(node.place, reason);
        return std::nullopt;
    }
    warning(node.place, reason);
    moments_.push_back({key_path(), std::nullopt});
    return 0;
}

std::string describe(const Node& node) {
    switch (node.kind) {
        case Node::Kind::null:
            return "nothing";
        case Node::Kind::scalar:
            return (node.quoted ? "the text " : "") + quote(node.text);
        case Node::Kind::sequence:
            return node.items.empty() ? "an empty list" : "a list";
        case Node::Kind::map:
            return "a map";
    }
    return {};
}

}  // namespace carom::pipeline::config
