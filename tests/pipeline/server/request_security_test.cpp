// Requests that a server must refuse or survive, over real sockets.
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/pipeline/server/running_server.h"

namespace {

using carom::testing::HttpAnswer;
using carom::testing::RawClient;
using carom::testing::RunningServer;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ServerRequest, PathsOutsideTheFiles_NotFound) {
    RunningServer running;
    for (const char* target :
         {"/../", "/../main.js", "/%2e%2e/main.js", "/%2e%2e%2fmain.js", "//main.js", "/./main.js",
          "/main.js/", "/.hidden", "/film/../main.js", "/film/.x", "/a\\b", "/a:b", "/%00",
          "/main.js%3Fraw", "/"}) {
        EXPECT_EQ(running.ask(running.request(target)).status, 404) << target;
    }
    EXPECT_THAT(running.site.asked_paths(), IsEmpty());                     // not even asked
    EXPECT_EQ(running.ask(running.request("/main.js?raw??")).status, 200);  // the query is ignored
    EXPECT_EQ(running.ask(running.request("/film/a-1_B.mp4")).status, 404);
    EXPECT_THAT(running.site.asked_paths(), ::testing::ElementsAre("/main.js", "/film/a-1_B.mp4"));
}

TEST(ServerRequest, OtherMethods_NotAllowed) {
    const RunningServer running;
    for (const char* method :
         {"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "CONNECT", "X"}) {
        EXPECT_EQ(running.ask(running.request("/main.js", "Content-Length: 0\r\n", method)).status,
                  405)
            << method;
    }
    EXPECT_EQ(
        running.ask(running.request("/main.js", "Content-Length: 5242880\r\n", "POST")).status,
        405);
}

TEST(ServerRequest, Head_LikeGetWithoutBody) {
    const RunningServer running;
    RawClient client(running.port());
    client.send(running.request("/main.js", "", "HEAD"));
    const HttpAnswer answer = client.read_answer(false);
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.field("Content-Length"), "16");
    client.send(running.request("/main.js"));  // the next answer follows at once
    EXPECT_EQ(client.read_answer().body, "let CAROM_NONCE;");
}

TEST(ServerRequest, SeveralInOneConnection_AreAnsweredInOrder) {
    const RunningServer running;
    RawClient client(running.port());
    client.send(running.request("/main.js") + running.request("/none") +
                running.request("/main.js", "Connection: close\r\n"));
    EXPECT_EQ(client.read_answer().status, 200);
    EXPECT_EQ(client.read_answer().status, 404);
    EXPECT_EQ(client.read_answer().status, 200);
    EXPECT_TRUE(client.is_closed_by_server());
}

TEST(ServerRequest, Body_Refused) {
    const RunningServer running;
    EXPECT_EQ(running.ask(running.request("/main.js", "Content-Length: 5\r\n") + "hello").status,
              413);
    EXPECT_EQ(running.ask(running.request("/main.js", "Content-Length: 5242880\r\n")).status, 413);
}

TEST(ServerRequest, TransferEncoding_Refused) {
    const RunningServer running;
    for (const char* encoding : {"chunked", "identity", "gzip, chunked", ""}) {
        const std::string line = "Transfer-Encoding: " + std::string(encoding) + "\r\n";
        EXPECT_EQ(running.ask(running.request("/main.js", line) + "0\r\n\r\n").status, 400)
            << encoding;
        EXPECT_EQ(
            running.ask(running.request("/main.js", line + "Content-Length: 3\r\n", "POST")).status,
            400)
            << encoding;
    }
}

