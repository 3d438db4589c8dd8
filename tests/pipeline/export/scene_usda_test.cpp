#include "pipeline/export/scene_usda.h"

#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>

#include "pipeline/export/scene_glb.h"
#include "pipeline/export/usda_text.h"
#include "sim/timeline/rotation.h"
#include "tests/pipeline/export/sample_scene.h"
#include "tests/pipeline/export/usda_reader.h"

namespace carom::pipeline {
namespace {

using carom::testing::UsdaAttribute;
using carom::testing::UsdaPrim;

const carom::testing::SampleScene& sample() {
    static const carom::testing::SampleScene scene = carom::testing::sample_scene();
    return scene;
}

const UsdaPrim& root() {
    static const UsdaPrim prim = carom::testing::read_usda(scene_to_usda(sample().scene).text);
    return prim;
}

const UsdaPrim& prim(const std::string& name) {
    const UsdaPrim* found = root().at("/shot/" + name);
    EXPECT_NE(found, nullptr) << name;
    static const UsdaPrim none;
    return found != nullptr ? *found : none;
}

TEST(SceneUsda, Header_HasAxesUnitsAndTime) {
    EXPECT_EQ(root().metadata.at("upAxis").text, "Z");
    EXPECT_EQ(root().metadata.at("metersPerUnit").number(), 1);
    EXPECT_EQ(root().metadata.at("timeCodesPerSecond").number(), 10);
    EXPECT_EQ(root().metadata.at("endTimeCode").number(), 6);
    EXPECT_EQ(root().metadata.at("defaultPrim").text, "shot");
    EXPECT_EQ(root().children.size(), 1U);
}

TEST(SceneUsda, Motion_IsThatOfTheTimeline) {
    for (const std::string name : {"cue", "one", "nine", "tile", "wheel"}) {
        const sim::Track& track = *sample().timeline.find(name);
        const auto& positions = prim(name).attributes.at("xformOp:translate");
        const auto& turns = prim(name).attributes.at("xformOp:orient").samples;
        ASSERT_FALSE(turns.empty()) << name;
        for (const auto& [code, value] : positions.samples) {
            const auto p = value.numbers();
            EXPECT_LT((track.sample(code / 10).position - Vec3(p[0], p[1], p[2])).length(), 1e-9);
        }
        for (const auto& [code, value] : turns) {
            const auto q = value.numbers();
            const Quat turn(q[0], Vec3(q[1], q[2], q[3]));
            EXPECT_LT(sim::angle_between(turn.normalized(), track.sample(code / 10).orientation),
                      1e-6);
        }
    }
    EXPECT_TRUE(prim("tip").attributes.at("xformOp:translate").samples.empty());
}

TEST(SceneUsda, BallThatIsPutElsewhere_JumpsBetweenNeighbouringCodes) {
    const auto& samples = prim("two").attributes.at("xformOp:translate").samples;
    double last_code = 0;
    Vec3 last(0, 0, 0);
    int jumps = 0;
    for (const auto& [code, value] : samples) {
        const auto p = value.numbers();
        const Vec3 place(p[0], p[1], p[2]);
        if (!(last == Vec3(0, 0, 0)) && (place - last).length() > 0.3) {
            ++jumps;
            EXPECT_EQ(code, std::nextafter(last_code, 10.0));
            EXPECT_NEAR(code / 10, 0.33, 1e-12);
            EXPECT_EQ(place, Vec3(0.4, -0.2, 0.028575));
        }
        last_code = code;
        last = place;
    }
    EXPECT_EQ(jumps, 1);
}

TEST(SceneUsda, MeshesAndTheirFields_AreComplete) {
    for (const UsdaPrim& mesh : root().children[0].children) {
        if (mesh.type != "Mesh") {
            continue;
        }
        const std::size_t points = mesh.attributes.at("points").value.items.size();
        const auto counts = mesh.attributes.at("faceVertexCounts").value.numbers();
        const auto corners = mesh.attributes.at("faceVertexIndices").value.numbers();
        EXPECT_EQ(corners.size(), 3 * counts.size()) << mesh.name;
        for (const double corner : corners) {
            ASSERT_LT(corner, static_cast<double>(points));
        }
        EXPECT_NE(root().at(mesh.attributes.at("material:binding").value.text), nullptr);
        for (const UsdaPrim& field : mesh.children) {
            EXPECT_EQ(field.type, "GeomSubset");
            EXPECT_NE(root().at(field.attributes.at("material:binding").value.text), nullptr);
            for (const double face : field.attributes.at("indices").value.numbers()) {
                ASSERT_LT(face, static_cast<double>(counts.size()));
            }
        }
    }
    EXPECT_EQ(prim("nine").children.size(), 1U);  // its white field
}

TEST(SceneUsda, Materials_HaveTheirColours) {
    const UsdaPrim& clear = prim("materials/clear/surface");
    EXPECT_EQ(clear.attributes.at("info:id").value.text, "UsdPreviewSurface");
    EXPECT_EQ(clear.attributes.at("inputs:diffuseColor").value.numbers(),
              (std::vector<double>{0.9, 0.9, 0.9}));
    EXPECT_EQ(prim("materials/clear").attributes.at("outputs:surface.connect").value.text,
              "/shot/materials/clear/surface.outputs:surface");
}

TEST(SceneUsda, Cameras_HaveAnimatedLenses) {
    EXPECT_EQ(prim("seat").type, "Xform");
    EXPECT_EQ(prim("seat/seat_lens").type, "Camera");
    const UsdaAttribute& lens = prim("seat/seat_lens").attributes.at("focalLength");
    ASSERT_EQ(lens.samples.size(), 6U);
    // The camera films backwards: scene time 0.1 s is the end of its interval, where the field of
    // view is 20 degrees.
    EXPECT_NEAR(lens.samples[0].first, 1, 1e-9);
    EXPECT_NEAR(lens.samples[0].second.number(), 10 * 0.012 / std::tan(std::acos(-1.0) / 18), 1e-5);
    EXPECT_NEAR(prim("seat/seat_lens").attributes.at("fStop").value.number(), 4, 1e-6);
    EXPECT_NEAR(prim("seat/seat_lens").attributes.at("verticalAperture").value.number(), 0.24,
                1e-7);
}

TEST(SceneUsda, Lights_HaveTheirTypes) {
    EXPECT_EQ(prim("lamp").type, "RectLight");
    EXPECT_EQ(prim("lamp").attributes.at("inputs:intensity").value.number(), 10);
    EXPECT_EQ(prim("bulb").type, "SphereLight");
    EXPECT_EQ(prim("spark").attributes.at("treatAsPoint").value.number(), 1);
    EXPECT_EQ(prim("room").type, "DomeLight");
    const auto q = prim("lamp").attributes.at("xformOp:orient").value.numbers();
    const Vec3 ahead = Quat(q[0], Vec3(q[1], q[2], q[3])).rotateVector(Vec3(0, 0, -1));
    EXPECT_LT((ahead - Vec3(0, 0, -1)).length(), 1e-6);
}

TEST(SceneUsda, ShotWithATable_IsComplete) {
    LoadResult loaded = load_shot_text(
        "carom: 1\ntable: {kind: pool}\nballs: {b-8: {at: [0, 0]}}\nsimulation: {duration: 0.1 "
        "s}\n"
        "cameras: [{name: b_8, video: [0 s, 1 s], scene: 0 s, position: [0, -1, 1], target: [0, 0, "
        "0]}]\n",
        "t.yaml");
    ASSERT_TRUE(loaded.shot);
    const sim::Timeline timeline = sim::bake(loaded.shot->world);
    const UsdaPrim file =
        carom::testing::read_usda(scene_to_usda(export_scene(*loaded.shot, timeline)).text);
    EXPECT_NE(file.at("/shot/table_cloth"), nullptr);
    EXPECT_EQ(file.at("/shot/table_cloth")->metadata.at("displayName").text, "table/cloth");
    EXPECT_EQ(file.at("/shot/b_8")->type, "Mesh");  // names have no '-' and are unique
    EXPECT_EQ(file.at("/shot/b_8_2")->type, "Xform");
    EXPECT_EQ(file.at("/shot/b_8_2/b_8_lens")->type, "Camera");
}

TEST(SceneUsda, PathsOfPictures_AreRelativeToTheFile) {
    ExportScene scene;
    const auto path_in = [&](const std::string& image, const std::string& folder) {
        render::EnvironmentLight room;
        room.image = image;
        scene.lights = {{"room", room}};
        const std::string file = (std::filesystem::path(folder) / "shot.usda").string();
        const std::string text = scene_to_usda(scene, file).text;
        const std::size_t begin = text.find("inputs:texture:file = ") + 22;
        return text.substr(begin, text.find('\n', begin) - begin);
    };
    EXPECT_EQ(path_in("/films/rooms/hall.exr", "/films/out/usd"), "@../../rooms/hall.exr@");
    EXPECT_EQ(path_in("/films/out/hall.exr", "/films/out"), "@./hall.exr@");
    EXPECT_EQ(path_in("/films/out/a@b.exr", "/films/out/"), "@@@./a@b.exr@@@");
    EXPECT_EQ(path_in(std::filesystem::current_path() / "hall.exr", ""), "@./hall.exr@");
}

// Floats are 0.5 m apart at such coordinates.
TEST(SceneUsda, MeshWithCoordinatesOfAMap_KeepsItsDigits) {
    Shot shot;
    render::MeshShape mesh;
    const Vec3 far(691'000.25, 5'334'000.5, 520.125);
    mesh.vertices = {far, far + Vec3(0.1, 0, 0), far + Vec3(0, 0.1, 0)};
    mesh.triangles = {{0, 1, 2}};
    render::ObjectDescription object;
    object.name = "stone";
    object.shape = mesh;
    Mat44 back;
    back.setTranslation(-far);
    shot.scene.objects = {object, object, object};
    shot.scene.objects[1].world_from_object = back;
    shot.scene.objects[2].track = "stone";
    sim::Timeline timeline;
    timeline.tracks.emplace_back("stone", std::vector<sim::Key>(1));
    shot.cameras.clear();
    const ExportScene scene = export_scene(shot, timeline);
    const Vec3 middle = far + Vec3(0.05, 0.05, 0);
    EXPECT_LT((scene.parts[0].keys.positions[0] - middle).length(), 1e-9);
    EXPECT_LT((scene.parts[1].keys.positions[0] - Vec3(0.05, 0.05, 0)).length(), 1e-8);
    EXPECT_EQ(scene.parts[2].keys.positions[0], Vec3(0, 0, 0));
    EXPECT_LT((scene.parts[2].origin - middle).length(), 1e-9);
    for (const ExportPart& part : scene.parts) {
        EXPECT_LT((part.mesh.vertices[0] - Imath::V3f(-0.05F, -0.05F, 0)).length(), 1e-7);
    }
    EXPECT_NE(
        scene_to_usda(scene).text.find("xformOp:translate:mesh = (691000.3, 5334000.55, 520.125)"),
        std::string::npos);
    const std::string glb = scene_to_glb(scene);
    EXPECT_NE(glb.find(R"("name":"stone mesh")"), std::string::npos);
    EXPECT_NE(glb.find(R"("children":[3])"), std::string::npos);
    EXPECT_NE(glb.find(R"("translation":[691000.3,520.125,-5334000.55])"), std::string::npos);
}

// three.js reads line by line; with several entries in one line it would find an empty scene.
TEST(SceneUsda, Metadata_HasOneLinePerEntry) {
    std::istringstream text(scene_to_usda(sample().scene).text);
    const std::regex whole_line(
        R"( +(displayName = "[^"]*"|prepend apiSchemas = \["\w+"\]|interpolation = "vertex"))");
    int entries = 0;
    for (std::string line; std::getline(text, line);) {
        for (const char* key : {"displayName", "apiSchemas", "interpolation"}) {
            if (line.find(key) != std::string::npos) {
                EXPECT_TRUE(std::regex_match(line, whole_line)) << line.substr(0, 200);
                ++entries;
            }
        }
    }
    EXPECT_GT(entries, 20);
}

TEST(UsdaText, Metadata_HasOneLinePerEntry) {
    UsdaText text;
    text.open("def Mesh \"cue\"", {"displayName = \"cue\"", "active = true"});
    text.line("normal3f[] normals = []", {"interpolation = \"vertex\""});
    text.open("def Scope \"none\"");
    text.close();
    text.close();
    EXPECT_EQ(text.finish(), R"(#usda 1.0
def Mesh "cue" (
    displayName = "cue"
    active = true
)
{
    normal3f[] normals = [] (
        interpolation = "vertex"
    )
    def Scope "none"
    {
    }
}
)");
}

TEST(UsdaText, TimeCodes_HaveNoExponent) {
    EXPECT_EQ(usda_time_code(1e-7), "0.0000001");
    EXPECT_EQ(usda_time_code(-0.0), "0");
    EXPECT_EQ(usda_time_code(4e7), "40000000");
    EXPECT_EQ(usda_time_code(0.1), "0.1");
}

TEST(UsdaText, Strings_AreQuoted) {
    EXPECT_EQ(usda_string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
    EXPECT_EQ(usda_number(-0.0), "0");
    EXPECT_EQ(usda_number(0.1F), "0.1");
}

}  // namespace
}  // namespace carom::pipeline
