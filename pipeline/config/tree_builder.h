// Builds a tree of nodes from the events of yaml-cpp's parser. This header is private, because it
// includes yaml-cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include "pipeline/config/node.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// yaml-cpp sends each container before its contents, so every limit is checked before its
/// recursion goes deeper.
class TreeBuilder : public YAML::EventHandler {
  public:
    /// Thrown to stop the parser after a problem was reported.
    struct Refused {};

    TreeBuilder(const SourceSet& sources, int source, ProblemList& problems,
                const YamlLimits& limits)
        : sources_(sources), source_(source), problems_(problems), limits_(limits) {}

    [[nodiscard]] Node take_root() { return std::move(root_); }

    /// The innermost open container when the parser stops early; nullptr if none is open.
    [[nodiscard]] const Node* innermost() const {
        return stack_.empty() ? nullptr : &stack_.back().node;
    }

    void OnDocumentStart(const YAML::Mark& mark) override;
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override;
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value style) override;
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value style) override;
    void OnMapEnd() override { close(); }

  private:
    struct Open {
        Node node;
        YAML::anchor_t anchor = 0;
        int nodes_before = 0;
        int height = 1;  // number of levels, including this one
        bool has_key = false;
        std::string key;
        Place key_place;
        std::map<std::string, Place> seen;  // keys
    };
    struct Anchored {
        Node node;
        int node_count = 0;
        int height = 0;
    };

    [[noreturn]] void refuse(const Place& place, std::string message);
    [[noreturn]] void refuse_depth(const YAML::Mark& mark);
    [[nodiscard]] Place token_place(const YAML::Mark& mark) const;
    void check_tag(const std::string& tag, const Place& place);
    void check_node_count(const YAML::Mark& mark);

    void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
              YAML::anchor_t anchor);
    void close();
    void keep(YAML::anchor_t anchor, const Node& node, int node_count, int height);
    void put(Node node);
    void put_key(Open& level, const Node& node);
    void put_value(Open& level, Node node);

    const SourceSet& sources_;
    int source_;
    ProblemList& problems_;
    YamlLimits limits_;
    Node root_;
    std::vector<Open> stack_;
    std::map<YAML::anchor_t, Anchored> anchors_;
    int node_count_ = 0;
    int anchored_count_ = 0;  // nodes kept for aliases
    int document_count_ = 0;
};

}  // namespace carom::pipeline::config