TEST(ServerRequest, LongHeader_RefusedAndClosed) {
    const RunningServer running;
    RawClient client(running.port());
    client.send(running.request("/main.js", "X: " + std::string(20'000, 'a') + "\r\n"));
    EXPECT_EQ(client.read_answer().status, 431);
    EXPECT_TRUE(client.is_closed_by_server());
    EXPECT_EQ(
        running.ask(running.request("/main.js", "X: " + std::string(15'000, 'a') + "\r\n")).status,
        200);
}

TEST(ServerRequest, WhatIsNotHttp_RefusedAndClosed) {
    const RunningServer running;
    for (const std::string& bytes :
         {std::string("\x16\x03\x01 hello\r\n\r\n"), std::string("\r\n\r\n\r\n"),
          std::string("GET / HTTP/2.0\r\n\r\n"), std::string("GET /\r\n\r\n"),
          std::string("GET / HTTP/1.1\r\nHost : x\r\n\r\n"),
          std::string("GET / HTTP/1.1\r\nA: b\rC: d\r\n\r\n"), std::string(5, '\0') + "\r\n\r\n"}) {
        RawClient client(running.port());
        client.send(bytes);
        EXPECT_EQ(client.read_answer().status, 400) << bytes;
        EXPECT_TRUE(client.is_closed_by_server()) << bytes;
    }
    EXPECT_EQ(running.ask(running.request("/main.js")).status, 200);
}

TEST(ServerRequest, SlowRequest_ClosedByItsTimeLimit) {
    carom::server::ServerOptions options;
    options.limits.request_time = std::chrono::milliseconds(50);
    const RunningServer running(std::move(options));
    RawClient silent(running.port());
    RawClient slow(running.port());
    slow.send("GET / HTTP/1.1\r\nHos");
    EXPECT_TRUE(slow.is_closed_by_server());
    EXPECT_TRUE(silent.is_closed_by_server());
}

TEST(ServerRequest, ManyConnections_OneThatWaitsMakesRoom) {
    carom::server::ServerOptions options;
    options.limits.connections = 3;
    const RunningServer running(std::move(options));
    std::vector<std::unique_ptr<RawClient>> waiting;
    for (int i = 0; i < 3; ++i) {
        waiting.push_back(std::make_unique<RawClient>(running.port()));
        waiting.back()->send(running.request("/main.js"));
        EXPECT_EQ(waiting.back()->read_answer().status, 200);
    }
    EXPECT_EQ(running.ask(running.request("/main.js")).status, 200);
    EXPECT_TRUE(waiting.front()->is_closed_by_server());
}

// Half requests of a program without the key keep nobody out, and are closed soon.
TEST(ServerRequest, ManyHalfRequestsWithoutTheKey_KeepNobodyOut) {
    carom::server::ServerOptions options;
    options.limits.strangers = 8;
    const RunningServer running(std::move(options));
    std::vector<std::unique_ptr<RawClient>> half;
    const auto connect = [&](const char* bytes) {
        half.push_back(std::make_unique<RawClient>(running.port()));
        half.back()->send(bytes);
    };
    for (int i = 0; i < 40; ++i) {
        connect("GET / HTTP/1.1\r\nHos");
    }
    for (int i = 0; i < 20; ++i) {  // each comes after more of them
        EXPECT_EQ(running.ask(running.request("/main.js")).status, 200);
        EXPECT_EQ(running.ask(running.page_request("/main.js")).status, 200);
        EXPECT_EQ(running.ask(running.upgrade(running.origin())).status, 101);
        for (int j = 0; j < 8; ++j) {
            connect(j % 2 == 0 ? "" : "GET /");
        }
    }
    EXPECT_TRUE(half.front()->is_closed_by_server());
}

TEST(ServerRequest, ConnectionWithTheKey_IsNotDroppedForStrangers) {
    carom::server::ServerOptions options;
    options.limits.strangers = 2;
    const RunningServer running(std::move(options));
    RawClient known(running.port());
    known.send(running.request("/main.js"));
    EXPECT_EQ(known.read_answer().status, 200);
    std::vector<std::unique_ptr<RawClient>> strangers;
    for (int i = 0; i < 20; ++i) {
        strangers.push_back(std::make_unique<RawClient>(running.port()));
    }
    EXPECT_TRUE(strangers.front()->is_closed_by_server());
    known.send(running.request("/main.js"));
    EXPECT_EQ(known.read_answer().status, 200);
}

TEST(ServerRequest, SlowRequestWithoutTheKey_HasLessTime) {
    carom::server::ServerOptions options;
    options.limits.stranger_time = std::chrono::milliseconds(200);
    const RunningServer running(std::move(options));
    std::unique_ptr<RawClient> known;
    do {  // the client itself may be late on a busy machine
        known = std::make_unique<RawClient>(running.port());
        known->send(running.request("/main.js"));
    } while (known->read_answer().status != 200);
    RawClient slow(running.port());
    slow.send("GET / HTTP/1.1\r\nHos");
    EXPECT_TRUE(slow.is_closed_by_server());
    known->send(running.request("/main.js"));
    EXPECT_EQ(known->read_answer().status, 200);
}

TEST(ServerRequest, TooManyConnectionsAtWork_TheNextIsRefused) {
    carom::server::ServerOptions options;
    options.limits.connections = 3;
    const std::string big(64 << 20, 'x');
    const RunningServer running(
        std::move(options),
        {{"/big", {"text/plain", std::make_shared<const std::string>(big), ""}}});
    std::vector<std::unique_ptr<RawClient>> busy;
    for (int i = 0; i < 3; ++i) {  // none of them reads more than the first part of its answer
        busy.push_back(std::make_unique<RawClient>(running.port(), 4096));
        busy.back()->send(running.request("/big"));
        EXPECT_EQ(busy.back()->read_answer(false).status, 200);
    }
    RawClient refused(running.port());
    refused.send(running.request("/main.js"));
    EXPECT_EQ(refused.read_answer(false).status, 503);
    EXPECT_TRUE(refused.is_closed_by_server());
    busy.pop_back();
    int status = 0;  // 503 until the server sees that one has gone
    while ((status = running.ask(running.request("/main.js")).status) == 503 || status == 0) {
    }
    EXPECT_EQ(status, 200);
}

TEST(ServerRequest, ClientThatDoesNotRead_LosesItsConnection) {
    carom::server::ServerOptions options;
    options.limits.answer_time = std::chrono::milliseconds(50);
    options.limits.connections = 1;
    const std::string big(64 << 20, 'x');
    const RunningServer running(
        std::move(options),
        {{"/big", {"text/plain", std::make_shared<const std::string>(big), ""}}});
    RawClient stuck(running.port(), 4096);
    stuck.send(running.request("/big"));
    EXPECT_EQ(stuck.read_answer(false).status, 200);
    int status = 0;  // 503 until the time is over
    while ((status = running.ask(running.request("/main.js")).status) == 503 || status == 0) {
    }
    EXPECT_EQ(status, 200);
}

TEST(ServerRequest, OnlyLoopback_IsBound) {
    const RunningServer running;
    EXPECT_THAT(
        running.server->address(),
        ::testing::StartsWith("http://127.0.0.1:" + std::to_string(running.port()) + "/?key="));
    EXPECT_THROW(RawClient(running.port(), 0, "127.0.0.2"), std::runtime_error);
}

TEST(ServerRequest, PortInUse_IsAnError) {
    const RunningServer running;
    carom::server::ServerOptions options;
    options.port = running.port();
    carom::testing::RecordingSite site;
    try {
        const carom::server::Server second(std::move(options), site);
        FAIL();
    } catch (const carom::Error& error) {
        EXPECT_EQ(std::string(error.what()), "the server cannot listen on port " +
                                                 std::to_string(running.port()) +
                                                 ": Address already in use");
    }
}

TEST(ServerRequest, Idle_EndsTheServer) {
    carom::server::ServerOptions options;
    options.idle = std::chrono::milliseconds(20);
    RunningServer running(std::move(options));
    running.wait();
    EXPECT_THROW(RawClient(running.port()).send(""), std::runtime_error);
}

}  // namespace
