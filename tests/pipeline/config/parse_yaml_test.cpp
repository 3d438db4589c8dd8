#include "pipeline/config/parse_yaml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom::pipeline::config {
namespace {

using testing::ElementsAre;

struct Parsed {
    std::optional<Node> root;
    std::vector<std::string> problems;  // "line:column+length message"
};

Parsed parse(std::string text, const YamlLimits& limits = {}) {
    SourceSet sources;
    ProblemList list(sources);
    const int source = sources.add({"t.yaml", ".", std::move(text)});
    Parsed result;
    result.root = parse_yaml(sources, source, list, limits);
    for (const Problem& problem : list.take()) {
        result.problems.push_back(std::to_string(problem.place.line) + ":" +
                                  std::to_string(problem.place.column) + "+" +
                                  std::to_string(problem.place.length) + " " + problem.message);
    }
    return result;
}

std::string where(const Place& place) {
    return std::to_string(place.line) + ":" + std::to_string(place.column) + "+" +
           std::to_string(place.length);
}

TEST(ParseYaml, Values_HaveTheirPlaces) {
    const Parsed parsed = parse("a: 57.15 mm  # comment\nb:\n  - 'two words'\n  - [1, x: y]\n");
    ASSERT_TRUE(parsed.root);
    const Entry* a = parsed.root->find("a");
    EXPECT_EQ(where(a->key_place), "1:1+1");
    EXPECT_EQ(where(a->value.place), "1:4+8");
    EXPECT_FALSE(a->value.quoted);
    const Node& b = parsed.root->find("b")->value;
    EXPECT_EQ(where(b.items[0].place), "3:5+11");
    EXPECT_TRUE(b.items[0].quoted);
    EXPECT_EQ(where(b.items[1].items[1].find("x")->value.place), "4:12+1");
}

TEST(ParseYaml, Columns_CountCharacters) {
    const Parsed parsed = parse("k\xC3\xA9y: [\xC3\xBC, no]\n");
    EXPECT_EQ(where(parsed.root->entries[0].value.items[1].place), "1:10+2");
}

TEST(ParseYaml, DuplicateKey_NamesBothPlaces) {
    EXPECT_THAT(parse("a: 1\nb: 2\na: 3\n").problems,
                ElementsAre("3:1+1 duplicate key 'a' (first given at t.yaml:1:1)"));
}

TEST(ParseYaml, Alias_IsACopyOfItsAnchor) {
    const Parsed parsed = parse("a: &x {k: 1}\nb: *x\nc: &y word\nd: *y\n");
    ASSERT_TRUE(parsed.root);
    EXPECT_EQ(parsed.root->find("b")->value.find("k")->value.text, "1");
    EXPECT_EQ(parsed.root->find("d")->value.text, "word");
    EXPECT_EQ(where(parsed.root->find("c")->value.place), "3:7+4");
}

TEST(ParseYaml, AliasBomb_IsRefused) {
    std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < 12; ++i) {
        const std::string before = "*a" + std::to_string(i - 1);
        text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
        for (int k = 1; k < 10; ++k) {
            text += ", " + before;
        }
        text += "]\n";
    }
    const Parsed parsed = parse(text);
    EXPECT_FALSE(parsed.root);
    ASSERT_EQ(parsed.problems.size(), 1U);
    EXPECT_THAT(parsed.problems[0], testing::HasSubstr("more than 250000 values"));
}

TEST(ParseYaml, NestedAnchors_AreBoundedInMemory) {
    std::string text;
    for (int i = 0; i < 60; ++i) {
        text += "&a" + std::to_string(i) + " [";
    }
    text += "x";
    for (int i = 0; i < 10'000; ++i) {
        text += ",x";
    }
    const Parsed parsed = parse(text + std::string(60, ']'));
    EXPECT_THAT(parsed.problems,
                ElementsAre(testing::HasSubstr("the values with anchors are too large")));
}

TEST(ParseYaml, AliasInsideItself_IsRefused) {
    EXPECT_THAT(parse("a: &x [1, *x]\n").problems,
                ElementsAre("1:11+2 an alias cannot be inside the value that it refers to"));
}

TEST(ParseYaml, Depth_IsLimited) {
    const auto nested = [](int depth) {
        return "a: " + std::string(depth, '[') + std::string(depth, ']') + "\n";
    };
    EXPECT_TRUE(parse(nested(63)).root);
    EXPECT_THAT(parse(nested(64)).problems,
                ElementsAre("1:67+1 maps and lists are nested more than 64 levels deep"));
    std::string blocks;
    for (int i = 0; i < 70; ++i) {
        blocks += std::string(i, ' ') + "a:\n";
    }
    EXPECT_THAT(
        parse(blocks).problems,
        ElementsAre(testing::HasSubstr("maps and lists are nested more than 64 levels deep")));
    std::string dashes;
    for (int i = 0; i < 100'000; ++i) {
        dashes += "- ";
    }
    EXPECT_THAT(
        parse(dashes).problems,
        ElementsAre(testing::HasSubstr("maps and lists are nested more than 64 levels deep")));
    EXPECT_THAT(
        parse("a: &x [" + std::string(40, '[') + std::string(40, ']') +
              "]\nb: " + std::string(40, '[') + "*x" + std::string(40, ']'))
            .problems,
        ElementsAre(testing::HasSubstr("maps and lists are nested more than 64 levels deep")));
}

TEST(ParseYaml, AMillionBrackets_AreRefusedBeforeParsing) {
    EXPECT_THAT(parse(std::string(1'000'000, '[')).problems,
                ElementsAre("1:2001+1 maps and lists are nested more than 64 levels deep"));
}

TEST(ParseYaml, Size_IsLimited) {
    const std::string how_to_raise = "; CAROM_LIMITS=2 in the environment doubles all such limits";
    YamlLimits limits;
    limits.bytes = 10;
    EXPECT_THAT(parse("a: 12345678\n", limits).problems,
                ElementsAre("0:0+1 the file has 12 bytes; at most 10 are allowed" + how_to_raise));
    limits.bytes = 100;
    limits.entries_per_map = 2;
    EXPECT_THAT(parse("{a: 1, b: 2, c: 3}", limits).problems,
                ElementsAre("1:14+1 a map of more than 2 keys" + how_to_raise));
}

TEST(ParseYaml, SyntaxError_IsTheOnlyProblem) {
    const Parsed parsed = parse("a: [1, 2\nb: 3\n");
    EXPECT_FALSE(parsed.root);
    EXPECT_EQ(parsed.problems.size(), 1U);
}

TEST(ParseYaml, UnsupportedYaml_IsRefused) {
    EXPECT_THAT(parse("a: !!str 5\n").problems, ElementsAre(testing::HasSubstr("tags such as")));
    EXPECT_THAT(parse("[a]: 5\n").problems, ElementsAre("1:1+1 a key must be a word"));
    EXPECT_THAT(parse("a: 1\n---\nb: 2\n").problems,
                ElementsAre(testing::HasSubstr("a file may contain only one document")));
    EXPECT_THAT(parse("a: \xFF\n").problems, ElementsAre("1:4+1 this is not valid UTF-8 text"));
}

TEST(ParseYaml, EmptyText_IsNull) {
    EXPECT_TRUE(parse("").root->is_null());
    EXPECT_TRUE(parse("# nothing\n").root->is_null());
}

}  // namespace
}  // namespace carom::pipeline::config
