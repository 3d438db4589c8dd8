// The messages of the studio as JSON, as binary messages and as the page's types.
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/protocol_types.h"
#include "tests/folders.h"

namespace carom::studio {
namespace {

std::string problem_of(const std::string& text) {
    try {
        static_cast<void>(read_page_message(text));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(StudioMessages, Text_IsReadWithAllFields) {
    const PageMessage message =
        read_page_message(R"({"t":"text","v":7,"file":"/a/b.yaml","text":"carom: 1\nü","base":6})");
    const auto& change = std::get<TextChange>(message);
    EXPECT_EQ(change.v, 7);
    EXPECT_EQ(change.file, "/a/b.yaml");
    EXPECT_EQ(change.text, "carom: 1\nü");
}

TEST(StudioMessages, PageMessages_AreTheSameAfterARoundTrip) {
    const std::vector<PageMessage> messages{
        Hello{kProtocol},
        TextChange{3, "a.yaml", "\"quoted\"\t\\"},
        Save{"a.yaml", "x", "00"},
        Revert{4, "a.yaml"},
        Open{"a.yaml", "b.yaml", "", true},
        Dragging{true},
        Recover{true},
        Simulate{9},
        SolveShot{1, 2, 0, "cue", "one", "side_back", {{0.5, 1}}},
        SolveShot{2, 2, 0, "cue", "one"},
        Judge{3, 2, 0, true, {{1.5, 2}}},
        Unsolve{}};
    for (const PageMessage& message : messages) {
        const std::string text = to_json(message);
        EXPECT_EQ(to_json(read_page_message(text)), text);
    }
}

TEST(StudioMessages, ShotState_IsTheSameAfterARoundTrip) {
    ShotState state;
    state.v = 12;
    state.name = "break";
    state.table = Table{2.54, 1.27, 0.036, 0.0286};
    state.objects.push_back({.name = "nine", .kind = "ball", .path = {"balls", "nine"}});
    state.objects.back().number = 9;
    state.objects.push_back({.name = "box", .kind = "object"});
    state.events.push_back({.path = {"events", "0"}, .kind = "strike", .duration = {}});
    state.cameras.push_back({.name = "top"});
    state.cameras.back().position.points.push_back({.path = {"cameras", "0", "position"}});
    state.places.push_back({.path = {"balls"}, .value = {"a.yaml", 3, 1, 4}, .origin = "shot"});
    const std::string text = to_json(ServerMessage(state));
    EXPECT_EQ(to_json(read_server_message(text)), text);
    EXPECT_NE(text.find(R"("number":9)"), std::string::npos);
    EXPECT_EQ(text.find("null"), std::string::npos);
}

TEST(StudioMessages, WrongTexts_AreErrorsThatNameTheMember) {
    EXPECT_EQ(problem_of("{"), "the message is not valid JSON");
    EXPECT_EQ(problem_of("[]"), "the message has no member 't' with its name");
    EXPECT_EQ(problem_of(R"({"t":"bye"})"), "there is no message \"bye\"");
    EXPECT_EQ(problem_of(R"({"t":"text","v":1,"file":"a"})"),
              "message 'text': member 'text' is missing");
    EXPECT_EQ(problem_of(R"({"t":"text","v":1.5,"file":"a","text":"","base":0})"),
              "message 'text': member 'v' has to be a whole number");
    EXPECT_EQ(problem_of(R"({"t":"text","v":18446744073709551615,"file":"a","text":"","base":0})"),
              "message 'text': member 'v' has to be a whole number");
    EXPECT_EQ(problem_of(R"({"t":"text","v":1,"file":7,"text":"","base":0})"),
              "message 'text': member 'file' has to be a text");
    EXPECT_EQ(problem_of(R"({"t":"dragging","on":1})"),
              "message 'dragging': member 'on' has to be true or false");
    EXPECT_EQ(problem_of(R"({"t":"dragging","on":true,"off":false})"),
              "message 'dragging': member 'off' is unknown");
    EXPECT_THROW(
        static_cast<void>(read_server_message(R"({"t":"files","v":1,"files":[{"file":1}]})")),
        Error);
}

TEST(StudioMessages, TextThatIsNotUtf8_IsAnError) {
    EXPECT_EQ(problem_of("{\"t\":\"text\",\"v\":1,\"file\":\"\xff\",\"text\":\"\"}"),
              "the message is not valid JSON");
}

TEST(StudioMessages, DeepNesting_IsAnError) {
    EXPECT_NE(problem_of(R"({"t":"text","v":)" + std::string(1'000'000, '[')), "");
    EXPECT_NE(problem_of(R"({"t":"text","v":)" + std::string(1'000'000, '[') +
                         std::string(1'000'000, ']') + R"(,"file":"","text":""})"),
              "");
}

TEST(StudioMessages, BinaryMessage_HasAnAlignedPayload) {
    const std::array<double, 3> numbers{1, 2.5, -3};
    TimelineHead head;
    head.v = 5;
    head.tracks.push_back({"cue", 0, 1});
    for (const char* name : {"", "x", "four", "seven__"}) {
        head.tracks.front().name = name;
        const std::string bytes = pack(head, std::as_bytes(std::span(numbers)));
        const Unpacked unpacked = unpack(std::as_bytes(std::span(bytes)));
        EXPECT_EQ(std::get<TimelineHead>(unpacked.head).tracks.front().name, name);
        ASSERT_EQ(unpacked.payload.size(), sizeof numbers);
        EXPECT_EQ((bytes.size() - sizeof numbers) % 8, 0U);
        EXPECT_EQ(std::memcmp(unpacked.payload.data(), numbers.data(), sizeof numbers), 0);
        for (std::size_t cut = 0; cut + sizeof numbers < bytes.size(); ++cut) {
            EXPECT_THROW(static_cast<void>(unpack(std::as_bytes(std::span(bytes.data(), cut)))),
                         Error);
        }
    }
}

TEST(StudioMessages, TypesOfThePage_AreThoseOfTheFields) {
    const std::string path = CAROM_SOURCE_DIR "/studio/src/protocol.ts";
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text, protocol_types())
        << "run: ninja -C build/test write_protocol && build/test/tests/write_protocol > " << path;
}

TEST(MessageJson, MessageWithoutMembers_HasItsTypeOnly) {
    EXPECT_EQ(to_json(PageMessage{StopFilm{}}), R"({"t":"stop_film"})");
}

}  // namespace
}  // namespace carom::studio
