// WebSockets: what pages may send, what they get, and what the server survives.
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "tests/pipeline/server/running_server.h"

namespace {

using carom::server::Message;
using carom::server::ServerOptions;
using carom::testing::Frame;
using carom::testing::frame_bytes;
using carom::testing::HttpAnswer;
using carom::testing::RawClient;
using carom::testing::RunningServer;

constexpr int kText = 1;
constexpr int kBinary = 2;
constexpr int kClose = 8;
constexpr int kPing = 9;
constexpr int kPong = 10;

/// The code with which the server closes, after whatever else it sends; 0 if it says none.
int close_code_of(RawClient& client) {
    while (const std::optional<Frame> frame = client.read_frame()) {
        if (frame->operation == kClose) {
            return frame->close_code();
        }
    }
    return 0;
}

TEST(ServerSocket, Texts_ReachTheSite) {
    RunningServer running;
    const auto client = running.open_socket();
    client->send(frame_bytes(kText, "one") + frame_bytes(kText, ""));
    EXPECT_EQ(running.site.next_event(), "received 1 one");
    EXPECT_EQ(running.site.next_event(), "received 1 ");
    client->send(frame_bytes(kText, std::string(4 << 20, 'x')));  // the longest
    EXPECT_EQ(running.site.next_event().size(), std::string("received 1 ").size() + (4 << 20));
}

TEST(ServerSocket, Messages_ReachThePage) {
    RunningServer running;
    const auto client = running.open_socket();
    const auto other = running.open_socket();
    running.server->send(1, {false, "text", ""});
    running.server->send(2, {false, "not for the first", ""});
    running.server->send(0, {true, std::string("\0\1", 2), "slot"});
    running.server->send(7, {false, "nobody", ""});
    std::optional<Frame> frame = client->read_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->operation, kText);
    EXPECT_EQ(frame->payload, "text");
    frame = client->read_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->operation, kBinary);
    EXPECT_EQ(frame->payload, std::string("\0\1", 2));
    EXPECT_EQ(other->read_frame()->payload, "not for the first");
    EXPECT_EQ(other->read_frame()->payload, std::string("\0\1", 2));
}

TEST(ServerSocket, LongMessage_IsOneFrame) {
    RunningServer running;
    const auto client = running.open_socket();
    running.server->send(1, {true, std::string(1 << 20, 'p'), "picture"});
    const std::optional<Frame> frame = client->read_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->payload.size(), 1 << 20);
}

TEST(ServerSocket, Extensions_AreNotUsed) {
    RunningServer running;
    const HttpAnswer answer = running.ask(
        running.upgrade(running.origin() + "Sec-WebSocket-Extensions: permessage-deflate\r\n"));
    EXPECT_EQ(answer.status, 101);
    EXPECT_EQ(answer.head.find("permessage-deflate"), std::string::npos);
}

TEST(ServerSocket, OtherPaths_OpenNoSocket) {
    RunningServer running;
    std::string request = running.upgrade(running.origin());
    request.replace(request.find("/socket"), 7, "/sockets");
    EXPECT_EQ(running.ask(request).status, 401);  // the key in this field is for one path
    EXPECT_EQ(running.ask(running.request("/socket")).status, 404);
}

TEST(ServerSocket, TooLongMessage_ClosedWith1009) {
    RunningServer running;
    const auto client = running.open_socket();
    std::jthread sending([&] { client->send(frame_bytes(kText, std::string(5 << 20, 'x'))); });
    EXPECT_EQ(close_code_of(*client), 1009);
    EXPECT_EQ(running.site.next_event(), "closed 1");
    EXPECT_TRUE(client->is_closed_by_server());
}

TEST(ServerSocket, TooLongMessageInParts_ClosedWith1009) {
    RunningServer running;
    const auto client = running.open_socket();
    std::jthread sending([&] {
        client->send(frame_bytes(kText, "start", false));
        for (int i = 0; i < 5; ++i) {
            client->send(frame_bytes(0, std::string(1 << 20, 'x'), false));
        }
    });
    EXPECT_EQ(close_code_of(*client), 1009);
}

TEST(ServerSocket, WrongFrames_ClosedWithTheirCode) {
    struct Case {
        std::string bytes;
        int code;
    };
    for (const Case& wrong : {
             Case{frame_bytes(kText, "unmasked", true, false), 1002},
             Case{frame_bytes(kText | 0x40, "reserved bit"), 1002},
             Case{frame_bytes(3, "unknown operation"), 1002},
             Case{frame_bytes(0, "continues nothing"), 1002},
             Case{frame_bytes(kPing, "in parts", false), 1002},
             Case{frame_bytes(kPing, std::string(126, 'x')), 1002},
             Case{frame_bytes(kText, "a", false) + frame_bytes(kText, "b"), 1002},
             Case{frame_bytes(kText, "\xff\xfe"), 1007},
             Case{frame_bytes(kBinary, "pages send texts"), 1003},
         }) {
        ServerOptions options;
        options.limits.linger_time = std::chrono::milliseconds(20);  // the client does not close
        RunningServer running(std::move(options));
        const auto client = running.open_socket();
        client->send(wrong.bytes);
        EXPECT_EQ(close_code_of(*client), wrong.code) << wrong.bytes;
        EXPECT_EQ(running.site.next_event(), "closed 1") << wrong.bytes;
    }
}

