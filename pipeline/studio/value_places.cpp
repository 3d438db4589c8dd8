#include "pipeline/studio/value_places.h"

#include <algorithm>
#include <utility>

#include "pipeline/studio/paths.h"

namespace carom::studio {

using pipeline::config::Entry;
using pipeline::config::Node;
using pipeline::config::Place;
using pipeline::config::SourceSet;

namespace {

class PlaceWalk {
  public:
    PlaceWalk(const SourceSet& sources, const std::string& root) {
        for (int i = 0; i < sources.size(); ++i) {
            const std::string& path = sources.at(i).path;
            texts_.push_back({path.empty() ? sources.at(i).name : path, i == 0         ? "shot"
                                                                        : path.empty() ? "set"
                                                                        : is_writable(path, root)
                                                                            ? "include"
                                                                            : "config"});
        }
    }

    void visit(const Node& node) {
        if (node.is_map()) {
            for (const Entry& entry : node.entries) {
                path_.push_back(entry.key);
                add(entry.key_place, entry.value);
                path_.pop_back();
            }
            return;
        }
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            if (!node.items[i].is_scalar()) {
                path_.push_back(std::to_string(i));
                add({}, node.items[i]);
                path_.pop_back();
            }
        }
    }

    [[nodiscard]] std::vector<ValuePlace> take() { return std::move(places_); }

  private:
    struct Text {
        std::string file;
        std::string origin;
    };

    [[nodiscard]] TextRange range_of(const Place& place) const {
        if (place.source < 0) {
            return {};
        }
        return {texts_.at(static_cast<std::size_t>(place.source)).file, place.line, place.column,
                place.length};
    }

    void add(const Place& key, const Node& value) {
        // A repeated value has no place of its own: an edit adds one for its object alone.
        if (value.place.source >= 0 && !value.is_repeated) {
            places_.push_back({path_, range_of(key), range_of(value.place),
                               texts_.at(static_cast<std::size_t>(value.place.source)).origin});
        }
        visit(value);
    }

    std::vector<Text> texts_;  // by the index of the source
    KeyPath path_;
    std::vector<ValuePlace> places_;
};

TextRange range_of(const pipeline::SourcePlace& place,
                   const std::vector<pipeline::ReadFile>& files) {
    const auto found = std::ranges::find(files, place.file, &pipeline::ReadFile::name);
    return {found != files.end() ? found->path : place.file, place.line, place.column,
            place.length};
}

}  // namespace

std::vector<ValuePlace> value_places(const pipeline::ShotSource& source, const std::string& root) {
    return value_places(source.sources(), source.root(), root);
}

std::vector<ValuePlace> value_places(const SourceSet& sources, const Node& top,
                                     const std::string& root) {
    PlaceWalk walk(sources, root);
    walk.visit(top);
    return walk.take();
}

std::vector<Problem> problem_messages(const std::vector<pipeline::Problem>& problems,
                                      const std::vector<pipeline::ReadFile>& files) {
    std::vector<Problem> messages;
    for (const pipeline::Problem& problem : problems) {
        Problem message;
        message.severity = problem.severity == Severity::error ? "error" : "warning";
        message.place = range_of(problem.place, files);
        message.key_path = problem.key_path;
        message.message = problem.message;
        message.suggestion = problem.suggestion;
        for (const pipeline::SourcePlace& place : problem.included_by) {
            message.included_by.push_back(range_of(place, files));
        }
        messages.push_back(std::move(message));
    }
    return messages;
}

}  // namespace carom::studio
