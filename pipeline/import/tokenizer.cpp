#include "pipeline/import/tokenizer.h"

#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "pipeline/config/text.h"

namespace carom::pipeline::scene_text {

namespace {

using config::Place;

constexpr std::size_t kLongestWordBytes = 4096;
constexpr std::size_t kMaxDepth = 8;

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

bool is_brace(char c) {
    return c == '{' || c == '}';
}

class Tokenizer {
  public:
    Tokenizer(const config::SourceSet& sources, int source, config::ProblemList& problems)
        : sources_(sources), source_(source), problems_(problems) {
        open_.emplace_back();
    }

    std::vector<Item> run() {
        const std::string_view text = sources_.at(source_).text;
        std::size_t at = 0;
        while (at < text.size()) {
            if (is_space(text[at])) {
                ++at;
            } else if (is_brace(text[at])) {
                brace(text[at], sources_.place_at(source_, at, 1));
                ++at;
            } else {
                std::size_t end = at;
                while (end < text.size() && !is_space(text[end]) && !is_brace(text[end])) {
                    ++end;
                }
                add_word(text.substr(at, end - at), sources_.place_at(source_, at, end - at));
                at = end;
            }
        }
        while (open_.size() > 1) {
            problems_.error(open_.back().place, "'{' has no matching '}'");
            close();
        }
        return std::move(open_.front().group);
    }

  private:
    void add_word(std::string_view word, const Place& place) {
        if (word.size() > kLongestWordBytes) {
            problems_.error(
                place, fmt::format("this word has {} bytes; a name or number may have at most {}",
                                   word.size(), kLongestWordBytes));
            word = word.substr(0, 1);
        }
        open_.back().group.push_back({std::string(word), {}, false, place});
    }

    void brace(char c, const Place& place) {
        if (c == '{') {
            // Groups that are nested too deeply are read into the last allowed group.
            if (open_.size() > kMaxDepth) {
                if (too_deep_++ == 0) {
                    problems_.error(place,
                                    fmt::format("braces may be nested at most {} deep", kMaxDepth));
                }
                return;
            }
            open_.push_back({{}, {}, true, place});
        } else if (too_deep_ > 0) {
            --too_deep_;
        } else if (open_.size() == 1) {
            problems_.error(place, "'}' has no matching '{'");
        } else {
            close();
        }
    }

    void close() {
        Item group = std::move(open_.back());
        open_.pop_back();
        open_.back().group.push_back(std::move(group));
    }

    const config::SourceSet& sources_;
    int source_;
    config::ProblemList& problems_;
    std::vector<Item> open_;  // the whole text, then all open groups
    int too_deep_ = 0;
};

}  // namespace

std::vector<Item> tokenize(const config::SourceSet& sources, int source,
                           config::ProblemList& problems) {
    return Tokenizer(sources, source, problems).run();
}

}  // namespace carom::pipeline::scene_text
