#include "pipeline/config/parse_yaml.h"

#include <algorithm>
#include <istream>
#include <map>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

/// Ends the parse: the problem is already in the list.
struct Refused {};

/// Reads a text where it lies.
class TextBuffer : public std::streambuf {
  public:
    explicit TextBuffer(std::string& text) {
        setg(text.data(), text.data(), text.data() + text.size());
    }
};

/// yaml-cpp tells what it finds in order, each container before its contents, so every limit is
/// checked before its recursion goes deeper.
class TreeBuilder : public YAML::EventHandler {
  public:
    TreeBuilder(const SourceSet& sources, int source, ProblemList& problems,
                const YamlLimits& limits)
        : sources_(sources), source_(source), problems_(problems), limits_(limits) {}

    [[nodiscard]] Node take_root() { return std::move(root_); }
    [[nodiscard]] int document_count() const { return document_count_; }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++document_count_ > 1) {
            refuse(place_of(mark, 1), "a file holds one document only");
        }
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        Node node;
        node.place = token_place(mark);
        finish(std::move(node), anchor);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end()) {
            refuse(token_place(mark), "an alias cannot stand inside the node that it names");
        }
        check_depth_of_alias(found->second, mark);
        node_count_ += found->second.node_count;
        check_node_count(mark);
        finish(found->second.node, 0);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        Node node;
        node.kind = Node::Kind::scalar;
        node.place = token_place(mark);
        node.quoted = tag == "!";
        node.text = value;
        check_tag(tag, node.place);
        finish(std::move(node), anchor);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value /*style*/) override {
        open(Node::Kind::sequence, mark, tag, anchor);
    }
    void OnSequenceEnd() override { close(); }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value /*style*/) override {
        open(Node::Kind::map, mark, tag, anchor);
    }
    void OnMapEnd() override { close(); }

  private:
    struct Open {
        Node node;
        YAML::anchor_t anchor = 0;
        int nodes_before = 0;
        int height = 1;  // levels below this one, itself included
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

    [[noreturn]] void refuse(const Place& place, std::string message) {
        problems_.error(place, std::move(message));
        throw Refused{};
    }

    [[nodiscard]] Place place_of(const YAML::Mark& mark, std::size_t length_bytes) const {
        return sources_.place_at(source_, sources_.offset_of(source_, mark.line, mark.column),
                                 length_bytes);
    }

    /// The place of the token at `mark`, behind its tag and anchor.
    [[nodiscard]] Place token_place(const YAML::Mark& mark) const;

    void check_tag(const std::string& tag, const Place& place) {
        if (!tag.empty() && tag != "?" && tag != "!") {
            refuse(place, "tags such as " + quote(tag) + " have no meaning here");
        }
    }

    void check_node_count(const YAML::Mark& mark) {
        if (node_count_ > limits_.nodes) {
            refuse(token_place(mark), "more than " + std::to_string(limits_.nodes) +
                                          " values (aliases counted with what they stand for)");
        }
    }

    [[noreturn]] void refuse_depth(const YAML::Mark& mark) {
        refuse(token_place(mark),
               "nested deeper than " + std::to_string(limits_.depth) + " levels");
    }

    void check_depth_of_alias(const Anchored& anchored, const YAML::Mark& mark) {
        if (static_cast<int>(stack_.size()) + anchored.height > limits_.depth) {
            refuse_depth(mark);
        }
    }

    void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
              YAML::anchor_t anchor) {
        if (static_cast<int>(stack_.size()) >= limits_.depth) {
            refuse_depth(mark);
        }
        ++node_count_;
        check_node_count(mark);
        Open level;
        level.node.kind = kind;
        level.node.place = token_place(mark);
        level.anchor = anchor;
        level.nodes_before = node_count_ - 1;
        check_tag(tag, level.node.place);
        stack_.push_back(std::move(level));
    }

    void close() {
        Open level = std::move(stack_.back());
        stack_.pop_back();
        if (level.anchor != 0) {
            const int count = node_count_ - level.nodes_before;
            anchored_count_ += count;
            if (anchored_count_ > limits_.nodes) {
                refuse(level.node.place, "too much stands behind anchors");
            }
            anchors_[level.anchor] = {level.node, count, level.height};
        }
        if (!stack_.empty()) {
            stack_.back().height = std::max(stack_.back().height, level.height + 1);
        }
        put(std::move(level.node));
    }

    /// A node without anything inside that yaml-cpp still has to tell.
    void finish(Node node, YAML::anchor_t anchor) {
        if (anchor != 0) {
            anchors_[anchor] = {node, 1, 0};
        }
        ++node_count_;
        put(std::move(node));
    }

    void put(Node node) {
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

    void put_key(Open& level, const Node& node) {
        if (!node.is_scalar()) {
            refuse(node.place, "a key must be a plain word");
        }
        level.has_key = true;
        level.key = node.text;
        level.key_place = node.place;
    }

    void put_value(Open& level, Node node) {
        level.has_key = false;
        const auto [first, is_new] = level.seen.emplace(level.key, level.key_place);
        if (!is_new) {
            problems_.error(level.key_place, "duplicate key " + quote(level.key) +
                                                 " (first given at " +
                                                 sources_.to_string(first->second) + ")");
            return;
        }
        if (static_cast<int>(level.seen.size()) > limits_.entries_per_map) {
            refuse(level.key_place,
                   "a map of more than " + std::to_string(limits_.entries_per_map) + " keys");
        }
        level.node.entries.push_back({std::move(level.key), level.key_place, std::move(node)});
    }

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

/// Bytes of the token that starts at `offset`: a quoted scalar with its quotes, an alias, a plain
/// scalar up to its end on this line, or one bracket.
std::size_t token_length(std::string_view text, std::size_t offset) {
    const std::string_view rest = text.substr(offset);
    const std::size_t line_end = std::min(rest.find_first_of("\r\n"), rest.size());
    if (rest.empty() || line_end == 0) {
        return 1;
    }
    const char first = rest[0];
    if (first == '"' || first == '\'') {
        std::size_t i = 1;
        while (i < line_end && rest[i] != first) {
            i += first == '"' && rest[i] == '\\' ? 2 : 1;
        }
        return std::min(i + 1, line_end);
    }
    if (first == '[' || first == '{' || first == '-' || first == '|' || first == '>') {
        const bool is_number = first == '-' && rest.size() > 1 && rest[1] != ' ';
        if (!is_number) {
            return 1;
        }
    }
    std::size_t end = 0;
    while (end < line_end) {
        const char c = rest[end];
        const char next = end + 1 < line_end ? rest[end + 1] : ' ';
        if (c == ',' || c == ']' || c == '}' || (c == ':' && (next == ' ' || next == '\t')) ||
            (c == '#' && end > 0 && rest[end - 1] == ' ')) {
            break;
        }
        ++end;
    }
    while (end > 1 && (rest[end - 1] == ' ' || rest[end - 1] == '\t')) {
        --end;
    }
    return std::max<std::size_t>(1, end);
}

/// `offset` moved behind "&anchor " and "!tag ".
std::size_t skip_properties(std::string_view text, std::size_t offset) {
    while (offset < text.size() && (text[offset] == '&' || text[offset] == '!')) {
        const std::size_t blank = text.find_first_of(" \t\r\n", offset);
        const std::size_t next = blank == std::string_view::npos
                                     ? std::string_view::npos
                                     : text.find_first_not_of(" \t\r\n", blank);
        if (next == std::string_view::npos) {
            return offset;
        }
        offset = next;
    }
    return offset;
}

Place TreeBuilder::token_place(const YAML::Mark& mark) const {
    const std::string& text = sources_.at(source_).text;
    const std::size_t offset =
        skip_properties(text, sources_.offset_of(source_, mark.line, mark.column));
    return sources_.place_at(source_, offset, token_length(text, offset));
}

/// yaml-cpp scans a whole run of open brackets before it tells of the first; a text with absurdly
/// many is refused before that. Brackets in strings count too, hence the generous bound.
bool has_absurd_nesting(std::string_view text, std::size_t& offset) {
    constexpr int kAbsurd = 2000;
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '[' || text[i] == '{') {
            if (++open > kAbsurd) {
                offset = i;
                return true;
            }
        } else if (text[i] == ']' || text[i] == '}') {
            open = std::max(0, open - 1);
        }
    }
    return false;
}

