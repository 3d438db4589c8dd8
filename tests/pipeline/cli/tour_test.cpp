// Follows docs/tour.md exactly: writes its files, runs its commands and compares their output.
#include <fstream>

#include "tests/folders.h"
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::HasSubstr;

struct Block {
    std::string kind;       // "yaml", "sh", "text"
    std::string file;       // of yaml
    bool is_added = false;  // to the file, at its end
    int line = 0;           // of the page
    std::vector<std::string> lines;

    [[nodiscard]] std::string text() const {
        std::string all;
        for (const std::string& l : lines) {
            all += l + "\n";
        }
        return all;
    }
};

std::vector<Block> blocks_of(const std::string& page) {
    std::ifstream file(page);
    std::vector<Block> blocks;
    bool is_open = false;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (!line.starts_with("```")) {
            if (is_open) {
                blocks.back().lines.push_back(line);
            }
            continue;
        }
        is_open = !is_open;
        if (is_open) {
            std::istringstream words(line.substr(3));
            Block block;
            block.line = number;
            std::string added;
            words >> block.kind >> block.file >> added;
            block.is_added = added == "+";
            blocks.push_back(block);
        }
    }
    EXPECT_FALSE(is_open);
    return blocks;
}

/// The words of a line, split like a shell does, with blanks inside quotes.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words(1);
    bool is_quoted = false;
    for (const char letter : line) {
        if (letter == '\'') {
            is_quoted = !is_quoted;
        } else if (letter == ' ' && !is_quoted) {
            words.emplace_back();
        } else {
            words.back() += letter;
        }
    }
    return words;
}

class Tour : public EndToEnd {
  protected:
    /// The output of a command on stdout and stderr. Commands that render get a tiny size.
    std::string run_line(const std::string& line, bool fails) {
        std::vector<std::string> words = words_of(line);
        if (words[0] == "touch") {
            carom::testing::write_text(path(words.at(1)), "");
            return {};
        }
        EXPECT_EQ(words[0], "carom") << "what the tour runs: " << line;
        words.erase(words.begin());
        for (const char* renders : {"render", "frame", "retime", "contact-sheet"}) {
            if (words[0] == renders) {
                for (const char* tiny :
                     {"render.size=[48, 28]", "render.samples=1", "render.noise=0",
                      "render.max_bounces=1", "render.fps=4"}) {
                    words.insert(words.end(), {"--set", tiny});
                }
            }
        }
        if (words[0] == "contact-sheet") {
            words.insert(words.end(), {"--width", "48"});
        }
        const RunResult result = run(words);
        EXPECT_EQ(result.exit_code, fails ? 2 : 0) << line << "\n" << result.err;
        return result.err + result.out;
    }
};

TEST_F(Tour, EveryCommand_PrintsWhatThePageShows) {
    const std::vector<Block> blocks = blocks_of(CAROM_SOURCE_DIR "/docs/tour.md");
    EXPECT_GT(blocks.size(), 20U);
    std::string output;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        SCOPED_TRACE("docs/tour.md:" + std::to_string(block.line));
        if (block.kind == "yaml") {
            const std::string before = block.is_added ? text_of(block.file) : "";
            carom::testing::write_text(path(block.file), before + block.text());
        } else if (block.kind == "sh") {
            const bool has_text = i + 1 < blocks.size() && blocks[i + 1].kind == "text";
            const bool fails =
                has_text && blocks[i + 1].text().find(": error: ") != std::string::npos;
            output.clear();
            for (const std::string& line : block.lines) {
                output += run_line(line, fails && line == block.lines.back());
            }
        } else {
            ASSERT_EQ(block.kind, "text");
            for (const std::string& line : block.lines) {
                EXPECT_THAT(output, HasSubstr(line));
            }
        }
    }
    // The tour promises three cameras, one of them in slow motion.
    EXPECT_THAT(run({"plan", "shot.yaml", "-o", "-"}).out, HasSubstr("1/20×"));
    for (const char* film :
         {"draft.mp4", "shot.mp4", "slower.mp4", "back.mp4", "sheet.png", "frame.png"}) {
        EXPECT_TRUE(exists(film)) << film;
    }
}

}  // namespace
}  // namespace carom::cli