TEST(ServerSocket, HalfFrames_AreJoined) {
    RunningServer running;
    const auto client = running.open_socket();
    const std::string bytes = frame_bytes(kText, "hel", false) + frame_bytes(kPing, "now") +
                              frame_bytes(0, "lo") + frame_bytes(kText, "next");
    for (const char byte : bytes) {
        client->send(std::string(1, byte));
    }
    EXPECT_EQ(running.site.next_event(), "received 1 hello");
    EXPECT_EQ(running.site.next_event(), "received 1 next");
    const std::optional<Frame> pong = client->read_frame();
    ASSERT_TRUE(pong);
    EXPECT_EQ(pong->operation, kPong);
    EXPECT_EQ(pong->payload, "now");
}

TEST(ServerSocket, HalfFrameAndNoMore_ClosedByItsTimeLimit) {
    ServerOptions options;
    options.limits.socket_time = std::chrono::milliseconds(100);
    RunningServer running(std::move(options));
    const auto client = running.open_socket();
    client->send(frame_bytes(kText, "never complete").substr(0, 5));
    EXPECT_EQ(running.site.next_event(), "closed 1");  // it answers no ping either
}

TEST(ServerSocket, LostConnection_ClosesOnce) {
    RunningServer running;
    auto client = running.open_socket();
    client.reset();
    EXPECT_EQ(running.site.next_event(), "closed 1");
    client = running.open_socket();
    client->send(frame_bytes(kClose, "\x03\xe8"));
    EXPECT_EQ(close_code_of(*client), 1000);
    EXPECT_EQ(running.site.next_event(), "closed 2");
    running.stop();
}

TEST(ServerSocket, MoreThanAllowed_Refused) {
    RunningServer running;
    std::vector<std::unique_ptr<RawClient>> clients;
    for (int i = 0; i < 4; ++i) {
        clients.push_back(running.open_socket());
    }
    EXPECT_EQ(running.ask(running.upgrade(running.origin())).status, 503);
    EXPECT_EQ(running.ask(running.request("/main.js")).status, 200);  // files are still served
    clients.pop_back();
    EXPECT_EQ(running.site.next_event(), "closed 4");
    int status = 0;  // the place is free soon after
    while ((status = running.ask(running.upgrade(running.origin())).status) == 503) {
    }
    EXPECT_EQ(status, 101);
}

TEST(ServerSocket, PageThatDoesNotRead_GetsTheNewestOfASlotAndAllOthers) {
    RunningServer running;
    const auto client = running.open_socket(4096);
    // More than fits into the buffers of both sides, so that all that follows waits.
    running.server->send(1, {true, std::string(32 << 20, 'p'), ""});
    for (int i = 0; i < 1000; ++i) {
        running.server->send(1, {false, "state " + std::to_string(i), "state"});
        running.server->send(1, {true, "picture " + std::to_string(i), "picture"});
        if (i % 100 == 0) {
            running.server->send(1, {false, "all " + std::to_string(i), ""});
        }
    }
    running.server->send(1, {false, "end", ""});
    std::vector<std::string> texts;
    int states = 0;
    while (texts.empty() || texts.back() != "end") {
        const std::optional<Frame> frame = client->read_frame();
        ASSERT_TRUE(frame);
        if (frame->payload.starts_with("all") || frame->payload == "end") {
            texts.push_back(frame->payload);
        } else if (frame->payload.starts_with("state")) {
            ++states;
            EXPECT_EQ(frame->payload, "state 999");
        } else if (frame->payload.size() < 100) {
            EXPECT_EQ(frame->payload, "picture 999");
        }
    }
    EXPECT_EQ(states, 1);
    EXPECT_THAT(texts, ::testing::ElementsAre("all 0", "all 100", "all 200", "all 300", "all 400",
                                              "all 500", "all 600", "all 700", "all 800", "all 900",
                                              "end"));
}

TEST(ServerSocket, PageWithATooLongQueue_IsClosedAndOthersAreNot) {
    ServerOptions options;
    options.limits.waiting_messages = 10;
    RunningServer running(std::move(options));
    const auto stuck = running.open_socket(4096);
    const auto reading = running.open_socket();
    running.server->send(1, {true, std::string(32 << 20, 'p'), "picture"});
    for (int i = 0; i < 20; ++i) {
        running.server->send(1, {false, "text", ""});
    }
    EXPECT_EQ(running.site.next_event(), "closed 1");
    EXPECT_TRUE(stuck->is_closed_by_server());
    running.server->send(0, {false, "still here", ""});
    EXPECT_EQ(reading->read_frame()->payload, "still here");
}

TEST(ServerSocket, ManyThreads_MaySend) {
    RunningServer running;
    const auto client = running.open_socket();
    constexpr int kThreads = 4;
    constexpr int kMessages = 60;  // together fewer than may wait
    {
        std::vector<std::jthread> threads;
        for (int thread = 0; thread < kThreads; ++thread) {
            threads.emplace_back([&, thread] {
                for (int i = 0; i < kMessages; ++i) {
                    running.server->send(
                        0, {false, std::string(1, static_cast<char>('a' + thread)), ""});
                }
            });
        }
    }
    std::string received;
    for (int i = 0; i < kThreads * kMessages; ++i) {
        const std::optional<Frame> frame = client->read_frame();
        ASSERT_TRUE(frame);
        received += frame->payload;
    }
    for (int thread = 0; thread < kThreads; ++thread) {
        EXPECT_EQ(std::count(received.begin(), received.end(), 'a' + thread), kMessages);
    }
}

TEST(ServerSocket, EndOfTheServer_IsToldToPagesAndSite) {
    RunningServer running;
    const auto client = running.open_socket();
    running.stop();
    EXPECT_EQ(close_code_of(*client), 1001);
    EXPECT_TRUE(client->is_closed_by_server());
    EXPECT_EQ(running.site.next_event(), "closed 1");
}

}  // namespace