bool check_raw_text(const SourceSet& sources, int source, ProblemList& problems,
                    const YamlLimits& limits) {
    const std::string& text = sources.at(source).text;
    if (text.size() > limits.bytes) {
        problems.error({source, 0, 0, 1}, "the file has " + std::to_string(text.size()) +
                                              " bytes; at most " + std::to_string(limits.bytes) +
                                              " are read");
        return false;
    }
    const std::size_t invalid = find_invalid_utf8(text);
    if (invalid != std::string_view::npos) {
        problems.error(sources.place_at(source, invalid, 1), "not UTF-8 text");
        return false;
    }
    std::size_t offset = 0;
    if (has_absurd_nesting(text, offset)) {
        problems.error(sources.place_at(source, offset, 1),
                       "nested deeper than " + std::to_string(limits.depth) + " levels");
        return false;
    }
    return true;
}

}  // namespace

std::optional<Node> parse_yaml(const SourceSet& sources, int source, ProblemList& problems,
                               const YamlLimits& limits, std::size_t skipped_bytes) {
    if (!check_raw_text(sources, source, problems, limits)) {
        return std::nullopt;
    }
    std::string text = sources.at(source).text;
    std::fill_n(text.begin(), std::min(skipped_bytes, text.size()), ' ');
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    TreeBuilder builder(sources, source, problems, limits);
    try {
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const Refused&) {
        return std::nullopt;
    } catch (const YAML::Exception& failure) {
        const std::size_t offset =
            sources.offset_of(source, failure.mark.line, failure.mark.column);
        problems.error(sources.place_at(source, offset, 1), "YAML syntax: " + failure.msg);
        return std::nullopt;
    }
    Node root = builder.take_root();
    if (root.place.source < 0) {
        root.place = sources.place_at(source, 0, 1);
    }
    return root;
}

}  // namespace carom::pipeline::config
