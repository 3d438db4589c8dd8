#include "pipeline/config/tree_builder.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/limits.h"
#include "pipeline/config/text.h"
#include "pipeline/config/token.h"

namespace carom::pipeline::config {

void TreeBuilder::refuse(const Place& place, std::string message) {
    problems_.error(place, std::move(message));
    throw Refused{};
}

void TreeBuilder::refuse_depth(const YAML::Mark& mark) {
    refuse(token_place(mark),
           fmt::format("maps and lists are nested more than {} levels deep", limits_.depth));
}

Place TreeBuilder::token_place(const YAML::Mark& mark) const {
    return token_at(sources_, source_, mark.line, mark.column);
}

void TreeBuilder::check_tag(const std::string& tag, const Place& place) {
    // "?" is a plain scalar or a container without a tag, "!" a quoted scalar.
    if (!tag.empty() && tag != "?" && tag != "!") {
        refuse(place, "tags such as " + quote(tag) + " are not supported");
    }
}

void TreeBuilder::check_node_count(const YAML::Mark& mark) {
    if (node_count_ > limits_.nodes) {
        refuse(token_place(mark),
               beyond_limit(static_cast<std::size_t>(limits_.nodes),
                            "values (an alias counts as all values that it refers to)"));
    }
}

void TreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
    if (++document_count_ > 1) {
        refuse(sources_.place_at(source_, sources_.offset_of(source_, mark.line, mark.column), 3),
               "a file may contain only one document");
    }
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
    Node node;
    node.place = token_place(mark);
    ++node_count_;
    check_node_count(mark);
    keep(anchor, node, 1, 0);
    put(std::move(node));
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           const std::string& value) {
    Node node;
    node.kind = Node::Kind::scalar;
    node.place = token_place(mark);
    node.quoted = tag == "!";
    node.text = value;
    check_tag(tag, node.place);
    ++node_count_;
    check_node_count(mark);
    keep(anchor, node, 1, 0);
    put(std::move(node));
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) {
        refuse(token_place(mark), "an alias cannot be inside the value that it refers to");
    }
    const Anchored& anchored = found->second;
    if (static_cast<int>(stack_.size()) + anchored.height > limits_.depth) {
        refuse_depth(mark);
    }
    node_count_ += anchored.node_count;
    check_node_count(mark);
    if (!stack_.empty()) {
        stack_.back().height = std::max(stack_.back().height, anchored.height + 1);
    }
    put(anchored.node);
}

void TreeBuilder::OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                                  YAML::anchor_t anchor, YAML::EmitterStyle::value /*style*/) {
    open(Node::Kind::sequence, mark, tag, anchor);
}

void TreeBuilder::OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                             YAML::EmitterStyle::value /*style*/) {
    open(Node::Kind::map, mark, tag, anchor);
}

void TreeBuilder::open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
                       YAML::anchor_t anchor) {
    if (static_cast<int>(stack_.size()) >= limits_.depth) {
        refuse_depth(mark);
    }
    Open level;
    level.nodes_before = node_count_++;
    check_node_count(mark);
    level.node.kind = kind;
    level.node.place = token_place(mark);
    level.anchor = anchor;
    check_tag(tag, level.node.place);
    stack_.push_back(std::move(level));
}

void TreeBuilder::close() {
    Open level = std::move(stack_.back());
    stack_.pop_back();
    keep(level.anchor, level.node, node_count_ - level.nodes_before, level.height);
    if (!stack_.empty()) {
        stack_.back().height = std::max(stack_.back().height, level.height + 1);
    }
    put(std::move(level.node));
}

void TreeBuilder::keep(YAML::anchor_t anchor, const Node& node, int node_count, int height) {
    if (anchor == 0) {
        return;
    }
    anchored_count_ += node_count;
    if (anchored_count_ > limits_.nodes) {
        refuse(node.place,
               std::string("the values with anchors are too large") + how_to_raise_limits());
    }
    anchors_[anchor] = {node, node_count, height};
}

void TreeBuilder::put(Node node) {
    if (stack_.empty()) {
        root_ = std::move(node);
        return;
    }
    Open& level = stack_.back();
    if (level.node.is_sequence()) {
        level.node.items.push_back(std::move(node));
    } else if (level.has_key) {
        put_value(level, std::move(node));
    } else {
        put_key(level, node);
    }
}

void TreeBuilder::put_key(Open& level, const Node& node) {
    if (!node.is_scalar()) {
        refuse(node.place, "a key must be a word");
    }
    if (const std::optional<OddSpace> space = find_odd_space(node.text); space && !node.quoted) {
        refuse(node.place, "this key contains " + space->name + "; write an ordinary space");
    }
    level.has_key = true;
    level.key = node.text;
    level.key_place = node.place;
}

void TreeBuilder::put_value(Open& level, Node node) {
    level.has_key = false;
    const auto [first, is_new] = level.seen.emplace(level.key, level.key_place);
    if (!is_new) {
        problems_.error(level.key_place, "duplicate key " + quote(level.key) + " (first given at " +
                                             sources_.to_string(first->second) + ")");
        return;
    }
    if (static_cast<int>(level.seen.size()) > limits_.entries_per_map) {
        refuse(
            level.key_place,
            "a map of " + beyond_limit(static_cast<std::size_t>(limits_.entries_per_map), "keys"));
    }
    level.node.entries.push_back({std::move(level.key), level.key_place, std::move(node)});
}

}  // namespace carom::pipeline::config
