#include "pipeline/config/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/config/emit_yaml.h"
#include "pipeline/config/parse_yaml.h"

namespace carom::pipeline::config {
namespace {

Node tree(SourceSet& sources, const std::string& text) {
    ProblemList problems(sources);
    const int source = sources.add({"t.yaml", ".", text});
    return *parse_yaml(sources, source, problems);
}

std::string merged(const std::string& base, const std::string& over) {
    SourceSet sources;
    Node root = tree(sources, base);
    merge(root, tree(sources, over));
    return emit_yaml(root);
}

/// The tree after an override, or the problem's place and message.
std::string overridden(const std::string& base, const std::string& text) {
    SourceSet sources;
    ProblemList problems(sources);
    Node root = tree(sources, base);
    apply_override(root, sources, sources.add({"--set", ".", text}), problems);
    const std::vector<Problem> found = problems.take();
    return found.empty() ? emit_yaml(root)
                         : found[0].place.file + ":" + std::to_string(found[0].place.line) + ":" +
                               std::to_string(found[0].place.column) + ": " + found[0].message;
}

TEST(Merge, Maps_MergeKeyByKey) {
    EXPECT_EQ(merged("a: {x: 1, y: 2}\nb: 3\n", "a: {y: 4, z: 5}\nc: 6\n"),
              "a:\n  x: 1\n  y: 4\n  z: 5\nb: 3\nc: 6\n");
}

TEST(Merge, ListsAndScalars_Replace) {
    EXPECT_EQ(merged("a: [1, 2]\nb: 1\n", "a: [3]\nb: {c: 2}\n"), "a:\n  - 3\nb:\n  c: 2\n");
}

TEST(Merge, Null_RemovesAKey) {
    EXPECT_EQ(merged("a: 1\nb: {c: 1, d: 2}\n", "a: null\nb: {c: ~}\n"), "b:\n  d: 2\n");
    EXPECT_EQ(merged("a: 1\n", "b: null\n"), "a: 1\nb: null\n");
}

TEST(Override, Path_LeadsThroughMapsAndLists) {
    EXPECT_EQ(overridden("render: {samples: 64}\n", "render.samples=16"),
              "render:\n  samples: 16\n");
    EXPECT_EQ(overridden("a: 1\n", "b.c=[1, 2 mm]"), "a: 1\nb:\n  c: [1, 2 mm]\n");
    EXPECT_EQ(overridden("cameras: [{name: a, fov: 1}, {name: b}]\n", "cameras[0].fov=2"),
              "cameras:\n  - {name: a, fov: 2}\n  - {name: b}\n");
    EXPECT_EQ(overridden("cameras: [{name: a, fov: 1}, {name: b}]\n", "cameras.b.fov=2"),
              "cameras:\n  - {name: a, fov: 1}\n  - {name: b, fov: 2}\n");
    EXPECT_EQ(overridden("cameras: [{name: a}, {name: b}]\n", "cameras.1={fov: 3}"),
              "cameras:\n  - {name: a}\n  - {name: b, fov: 3}\n");
}

TEST(Override, Map_IsMerged) {
    EXPECT_EQ(overridden("render: {samples: 64, fps: 24}\n", "render={samples: 1}"),
              "render:\n  samples: 1\n  fps: 24\n");
}

TEST(Override, Nothing_RemovesAKey) {
    EXPECT_EQ(overridden("rack: {set: nine_ball}\na: 1\n", "rack="), "a: 1\n");
    EXPECT_EQ(overridden("rack: {set: nine_ball}\na: 1\n", "rack=null"), "a: 1\n");
}

TEST(Override, ScalarInThePath_BecomesAMap) {
    EXPECT_EQ(overridden("render: {shutter: 180 deg}\n", "render.shutter.clock=scene"),
              "render:\n  shutter: {clock: scene}\n");
}

TEST(Override, Problems_HaveTheirPlaceInTheOverride) {
    EXPECT_EQ(overridden("a: 1\n", "render.samples"),
              "--set:1:1: 'render.samples' is not of the form KEY=VALUE, as in render.samples=64");
    EXPECT_EQ(overridden("a: 1\n", "=5"),
              "--set:1:1: '' is not a path of keys, as in render.samples");
    EXPECT_EQ(overridden("a: 1\n", "a..b=5"),
              "--set:1:1: 'a..b' is not a path of keys, as in render.samples");
    EXPECT_EQ(overridden("c: [1]\n", "c.4=5"),
              "--set:1:3: the list has no element '4'; it has 1, numbered from 0");
    EXPECT_THAT(overridden("a: 1\n", "a=[1, 2"), testing::StartsWith("--set:1:"));
}

}  // namespace
}  // namespace carom::pipeline::config
